#include "limn/search/method.h"

#ifdef LIMN_HAS_PAGMO
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#endif

namespace limn::search {

#ifdef LIMN_HAS_PAGMO
namespace {

using Vector = pagmo::vector_double;

/// What pagmo's algorithms ask, and what they are answered.
struct Talk {
  bool listening = false;       ///< points are noted down, and answered with zeros
  std::vector<Vector> asked;    ///< while listening
  std::vector<Vector> answers;  ///< otherwise, one after the other
  std::size_t at = 0;
};

/// A problem of pagmo whose values come from outside.
struct Outside {
  std::shared_ptr<Talk> talk;
  std::size_t dimension = 1, objectives = 1;

  [[nodiscard]] Vector fitness(const Vector& x) const {
    if (!talk->listening && talk->at < talk->answers.size()) return talk->answers[talk->at++];
    talk->asked.push_back(x);
    return Vector(objectives, 0.0);
  }
  [[nodiscard]] Vector::size_type get_nobj() const { return objectives; }
  [[nodiscard]] std::pair<Vector, Vector> get_bounds() const {
    return {Vector(dimension, 0.0), Vector(dimension, 1.0)};
  }
};

/// Both algorithms make all points of a generation before they use a value of one. So a generation
/// is run twice from the same state: once to hear which points it has, then with their values.
class Evolution : public Method {
 public:
  Evolution(const MethodChoice& choice, const SearchSpace& space)
      : talk_(std::make_shared<Talk>()),
        population_(pagmo::problem(Outside{talk_, space.dimension, space.objectives}), 0,
                    static_cast<unsigned>(choice.seed)),
        algorithm_(made(choice, space)),
        first_{space.start} {
    for (UnitPoint& point :
         sobol_points(space.dimension, static_cast<std::size_t>(choice.batch) - 1))
      first_.push_back(std::move(point));
  }

  std::vector<UnitPoint> next() override {
    if (population_.size() == 0) return first_;
    talk_->listening = true;
    talk_->asked.clear();
    const pagmo::algorithm copy = algorithm_;
    (void)copy.evolve(population_);
    std::vector<UnitPoint> points;
    for (const Vector& x : talk_->asked) {
      UnitPoint point;
      for (const double u : x) point.push_back(snapped(u));
      points.push_back(std::move(point));
    }
    return points;
  }

  void tell(const std::vector<std::vector<double>>& worth) override {
    if (population_.size() == 0) {
      for (std::size_t i = 0; i < first_.size(); ++i) {
        Vector x;
        for (const Rational& u : first_[i]) x.push_back(to_double(u));
        population_.push_back(x, worth[i]);
      }
      return;
    }
    talk_->listening = false;
    talk_->answers = worth;
    talk_->at = 0;
    population_ = algorithm_.evolve(population_);
  }

 private:
  static pagmo::algorithm made(const MethodChoice& choice, const SearchSpace& space) {
    const auto seed = static_cast<unsigned>(choice.seed);
    if (choice.kind == MethodKind::pareto)
      return pagmo::algorithm(
          pagmo::nsga2(1, 0.95, 10., 1. / static_cast<double>(space.dimension), 20., seed));
    // automatic coefficients, first step 0.3, a memory of what it has learnt, within the bounds
    return pagmo::algorithm(pagmo::cmaes(1, -1, -1, -1, -1, 0.3, 1e-7, 1e-10, true, true, seed));
  }

  std::shared_ptr<Talk> talk_;
  pagmo::population population_;
  pagmo::algorithm algorithm_;
  std::vector<UnitPoint> first_;
};

}  // namespace

Result<std::unique_ptr<Method>> make_evolution(const MethodChoice& choice,
                                               const SearchSpace& space) {
  return std::unique_ptr<Method>(std::make_unique<Evolution>(choice, space));
}

#else

Result<std::unique_ptr<Method>> make_evolution(const MethodChoice&, const SearchSpace&) {
  return Error{"limn was built without pagmo, which the methods global and pareto need",
               "take another method, or build with libpagmo-dev"};
}

#endif

}  // namespace limn::search
