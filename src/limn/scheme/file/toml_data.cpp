#include "limn/scheme/file/toml_data.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/near_word.h"
#include "limn/scheme/check.h"
#include "limn/scheme/stages.h"

namespace limn::scheme {
namespace {

constexpr int kLargestStatedValence = 9999;
constexpr std::int64_t kLongestStep = 8;

void read_valences(TomlReader& in, const toml::node& node, Fact& fact) {
  if (const auto* integer = node.as_integer()) {
    if (integer->get() <= kLargestStatedValence)
      fact.first = fact.last = static_cast<int>(std::max<std::int64_t>(integer->get(), 0));
  } else if (const auto* string = node.as_string()) {
    const std::string& text = string->get();
    const std::size_t dots = text.find("..");
    const auto digits = [](const std::string& s) {
      return !s.empty() && s.size() <= 4 && s.find_first_not_of("0123456789") == std::string::npos;
    };
    if (dots != std::string::npos && digits(text.substr(0, dots)) &&
        digits(text.substr(dots + 2))) {
      fact.first = std::stoi(text.substr(0, dots));
      fact.last = std::stoi(text.substr(dots + 2));
    }
  }
  if (fact.first < kSmallestValence || fact.last < fact.first)
    in.fail(node, fmt::format("a valence is an integer from {} to {}, or a range as \"3..12\"",
                              kSmallestValence, kLargestStatedValence));
}

void read_direction(TomlReader& in, const toml::node& node, Factors& factors) {
  std::optional<std::array<int, 2>> step;
  std::optional<Formula> count;
  const std::size_t before = in.faults();
  in.each(node, "a direction", [&](const toml::key& key, const toml::node& v) {
    if (key.str() == "count") {
      count = in.formula(v, "count");
    } else if (key.str() == "step") {
      const toml::array* pair = v.as_array();
      const bool good = pair != nullptr && pair->size() == 2 && (*pair)[0].is_integer() &&
                        (*pair)[1].is_integer();
      const auto entry = [&](std::size_t i) { return (*pair)[i].as_integer()->get(); };
      const auto small = [](std::int64_t i) { return i >= -kLongestStep && i <= kLongestStep; };
      if (!good || !small(entry(0)) || !small(entry(1)) || (entry(0) == 0 && entry(1) == 0)) {
        in.fail(v, fmt::format("a step is two integers from -{0} to {0}, not both 0, as [1, 0]",
                               kLongestStep));
        return;
      }
      step = {static_cast<int>(entry(0)), static_cast<int>(entry(1))};
    } else {
      in.unknown_key(key, "a direction", {"step", "count"});
    }
  });
  if (!in.unharmed_since(before)) return;
  if (!step || !count)
    in.fail(node, "a direction needs a step and a count, as { step = [1, 0], count = 2 }");
  else
    factors.directions.emplace_back(*step, *count);
}

/// A scheme that this one is said to be: shipped, so that its name means the same everywhere.
void check_shipped(TomlReader& in, const toml::node& node, const std::string& name) {
  const std::vector<std::string> known = shipped_schemes();
  if (!node.is_string() || std::find(known.begin(), known.end(), name) != known.end()) return;
  in.fail(node,
          name.empty() ? "same names no scheme"
                       : fmt::format("same: no shipped scheme is called '{}'", name),
          base::did_you_mean(name, known, "`limn schemes` lists the shipped ones"));
}

}  // namespace

std::optional<Lattice> read_lattice(TomlReader& in, const toml::node& node) {
  const std::string word = in.text(node, "lattice");
  if (word == "triangle") return Lattice::triangle;
  if (word == "quad") return Lattice::quad;
  if (node.is_string())
    in.fail(node, fmt::format("unknown lattice '{}'", word),
            base::did_you_mean(word, {"triangle", "quad"}, "expected \"triangle\" or \"quad\""));
  return std::nullopt;
}

Rows read_rows(TomlReader& in, const toml::node& node, std::string_view what) {
  Rows rows;
  rows.place = in.place(node);
  const std::size_t before = in.faults();
  in.each(node, what, [&](const toml::key& key, const toml::node& v) {
    if (key.str() == "scale") {
      rows.scale = in.formula(v, "scale");
    } else if (key.str() == "rows") {
      in.each_element(v, "rows", [&](const toml::node& row) {
        rows.rows.emplace_back();
        in.each_element(row, "a row", [&](const toml::node& entry) {
          rows.rows.back().push_back(in.formula(entry, "a coefficient"));
        });
      });
    } else {
      in.unknown_key(key, what, {"rows", "scale"});
    }
  });
  if (in.unharmed_since(before) && rows.rows.empty())
    in.fail(node, fmt::format("{} has no rows", what));
  return rows;
}

Factors read_factors(TomlReader& in, const toml::node& node) {
  Factors factors;
  factors.place = in.place(node);
  in.each(node, "factors", [&](const toml::key& key, const toml::node& v) {
    if (key.str() == "stages") {
      factors.stages = in.formula(v, "stages");
    } else if (key.str() == "kernel") {
      factors.kernel = read_rows(in, v, "kernel");
    } else if (key.str() == "directions") {
      in.each_element(v, "directions",
                      [&](const toml::node& d) { read_direction(in, d, factors); });
    } else {
      in.unknown_key(key, "factors", {"stages", "directions", "kernel"});
    }
  });
  return factors;
}

Stages read_stages(TomlReader& in, const toml::node& node,
                   const std::function<Rule(const toml::node&)>& read_pair) {
  Stages stages;
  stages.place = in.place(node);
  const auto weight = [&](std::string_view role, std::string_view value) {
    return Weight{
        std::string(role), pair_walk(role), {Expression::parse(value).value(), stages.place}};
  };
  stages.corner = weight("self", "1/n");
  stages.pair = {{std::nullopt,
                  {weight("self", "1/4"), weight("ring", "1/(2*n)"), weight("diagonal", "1/(4*n)")},
                  stages.place}};
  bool has_first = false, has_then = false, has_times = false, has_pair = false;
  const auto read_word = [&](const toml::node& v, std::string_view key,
                             const std::vector<std::string>& known) {
    std::string word = in.text(v, key);
    if (v.is_string() && std::find(known.begin(), known.end(), word) == known.end())
      in.fail(v, fmt::format("{} = '{}' is no stage that is known", key, word),
              base::did_you_mean(word, known,
                                 fmt::format("expected \"{}\"", fmt::join(known, "\" or \""))));
    return word;
  };
  const std::size_t before = in.faults();
  in.each(node, "stages", [&](const toml::key& key, const toml::node& v) {
    if (key.str() == "first") {
      if (read_word(v, "first", {std::string(kBilinear), std::string(kLinear)}) == kLinear)
        stages.first = Stages::First::linear;
      has_first = true;
    } else if (key.str() == "then") {
      read_word(v, "then", {std::string(kAverage)});
      has_then = true;
    } else if (key.str() == "times") {
      stages.times = in.formula(v, "times");
      has_times = true;
    } else if (key.str() == "pair") {
      stages.pair = read_pair(v);
      has_pair = true;
    } else {
      in.unknown_key(key, "stages", {"first", "then", "times", "pair"});
    }
  });
  if (in.unharmed_since(before) && !(has_first && has_then && has_times))
    in.fail(node, "stages needs first, then and times",
            fmt::format("as {{ first = \"{}\", then = \"{}\", times = \"degree - 1\" }}", kBilinear,
                        kAverage));
  if (in.unharmed_since(before) && stages.first == Stages::First::linear && !has_pair)
    in.fail(node, "stages that begin linearly need a pair",
            "what two averagings make of a vertex of n edges and q quads, as pair = { self = …, "
            "ring = …, diagonal = … }");
  return stages;
}

void read_fact(TomlReader& in, const toml::node& node, Scheme& scheme) {
  Fact fact;
  Equivalence same;
  fact.place = same.place = in.place(node);
  bool states_mask = false;
  const std::size_t before = in.faults();
  in.each(node, "a fact", [&](const toml::key& key, const toml::node& v) {
    const std::string_view name = key.str();
    if (name == "valence") {
      read_valences(in, v, fact);
    } else if (name == "source") {
      fact.source = in.text(v, name);
    } else if (name == "mask") {
      if (scheme.stated_mask) in.fail(v, "the facts state the mask twice");
      scheme.stated_mask = read_rows(in, v, name);
      states_mask = true;
    } else if (name == "lattice") {
      fact.lattice = read_lattice(in, v);
    } else if (name == "tangent" || name == "cup" || name == "saddle") {
      fact.values.emplace_back(name, in.formula(v, name));
    } else if (name == "same") {
      same.scheme = in.text(v, name);
      check_shipped(in, v, same.scheme);
    } else if (name == "with") {
      in.each(v, name, [&](const toml::key& parameter, const toml::node& value) {
        same.with.emplace_back(parameter.str(), in.formula(value, parameter.str()));
      });
    } else {
      in.unknown_key(
          key, "a fact",
          {"valence", "lattice", "tangent", "cup", "saddle", "mask", "same", "with", "source"});
    }
  });
  if (!in.unharmed_since(before)) return;
  if (same.scheme.empty() && !same.with.empty())
    in.fail(node, "the fact sets parameters of no scheme", "add same = \"NAME\"");
  else if (!fact.values.empty() && fact.first == 0)
    in.fail(node, "the fact names no valence", "add valence = 7 or valence = \"3..12\"");
  else if (fact.values.empty() && !states_mask && same.scheme.empty())
    in.fail(node, "the fact states nothing", "add tangent, cup, saddle, mask or same");
  same.source = fact.source;
  if (!same.scheme.empty()) scheme.equivalences.push_back(std::move(same));
  if (!fact.values.empty()) scheme.facts.push_back(std::move(fact));
}

}  // namespace limn::scheme
