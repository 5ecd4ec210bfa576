#include "limn/search/study.h"

#include <array>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/files/file.h"
#include "limn/search/study_reader.h"

namespace limn {
namespace {

constexpr std::uint64_t kMostBytes = 1 << 18;
constexpr long long kMostPoints = 10'000'000;
constexpr int kMostBatch = 4096;

struct MethodName {
  std::string_view name;
  MethodKind kind;
};
constexpr std::array<MethodName, 6> kMethods{{{"grid", MethodKind::grid},
                                              {"random", MethodKind::random},
                                              {"sobol", MethodKind::sobol},
                                              {"local", MethodKind::local},
                                              {"global", MethodKind::global},
                                              {"pareto", MethodKind::pareto}}};

}  // namespace

std::string_view to_string(MethodKind kind) {
  return kMethods[static_cast<std::size_t>(kind)].name;
}

std::string Coordinate::label() const {
  return valence ? fmt::format("{}@{}", name, *valence) : name;
}

void StudyReader::read_method(const toml::node& node) {
  MethodChoice& method = study_.method;
  in_.each(node, "[method]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "kind") {
      const std::size_t before = in_.faults();
      const std::string name = in_.text(entry, "kind");
      for (const MethodName& one : kMethods)
        if (one.name == name) {
          method.kind = one.kind;
          return;
        }
      if (in_.unharmed_since(before))
        in_.fail(entry, fmt::format("unknown method '{}'", name),
                 "expected grid, random, sobol, local, global or pareto");
    } else if (key == "seed") {
      method.seed =
          static_cast<std::uint64_t>(read_whole(entry, "seed", 0, 4'294'967'295LL).value_or(1));
    } else if (key == "points") {
      method.points = read_whole(entry, "points", 1, kMostPoints).value_or(1);
    } else if (key == "batch") {
      method.batch = static_cast<int>(read_whole(entry, "batch", 1, kMostBatch).value_or(1));
    } else {
      in_.unknown_key(key, "[method]", {"kind", "seed", "points", "batch"});
    }
  });
}

void StudyReader::check_method(const toml::node& file, const toml::node* method) {
  const toml::node& at = method != nullptr ? *method : file;
  if (study_.coordinates.empty())
    return in_.fail(file, "nothing is free", "add [[free]] with name, low and high");
  if (study_.objectives.empty())
    return in_.fail(file, "there is no objective", "add [[objective]] with value and goal");
  const std::size_t objectives = study_.objectives.size();
  const MethodChoice& choice = study_.method;
  const bool one = choice.kind == MethodKind::local || choice.kind == MethodKind::global;
  if (one && objectives != 1)
    return in_.fail(
        at, fmt::format("method {} has one objective, not {}", to_string(choice.kind), objectives),
        "take pareto, or bound the others by [[require]]");
  if (choice.kind == MethodKind::pareto &&
      (objectives < 2 || choice.batch < 8 || choice.batch % 4 != 0))
    return in_.fail(at, "method pareto needs two objectives or more, and a batch of 8, 12, 16, …");
  if (choice.kind == MethodKind::global && choice.batch < 5)
    return in_.fail(at, "method global needs a batch of 5 or more");
  if (choice.kind != MethodKind::grid) return;
  double count = 1;
  for (const Coordinate& coordinate : study_.coordinates) {
    if (coordinate.steps == 0)
      return in_.fail(at, fmt::format("method grid needs steps of '{}'", coordinate.label()),
                      "add steps = 9 to its [[free]]");
    count *= coordinate.steps;
  }
  if (count > kMostPoints)
    return in_.fail(at,
                    fmt::format("the grid has {:.3g} points, more than {}", count, kMostPoints));
  study_.method.points = static_cast<long long>(count);
}

Result<Study> read_study(const std::string& path) {
  const Result<std::string> text = read_file(path, {.bytes = kMostBytes, .pipes = true});
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

}  // namespace limn
