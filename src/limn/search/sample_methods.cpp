#include <algorithm>
#include <boost/random/sobol.hpp>
#include <random>

#include "limn/search/method.h"

namespace limn::search {
namespace {

/// Methods that do not look at what they are told: the points are made one after the other.
template <class Next>
class Samples : public Method {
 public:
  Samples(const MethodChoice& choice, Next next)
      : left_(choice.points), batch_(choice.batch), next_(std::move(next)) {}

  std::vector<UnitPoint> next() override {
    std::vector<UnitPoint> points;
    for (; left_ > 0 && points.size() < static_cast<std::size_t>(batch_); --left_)
      points.push_back(next_());
    return points;
  }
  void tell(const std::vector<std::vector<double>>&) override {}

 private:
  long long left_;
  int batch_;
  Next next_;
};

template <class Next>
std::unique_ptr<Method> samples(const MethodChoice& choice, Next next) {
  return std::make_unique<Samples<Next>>(choice, std::move(next));
}

Rational from_bits(std::uint64_t high_bits) {
  return {Integer(static_cast<long long>(high_bits >> (64 - kUnitBits))), Integer(1 << kUnitBits)};
}

/// Points of a Sobol sequence one after the other.
class Sobol {
 public:
  explicit Sobol(std::size_t dimension) : dimension_(dimension), engine_(dimension) {
    engine_.discard(dimension);  // the centre; Boost leaves out the corner
  }
  UnitPoint operator()() {
    UnitPoint point;
    for (std::size_t i = 0; i < dimension_; ++i) point.push_back(from_bits(engine_()));
    return point;
  }

 private:
  std::size_t dimension_;
  boost::random::sobol engine_;  // of 64 bits
};

}  // namespace

std::unique_ptr<Method> make_grid(const MethodChoice& choice, const SearchSpace& space) {
  return samples(choice, [steps = space.steps, at = 0LL]() mutable {
    UnitPoint point(steps.size());
    long long rest = at++;
    for (std::size_t i = steps.size(); i-- > 0; rest /= steps[i])
      point[i] = Rational(Integer(rest % steps[i]), Integer(steps[i] - 1));
    return point;
  });
}

std::unique_ptr<Method> make_random(const MethodChoice& choice, const SearchSpace& space) {
  return samples(choice, [random = std::mt19937_64(choice.seed), n = space.dimension]() mutable {
    UnitPoint point;
    for (std::size_t i = 0; i < n; ++i) point.push_back(from_bits(random()));
    return point;
  });
}

Result<std::unique_ptr<Method>> make_sobol(const MethodChoice& choice, const SearchSpace& space) {
  return samples(choice, Sobol(space.dimension));
}

std::vector<UnitPoint> sobol_points(std::size_t dimension, std::size_t count) {
  Sobol sequence(dimension);
  std::vector<UnitPoint> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(sequence());
  return points;
}

}  // namespace limn::search
