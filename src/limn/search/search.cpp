#include "limn/search/search.h"

#include <optional>
#include <set>
#include <utility>

namespace limn::search {
namespace {

/// A method that asks only for what it knows so many times in a row has come to its end.
constexpr int kMostIdle = 100;

/// Where the scheme's own number lies, exactly; nothing where it has none, or one outside.
std::optional<Rational> own_place(const Coordinate& one) {
  if (!one.own || *one.own < one.low || one.high < *one.own) return std::nullopt;
  return (*one.own - one.low) / (one.high - one.low);
}

SearchSpace space_of(const Study& study) {
  SearchSpace space;
  space.dimension = study.coordinates.size();
  space.objectives = study.objectives.size();
  for (const Coordinate& one : study.coordinates) {
    const std::optional<Rational> own = own_place(one);
    space.start.push_back(own ? snapped(to_double(*own)) : Rational(1, 2));
    space.steps.push_back(one.steps);
  }
  return space;
}

/// The multiple of 2^-kUnitBits next to a scheme's own number stands for that number: 3/8 may lie
/// beside them, and the scheme's properties with it.
UnitPoint with_own_numbers(const Study& study, UnitPoint unit) {
  for (std::size_t i = 0; i < unit.size(); ++i)
    if (const std::optional<Rational> own = own_place(study.coordinates[i]);
        own && unit[i] == snapped(to_double(*own)))
      unit[i] = *own;
  return unit;
}

}  // namespace

Result<Search> Search::begin(const Study& study) {
  Result<std::unique_ptr<Method>> method = make_method(study.method, space_of(study));
  if (!method) return method.error();
  return Search(study, *std::move(method));
}

Generation Search::next() {
  for (int idle = 0; idle < kMostIdle; ++idle) {
    if (told_ >= study_->method.points) return {};
    const std::vector<UnitPoint> batch = method_->next();
    if (batch.empty()) return {};
    asked_.clear();
    fresh_.clear();
    Generation generation{++generation_, {}};
    std::set<std::string> met;
    for (const UnitPoint& unit : batch) {
      Point point = point_at(*study_, with_own_numbers(*study_, unit));
      asked_.push_back(point_key(point));
      if (worth_.count(asked_.back()) > 0 || !met.insert(asked_.back()).second) continue;
      fresh_.push_back(asked_.back());
      generation.points.push_back(std::move(point));
    }
    if (!generation.points.empty()) return generation;
    tell({});
  }
  return {};
}

void Search::tell(const std::vector<Outcome>& outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    worth_[fresh_[i]] = fitness(*study_, outcomes[i]);
  told_ += static_cast<long long>(outcomes.size());
  std::vector<std::vector<double>> worth;
  for (const std::string& key : asked_) worth.push_back(worth_.at(key));
  method_->tell(worth);
}

}  // namespace limn::search
