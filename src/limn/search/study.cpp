#include "limn/search/study.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/files/file.h"
#include "limn/scheme/file/scheme_files.h"
#include "limn/search/study_reader.h"

namespace limn::search {
namespace {

constexpr std::uint64_t kMostBytes = 1 << 18;

constexpr std::array<std::string_view, 6> kMethods{"grid",  "random", "sobol",
                                                   "local", "global", "pareto"};

}  // namespace

std::string_view to_string(MethodKind kind) { return kMethods[static_cast<std::size_t>(kind)]; }

std::string Coordinate::label() const {
  return valence ? fmt::format("{}@{}", name, *valence) : name;
}

Result<Study> read_study(const std::string& path) {
  const Result<std::string> text = base::read_file(path, {.bytes = kMostBytes, .pipes = true});
  if (!text) return text.error();
  return parse_study(*text, path);
}

std::string Study::identity() const {
  std::string all = "limn study 1\n";
  for (const SourceText& source : scheme.texts) all += source.text + "\n";
  for (const Parameter& parameter : scheme.parameters)
    all += parameter.name + "=" + parameter.value.expression.text() + "\n";
  all += fmt::format("valences {}\n", fmt::join(valences, " "));
  for (const Coordinate& one : coordinates)
    all += fmt::format("free {} {} {} {}\n", one.label(), to_string(one.low), to_string(one.high),
                       one.steps);
  for (const Objective& one : objectives)
    all += fmt::format("{} {}\n{}\n", one.maximise ? "max" : "min", one.value.text(),
                       one.value.content());
  for (const Demand& one : demands)
    all += fmt::format("require {} {}\n{}\n", one.text, one.certified,
                       one.value ? one.value->content() : "");
  all += fmt::format("method {} {} {}\n", to_string(method.kind), method.seed, method.batch);
  all += fmt::format("effort {} {} {}\n", effort.regularity, effort.tolerance,
                     effort.certificate_parts);
  return all;
}

certify::CertifyOptions Study::certify_options() const {
  certify::CertifyOptions options;
  options.most_parts = effort.certificate_parts;
  options.most_products = effort.certificate_parts;
  options.curvature = std::any_of(demands.begin(), demands.end(), [](const Demand& demand) {
    return demand.certified && demand.at_vertices &&
           demand.at_vertices->relation == Relation::bounded_curvature;
  });
  return options;
}

std::vector<std::string> Study::files() const {
  std::vector<std::string> list = scheme_files(scheme);
  const auto add = [&list](const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
  };
  for (const Objective& one : objectives) add(one.value.files());
  for (const Demand& one : demands)
    if (one.value) add(one.value->files());
  for (const Landmark& one : landmarks) add(scheme_files(one.scheme));
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

}  // namespace limn::search
