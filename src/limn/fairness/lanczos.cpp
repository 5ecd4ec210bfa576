#include "limn/fairness/lanczos.h"

#include <algorithm>
#include <numeric>
#include <random>

#if LIMN_HAS_SPECTRA
#include <Spectra/SymEigsSolver.h>
#include <Eigen/SparseCholesky>

#include "limn/base/interrupt.h"
#endif

namespace limn::fairness {

#if LIMN_HAS_SPECTRA

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kTolerance = 1e-11;
constexpr int kMostRestarts = 300;

/// x → P (matrix − shift)⁻¹ P x, with P the projection orthogonal to what was found.
class ShiftedInverse {
 public:
  using Scalar = double;

  explicit ShiftedInverse(const Sparse& matrix) : matrix_(matrix), found_(matrix.rows(), 0) {}

  /// Whether the shift lies below all eigenvalues; only then can the inverse be used.
  bool set_shift(double shift) {
    Sparse identity(matrix_.rows(), matrix_.cols());
    identity.setIdentity();
    solver_.compute(matrix_ - shift * identity);
    return solver_.info() == Eigen::Success;
  }
  void leave_out(const MatrixXd& found) { found_ = found; }

  [[nodiscard]] Eigen::Index rows() const { return matrix_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrix_.cols(); }
  void perform_op(const double* in, double* out) const {
    base::check_interrupt();
    const VectorXd x = projected(VectorXd::Map(in, rows()));
    VectorXd::Map(out, rows()) = projected(solver_.solve(x));
  }
  [[nodiscard]] VectorXd projected(VectorXd x) const {
    x -= found_ * (found_.transpose() * x);
    return x;
  }

 private:
  const Sparse& matrix_;
  MatrixXd found_;
  Eigen::SimplicialLLT<Sparse> solver_;
};

/// The matrix turned about: its least eigenvalue is this one's largest.
class Negative {
 public:
  using Scalar = double;
  explicit Negative(const Sparse& matrix) : matrix_(matrix) {}
  [[nodiscard]] Eigen::Index rows() const { return matrix_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrix_.cols(); }
  void perform_op(const double* in, double* out) const {
    base::check_interrupt();
    VectorXd::Map(out, rows()) = -(matrix_ * VectorXd::Map(in, rows()));
  }

 private:
  const Sparse& matrix_;
};

/// The same numbers in every run and on every machine.
VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  VectorXd vector(size);
  for (double& entry : vector) entry = static_cast<double>(random()) / 4294967296.0 - 0.5;
  return vector;
}

template <class Operator>
MatrixXd dominant_vectors(Operator& op, const VectorXd& start, int count, double tolerance) {
  const int space = std::min(static_cast<int>(op.rows()), std::max(2 * count + 1, count + 20));
  Spectra::SymEigsSolver<Operator> solver(op, count, space);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestAlge, kMostRestarts, tolerance,
                 Spectra::SortRule::LargestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) return {};
  return solver.eigenvectors();
}

double rayleigh_quotient(const Sparse& matrix, const VectorXd& vector) {
  return vector.dot(matrix * vector) / vector.squaredNorm();
}

/// A shift a little below the least eigenvalue, factored: the nearer, the faster all converges.
void set_shift_below(const Sparse& matrix, ShiftedInverse& inverse) {
  constexpr double kRough = 1e-3;
  Negative negative(matrix);
  const MatrixXd rough = dominant_vectors(negative, random_vector(matrix.rows(), 1), 1, kRough);
  const double bound = rough.cols() > 0 ? rayleigh_quotient(matrix, rough.col(0)) : 0;
  double gap = 1.0 / static_cast<double>(matrix.rows());
  while (!inverse.set_shift(bound - gap)) gap *= 4;
}

/// Eigenpairs found so far, rising.
struct Found {
  std::vector<double> values;
  MatrixXd vectors;

  void add(const Sparse& matrix, const MatrixXd& more) {
    const Eigen::Index old = vectors.cols();
    vectors.conservativeResize(matrix.rows(), old + more.cols());
    vectors.rightCols(more.cols()) = more;
    for (Eigen::Index j = 0; j < more.cols(); ++j)
      values.push_back(rayleigh_quotient(matrix, more.col(j)));
    std::vector<Eigen::Index> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return values[static_cast<std::size_t>(a)] < values[static_cast<std::size_t>(b)];
    });
    vectors = MatrixXd(vectors(Eigen::all, order));
    std::sort(values.begin(), values.end());
  }
};

}  // namespace

bool lanczos_available() { return true; }

Result<LeastEigenpairs> approx_least_eigenpairs(const Sparse& matrix, int count) {
  constexpr int kMore = 8;  // looked for again, orthogonally to what was found
  constexpr double kSame = 1e-9;
  ShiftedInverse inverse(matrix);
  set_shift_below(matrix, inverse);
  Found found{{}, MatrixXd(matrix.rows(), 0)};
  for (unsigned pass = 0;; ++pass) {
    inverse.leave_out(found.vectors);
    const VectorXd start = inverse.projected(random_vector(matrix.rows(), pass + 2));
    const MatrixXd more =
        dominant_vectors(inverse, start, pass == 0 ? count : std::min(count, kMore), kTolerance);
    if (more.cols() == 0)
      return Error{"the modes did not converge", "ask for fewer, or for more at once"};
    const bool last = pass > 0 && rayleigh_quotient(matrix, more.col(0)) >
                                      found.values[static_cast<std::size_t>(count - 1)] - kSame;
    if (last) break;
    found.add(matrix, more);
  }
  found.values.resize(static_cast<std::size_t>(count));
  return LeastEigenpairs{found.values, found.vectors.leftCols(count)};
}

#else

bool lanczos_available() { return false; }

Result<LeastEigenpairs> approx_least_eigenpairs(const Eigen::SparseMatrix<double>&, int) {
  return Error{"this limn finds no modes of large meshes", "build it with Spectra"};
}

#endif

}  // namespace limn::fairness
