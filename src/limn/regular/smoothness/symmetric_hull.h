#pragma once
/// The norm whose unit ball is the convex hull of given points and their negatives:
/// ‖u‖ = min Σ|c_i| over u = Σ c_i v_i. Found by the simplex method; every basis is feasible once
/// the signs are chosen, so there is no search for a start.

#include <Eigen/Dense>
#include <limits>
#include <vector>

namespace limn::regular {

class SymmetricHull {
 public:
  explicit SymmetricHull(Eigen::Index dimension);

  /// Adds v and -v. The first points that are linearly independent become the first basis.
  void add(const Eigen::VectorXd& v);
  [[nodiscard]] bool spans() const {
    return static_cast<Eigen::Index>(basis_.size()) == dimension_;
  }
  [[nodiscard]] Eigen::Index count() const { return count_; }
  [[nodiscard]] auto points() const { return points_.leftCols(count_); }
  /// Whether v leaves the span of the points so far, by a thousandth of the longest point, of which
  /// the first is taken to be one.
  [[nodiscard]] bool leaves_span(const Eigen::VectorXd& v) const;

  using Basis = std::vector<Eigen::Index>;  ///< numbers of linearly independent points
  [[nodiscard]] const Basis& first_basis() const { return basis_; }

  /// A basis to begin searches at, with the inverse of its matrix.
  struct Start {
    Basis basis;
    Eigen::MatrixXd inverse;
  };
  /// Cost: dimension³.
  [[nodiscard]] Start start_at(const Basis& basis) const;

  struct Combination {
    double norm = 0;       ///< Σ|c| in double precision; not the least if the search ended early
    bool outside = false;  ///< the least was seen to exceed `too_much`
    Basis points;          ///< those that take part, one for each coordinate
    Eigen::VectorXd coefficients;  ///< of these points
  };
  /// u as a combination of least Σ|c|. The search begins at a basis and ends early where the sum is
  /// ≤ enough, or is seen to exceed `too_much`. Precondition: spans(). Several threads may search
  /// at once.
  [[nodiscard]] Combination least_combination(
      const Eigen::VectorXd& u, const Start& begin, double enough,
      double too_much = std::numeric_limits<double>::infinity()) const;

  /// Names points that are tried before all others, for speed alone.
  void prefer(const std::vector<Eigen::Index>& points);

  /// For each axis e_i an upper bound of ‖e_i‖, proved; infinite where the first basis is too bad.
  [[nodiscard]] Eigen::VectorXd axis_norms() const;

  /// What Σ_i c_i v_i differs from u by, at most, coordinate by coordinate, proved; `slack` is the
  /// uncertainty of u itself.
  [[nodiscard]] Eigen::VectorXd residual_bound(const Eigen::VectorXd& u,
                                               const Eigen::VectorXd& slack,
                                               const Combination& combination) const;

 private:
  struct Tableau;
  [[nodiscard]] Eigen::MatrixXd matrix_of(const Basis& basis) const;

  Eigen::Index dimension_;
  Eigen::Index count_ = 0;
  Eigen::MatrixXd points_;  // columns; the first count_ are used
  double longest_ = 0;
  Eigen::MatrixXd directions_;  // an orthonormal basis of the span of the first points
  Basis basis_;
  std::vector<Eigen::Index> preferred_;
  Eigen::MatrixXd preferred_points_;
};

}  // namespace limn::regular
