#include <array>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "limn/search/study_reader.h"

// How a study is searched: its method, its effort, the schemes that are drawn beside.

namespace limn::search {
namespace {

constexpr long long kMostPoints = 10'000'000;
constexpr int kMostBatch = 4096;
constexpr std::array kMethodKinds = {MethodKind::grid,  MethodKind::random, MethodKind::sobol,
                                     MethodKind::local, MethodKind::global, MethodKind::pareto};

}  // namespace

void StudyReader::read_method(const toml::node& node) {
  MethodChoice& method = study_.method;
  in_.each(node, "[method]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "kind") {
      const std::size_t before = in_.faults();
      const std::string name = in_.text(entry, "kind");
      for (const MethodKind kind : kMethodKinds)
        if (to_string(kind) == name) {
          method.kind = kind;
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

void StudyReader::read_effort(const toml::node& node) {
  in_.each(node, "[effort]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "regularity") {
      study_.effort.regularity = static_cast<int>(
          read_whole(entry, "regularity", 1, 1'000'000).value_or(study_.effort.regularity));
    } else if (key == "tolerance") {
      const std::optional<double> value = read_bound(entry);
      if (value && !(*value > 0 && *value <= 1))
        in_.fail(entry, "tolerance is a number above 0, at most 1");
      study_.effort.tolerance = value.value_or(study_.effort.tolerance);
    } else if (key == "certificate") {
      study_.effort.certificate_parts =
          static_cast<int>(read_whole(entry, "certificate", 1, 10'000'000)
                               .value_or(study_.effort.certificate_parts));
    } else {
      in_.unknown_key(key, "[effort]", {"regularity", "tolerance", "certificate"});
    }
  });
}

void StudyReader::read_landmark(const toml::node& node) {
  const std::size_t before = in_.faults();
  const toml::node* scheme = nullptr;
  const toml::node* parameters = nullptr;
  std::string label;
  in_.each(node, "[[compare]]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "scheme")
      scheme = &entry;
    else if (key == "parameters")
      parameters = &entry;
    else if (key == "label")
      label = in_.text(entry, "label");
    else
      in_.unknown_key(key, "[[compare]]", {"scheme", "parameters", "label"});
  });
  if (!in_.unharmed_since(before)) return;
  if (scheme == nullptr) return in_.fail(node, "[[compare]] needs scheme");
  std::optional<Scheme> found = scheme_named(scheme, parameters);
  if (!found) return;
  if (label.empty()) label = found->name;
  study_.landmarks.push_back({std::move(label), std::move(*found)});
}

}  // namespace limn::search
