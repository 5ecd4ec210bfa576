#include "limn/scheme/stages.h"

#include <cassert>

#include <fmt/core.h>

#include "limn/number/exact.h"
#include "limn/scheme/check.h"
#include "limn/scheme/scope.h"

namespace limn::scheme {

Walk pair_walk(std::string_view role) {
  for (const NamedRole& named : named_roles(RuleKind::vertex, Lattice::quad))
    if (named.name == role) return parse_walk(named.walk).value();
  assert(false);
  return {};
}

const Split* split_of_stages(const Stages& stages) {
  if (stages.is_mixed()) return find_split("quad-triangle");
  if (stages.only == Lattice::triangle) return find_split("triangle-dyadic");
  return find_split(stages.count % 2 == 0 ? "quad-dyadic" : "quad-dual");
}

void restrict_stages(Scheme& scheme, Lattice lattice) {
  scheme.stages->only = lattice;
  std::erase_if(scheme.lets, [](const auto& let) { return let.first == kQuads; });
  const std::string_view quads = lattice == Lattice::triangle ? "0" : "n";
  scheme.lets.emplace_back(kQuads, Formula{Expression::parse(quads).value(), {}});
}

Status settle_stages(Scheme& scheme) {
  Stages& stages = *scheme.stages;
  const bool linear = stages.first == Stages::First::linear;
  scheme.split = split_of_stages(stages);  // before they are counted: ranges depend on it
  if (Status status = check_ranges(scheme); !status) return status;
  const Result<number::Exact> value =
      Scope<number::Exact>(scheme, std::nullopt, std::nullopt)(stages.times);
  if (!value) return value.error();
  const bool whole = value->is_rational() && is_integer(value->rational());
  const bool odd = whole && linear && numerator(value->rational()) % 2 != 0;
  if (!whole || odd || value->rational() < 0 || value->rational() > kMostAveragings) {
    const Place& place = stages.times.place;
    const std::string& text = stages.times.expression.text();
    const std::string number = value->is_rational() ? to_string(value->rational())
                                                    : fmt::format("about {:.6g}", value->approx());
    return Error{fmt::format("stages: times = {}{} is no number of averagings", text,
                             text == number ? "" : ", which is " + number + ","),
                 odd ? "expected an even one: after a linear cut values are to end at vertices"
                     : fmt::format("expected an integer from 0 to {}", kMostAveragings),
                 place.file, place.line, place.column};
  }
  stages.count = numerator(value->rational()).convert_to<int>();
  scheme.split = split_of_stages(stages);
  return Done{};
}

}  // namespace limn::scheme
