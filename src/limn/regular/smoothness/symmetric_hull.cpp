#include "limn/regular/smoothness/symmetric_hull.h"

#include <algorithm>
#include <cmath>

#include "limn/regular/smoothness/rounding.h"

namespace limn::regular {
namespace {

constexpr double kIndependent = 1e-3;
constexpr double kOptimal = 1e-11;  // of the greatest |y·v| beyond 1
constexpr double kPivot = 1e-7;     // relative size of what may leave a basis
constexpr double kSlack = 1e-12;
constexpr double kAside = 1e-9;  // how far from u the search runs
constexpr double kGolden = 0.6180339887498949;
constexpr double kAccurate = 1e-14;
constexpr int kRefactor = 40;  // updates of the inverse before it is made anew

double sign(double x) { return x < 0 ? -1 : 1; }

}  // namespace

SymmetricHull::SymmetricHull(Eigen::Index dimension)
    : dimension_(dimension), points_(dimension, 64), directions_(dimension, 0) {}

bool SymmetricHull::leaves_span(const Eigen::VectorXd& v) const {
  Eigen::VectorXd rest = v - directions_ * (directions_.transpose() * v);
  rest -= directions_ * (directions_.transpose() * rest);
  return rest.norm() > kIndependent * (count_ == 0 ? v.norm() : longest_);
}

void SymmetricHull::add(const Eigen::VectorXd& v) {
  if (count_ == points_.cols()) points_.conservativeResize(Eigen::NoChange, 2 * count_);
  points_.col(count_) = v;
  if (!spans() && leaves_span(v)) {
    longest_ = std::max(longest_, v.norm());
    Eigen::VectorXd rest = v - directions_ * (directions_.transpose() * v);
    rest -= directions_ * (directions_.transpose() * rest);
    directions_.conservativeResize(Eigen::NoChange, directions_.cols() + 1);
    directions_.rightCols(1) = rest.normalized();
    basis_.push_back(count_);
  }
  ++count_;
}

void SymmetricHull::prefer(const std::vector<Eigen::Index>& points) {
  preferred_ = points;
  preferred_points_.resize(dimension_, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    preferred_points_.col(static_cast<Eigen::Index>(i)) = points_.col(points[i]);
}

/// A basis, the inverse of its matrix, and u in it. The search runs on a vector next to u whose
/// coordinates do not vanish, lest it go round in circles; a basis that is best for it is for u
/// too.
struct SymmetricHull::Tableau {
  const SymmetricHull& hull;
  const Eigen::VectorXd& u;
  Eigen::VectorXd next_to_u;
  Basis basis;
  Eigen::MatrixXd inverse;
  Eigen::VectorXd c;          // of u
  Eigen::VectorXd searching;  // of next_to_u
  int updates = 0;

  Tableau(const SymmetricHull& of, const Eigen::VectorXd& vector, const Start& begin)
      : hull(of), u(vector), next_to_u(vector), basis(begin.basis), inverse(begin.inverse) {
    c = inverse * u;
    refine();
    const double size = kAside * c.lpNorm<1>() / static_cast<double>(hull.dimension_);
    double part = 0;
    for (Eigen::Index i = 0; i < hull.dimension_; ++i) {
      part = std::fmod(part + kGolden, 1.0);
      next_to_u +=
          size * (1 + part) * sign(c(i)) * hull.points_.col(basis[static_cast<std::size_t>(i)]);
    }
    searching = inverse * next_to_u;
  }

  void factorise() {
    inverse = hull.matrix_of(basis).inverse();
    c = inverse * u;
    refine();
    searching = inverse * next_to_u;
    updates = 0;
  }

  /// What c leaves of u.
  [[nodiscard]] Eigen::VectorXd rest() const {
    Eigen::VectorXd rest = u;
    for (Eigen::Index i = 0; i < hull.dimension_; ++i)
      rest -= c(i) * hull.points_.col(basis[static_cast<std::size_t>(i)]);
    return rest;
  }
  void refine() { c += inverse * rest(); }

  /// Whether c still gives u, perhaps after a correction; true where nothing can be mended.
  [[nodiscard]] bool is_accurate() {
    if (updates == 0) return true;
    double sizes = u.lpNorm<Eigen::Infinity>();
    for (Eigen::Index i = 0; i < hull.dimension_; ++i)
      sizes = std::max(
          sizes,
          std::abs(c(i)) *
              hull.points_.col(basis[static_cast<std::size_t>(i)]).lpNorm<Eigen::Infinity>());
    const auto fits = [&] { return rest().lpNorm<Eigen::Infinity>() <= kAccurate * sizes; };
    if (fits()) return true;
    refine();
    return fits();
  }

  /// The point v with the greatest |y·v|, where y·v = ±1 on the signed basis: of the preferred ones
  /// if that exceeds 1, else of all.
  struct Farthest {
    Eigen::Index point;
    double height;  // signed
    bool of_all;
  };
  [[nodiscard]] Farthest farthest() const {
    const Eigen::VectorXd y = inverse.transpose() * searching.unaryExpr(&sign);
    Eigen::Index at = 0;
    if (!hull.preferred_.empty()) {
      const Eigen::RowVectorXd heights = y.transpose() * hull.preferred_points_;
      heights.cwiseAbs().maxCoeff(&at);
      if (std::abs(heights(at)) > 1 + kOptimal)
        return {hull.preferred_[static_cast<std::size_t>(at)], heights(at), false};
    }
    const Eigen::RowVectorXd heights = y.transpose() * hull.points();
    heights.cwiseAbs().maxCoeff(&at);
    return {at, heights(at), true};
  }

  /// The coordinate that first reaches 0 when `way` is taken away; of several that do so
  /// at about the same time that which leaves the best conditioned basis (Harris). -1: none.
  [[nodiscard]] Eigen::Index leaving_by(const Eigen::VectorXd& way) const {
    const double least = kPivot * way.lpNorm<Eigen::Infinity>();
    const double slack = kSlack * searching.lpNorm<Eigen::Infinity>();
    double length = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < way.size(); ++i)
      if (const double towards = way(i) * sign(searching(i)); towards > least)
        length = std::min(length, (std::abs(searching(i)) + slack) / towards);
    Eigen::Index leaving = -1;
    double pivot = 0;
    for (Eigen::Index i = 0; i < way.size(); ++i)
      if (const double towards = way(i) * sign(searching(i));
          towards > least && std::abs(searching(i)) <= length * towards && towards > pivot) {
        leaving = i;
        pivot = towards;
      }
    return leaving;
  }

  /// Brings a point into the basis; false where nothing would leave.
  bool exchange(Eigen::Index point, double height) {
    const Eigen::VectorXd column = inverse * hull.points_.col(point);
    const Eigen::Index leaving = leaving_by(column * sign(height));
    if (leaving < 0) return false;
    basis[static_cast<std::size_t>(leaving)] = point;
    if (++updates == kRefactor) {
      factorise();
      return true;
    }
    const Eigen::RowVectorXd row = inverse.row(leaving) / column(leaving);
    inverse.noalias() -= column * row;
    inverse.row(leaving) = row;
    for (Eigen::VectorXd* coordinates : {&c, &searching}) {
      const double length = (*coordinates)(leaving) / column(leaving);
      *coordinates -= length * column;
      (*coordinates)(leaving) = length;
    }
    return true;
  }
};

Eigen::MatrixXd SymmetricHull::matrix_of(const Basis& basis) const {
  Eigen::MatrixXd matrix(dimension_, dimension_);
  for (Eigen::Index i = 0; i < dimension_; ++i)
    matrix.col(i) = points_.col(basis[static_cast<std::size_t>(i)]);
  return matrix;
}

SymmetricHull::Start SymmetricHull::start_at(const Basis& basis) const {
  return {basis, matrix_of(basis).inverse()};
}

SymmetricHull::Combination SymmetricHull::least_combination(const Eigen::VectorXd& u,
                                                            const Start& begin, double enough,
                                                            double too_much) const {
  Tableau tableau(*this, u, begin);
  const auto most_steps = static_cast<int>(20 * dimension_ + 200);
  bool stuck = true;
  bool outside = false;
  for (int step = 0; step < most_steps; ++step) {
    bool ended = tableau.c.lpNorm<1>() <= enough;
    if (!ended) {
      const Tableau::Farthest next = tableau.farthest();
      outside = next.of_all && tableau.c.lpNorm<1>() > too_much * std::abs(next.height);
      ended = outside || std::abs(next.height) <= 1 + kOptimal;
      if (!ended && !tableau.exchange(next.point, next.height)) break;
    }
    stuck = !ended || !tableau.is_accurate();
    if (!stuck) break;
    if (ended) tableau.factorise();  // and see again, without the updates' errors
  }
  if (stuck && begin.basis != basis_)
    return least_combination(u, start_at(basis_), enough, too_much);
  return {tableau.c.lpNorm<1>(), outside, std::move(tableau.basis), std::move(tableau.c)};
}

Eigen::VectorXd SymmetricHull::axis_norms() const {
  const Eigen::MatrixXd matrix = matrix_of(basis_);
  const Eigen::MatrixXd inverse = matrix.inverse();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(dimension_, dimension_);
  // e_i = matrix · inverse · e_i + rest_i
  const Eigen::MatrixXd rest =
      (identity - matrix * inverse).cwiseAbs() +
      rounding_error(dimension_ + 2) * (identity + matrix.cwiseAbs() * inverse.cwiseAbs());
  const Eigen::VectorXd sums = inverse.cwiseAbs().colwise().sum();
  const double left = inflated(rest.colwise().sum().maxCoeff());
  if (!(left < 0.5))
    return Eigen::VectorXd::Constant(dimension_, std::numeric_limits<double>::infinity());
  const double greatest = inflated(sums.maxCoeff() / (1 - left));
  const Eigen::VectorXd norms = sums + greatest * rest.colwise().sum().transpose();
  return norms.unaryExpr(&inflated);
}

Eigen::VectorXd SymmetricHull::residual_bound(const Eigen::VectorXd& u,
                                              const Eigen::VectorXd& slack,
                                              const Combination& combination) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(dimension_);
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(dimension_);
  for (Eigen::Index i = 0; i < dimension_; ++i) {
    const auto point = points_.col(combination.points[static_cast<std::size_t>(i)]);
    sum += combination.coefficients(i) * point;
    sizes += std::abs(combination.coefficients(i)) * point.cwiseAbs();
  }
  const Eigen::VectorXd bound =
      (u - sum).cwiseAbs() + rounding_error(dimension_ + 2) * (u.cwiseAbs() + sizes) + slack;
  return bound.unaryExpr(&inflated);
}

}  // namespace limn::regular
