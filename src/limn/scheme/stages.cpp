#include "limn/scheme/stages.h"

#include <cassert>

#include <fmt/core.h>

#include "limn/number/exact.h"
#include "limn/scheme/scope.h"

namespace limn {

Walk pair_walk(std::string_view role) {
  for (const NamedRole& named : named_roles(RuleKind::vertex, Lattice::quad))
    if (named.name == role) return parse_walk(named.walk).value();
  assert(false);
  return {};
}

Status settle_stages(Scheme& scheme) {
  Stages& stages = *scheme.stages;
  const Result<Exact> value = Scope<Exact>(scheme, std::nullopt, std::nullopt)(stages.times);
  if (!value) return value.error();
  const bool whole = value->is_rational() && is_integer(value->rational());
  if (!whole || value->rational() < 0 || value->rational() > kMostAveragings) {
    const Place& place = stages.times.place;
    const std::string& text = stages.times.expression.text();
    const std::string number = value->is_rational() ? to_string(value->rational())
                                                    : fmt::format("about {:.6g}", value->approx());
    return Error{fmt::format("stages: times = {}{} is no number of averagings", text,
                             text == number ? "" : ", which is " + number + ","),
                 fmt::format("expected an integer from 0 to {}", kMostAveragings), place.file,
                 place.line, place.column};
  }
  stages.count = numerator(value->rational()).convert_to<int>();
  scheme.split = find_split(stages.count % 2 == 0 ? "quad-dyadic" : "quad-dual");
  return Done{};
}

}  // namespace limn
