#include <algorithm>
#include <cmath>

#include "limn/search/method.h"

#ifdef LIMN_HAS_NLOPT
#include <nlopt.h>
#endif

namespace limn::search {

#ifdef LIMN_HAS_NLOPT
namespace {

constexpr double kCloseEnough = 1e-6;  // of the range; points are told apart by 2^-kUnitBits
constexpr double kFirstStep = 0.1;

/// One search downhill. NLopt asks for values when it pleases and keeps the thread, so the search
/// is run from its start each time, with the values that are known, until it asks for one that is
/// not: what NLopt does with them is nothing beside an evaluation.
class Descent {
 public:
  explicit Descent(std::vector<double> start) : start_(std::move(start)) {}

  /// The point whose value it needs; nothing: it is done.
  std::optional<std::vector<double>> next() {
    at_ = 0;
    wanted_.reset();
    const auto n = static_cast<unsigned>(start_.size());
    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(NLOPT_LN_SBPLX, n),
                                                                   nlopt_destroy);
    search_ = search.get();
    nlopt_set_min_objective(search_, &Descent::value, this);
    nlopt_set_lower_bounds1(search_, 0);
    nlopt_set_upper_bounds1(search_, 1);
    nlopt_set_initial_step1(search_, kFirstStep);
    nlopt_set_xtol_abs1(search_, kCloseEnough);
    std::vector<double> x = start_;
    double least = 0;
    nlopt_optimize(search_, x.data(), &least);
    return wanted_;
  }
  void tell(double value) { known_.push_back(value); }

 private:
  static double value(unsigned n, const double* x, double*, void* opaque) {
    Descent& self = *static_cast<Descent*>(opaque);
    if (self.at_ < self.known_.size()) return self.known_[self.at_++];
    if (!self.wanted_) self.wanted_ = std::vector<double>(x, x + n);
    nlopt_force_stop(self.search_);
    return HUGE_VAL;
  }

  std::vector<double> start_, known_;
  std::size_t at_ = 0;
  std::optional<std::vector<double>> wanted_;
  nlopt_opt search_ = nullptr;
};

class Local : public Method {
 public:
  Local(const MethodChoice& choice, const SearchSpace& space) {
    std::vector<UnitPoint> starts{space.start};
    for (UnitPoint& point :
         sobol_points(space.dimension, static_cast<std::size_t>(choice.batch) - 1))
      starts.push_back(std::move(point));
    for (const UnitPoint& start : starts) {
      std::vector<double> x;
      for (const Rational& u : start) x.push_back(to_double(u));
      descents_.emplace_back(std::move(x));
    }
  }

  std::vector<UnitPoint> next() override {
    asked_.clear();
    std::vector<UnitPoint> points;
    for (Descent& descent : descents_) {
      const std::optional<std::vector<double>> x = descent.next();
      if (!x) continue;
      asked_.push_back(&descent);
      UnitPoint point;
      for (const double u : *x) point.push_back(snapped(u));
      points.push_back(std::move(point));
    }
    return points;
  }
  void tell(const std::vector<std::vector<double>>& worth) override {
    for (std::size_t i = 0; i < worth.size(); ++i) asked_[i]->tell(worth[i].front());
  }

 private:
  std::vector<Descent> descents_;
  std::vector<Descent*> asked_;
};

}  // namespace

Result<std::unique_ptr<Method>> make_local(const MethodChoice& choice, const SearchSpace& space) {
  return std::unique_ptr<Method>(std::make_unique<Local>(choice, space));
}

#else

Result<std::unique_ptr<Method>> make_local(const MethodChoice&, const SearchSpace&) {
  return Error{"limn was built without NLopt, which local searches need",
               "take another method, or build with libnlopt-dev"};
}

#endif

}  // namespace limn::search
