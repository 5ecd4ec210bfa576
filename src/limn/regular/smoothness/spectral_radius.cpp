#include "limn/regular/smoothness/spectral_radius.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <utility>

#include "limn/regular/algebra/approx_matrix.h"
#include "limn/regular/algebra/determinant.h"
#include "limn/regular/smoothness/rounding.h"

namespace limn::regular {
namespace {

constexpr double kBelow = 1 - 1e-12;  // a root is sought between this part of it and infinity

/// The fraction of least denominator that is x to this part, if there is one with less than half as
/// many digits.
std::optional<Rational> simple_fraction(double x, double part) {
  const double size = std::abs(x);
  const auto most = static_cast<std::int64_t>(1 / std::sqrt(part));
  if (!(size > 1e-12 && size < 1e6)) return std::nullopt;
  double rest = size;
  std::int64_t above = 1;
  std::int64_t above_before = 0;
  std::int64_t below = 0;
  std::int64_t below_before = 1;
  for (int step = 0; step < 40; ++step) {
    const double whole = std::floor(rest);
    if (whole > 1e9) return std::nullopt;
    const auto digit = static_cast<std::int64_t>(whole);
    above_before = std::exchange(above, digit * above + above_before);
    below_before = std::exchange(below, digit * below + below_before);
    if (below > most || above > 1000 * most) return std::nullopt;
    const double value = static_cast<double>(above) / static_cast<double>(below);
    if (std::abs(value - size) < part * size) return Rational(x < 0 ? -above : above, below);
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

RationalMatrix shifted(RationalMatrix a, const Rational& by) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i][i] -= by;
  return a;
}

/// The monic polynomial of least degree that annihilates the vector: coefficients from a Krylov
/// sequence. It divides the characteristic polynomial, but repeats no root of a diagonalisable
/// matrix. Nothing where `stop` asked for an end.
std::vector<Rational> annihilating_polynomial(const RationalMatrix& a, const Stop& stop) {
  const std::size_t n = a.size();
  FieldVector<Rational> x;
  for (std::size_t i = 0; i < n; ++i) x.emplace_back(static_cast<int>(i * i % 7 + 1));
  Echelon<Rational> powers(2 * n + 1);  // aᵏ x, and which k it is
  for (std::size_t k = 0; !asked(stop); ++k) {
    FieldVector<Rational> labelled = x;
    labelled.resize(2 * n + 1, Rational(0));
    labelled[n + k] = 1;
    const FieldVector<Rational> rest = powers.reduced(labelled);
    if (std::all_of(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(n),
                    [](const Rational& entry) { return entry == 0; }))
      return {rest.begin() + static_cast<std::ptrdiff_t>(n),
              rest.begin() + static_cast<std::ptrdiff_t>(n + k + 1)};
    powers.insert(labelled);
    x = product(a, x);
  }
  return {};
}

/// Whether a real eigenvalue has the sign of `root` and at least the size `least`: the
/// determinant of t - a is positive for large t, so it vanishes above where it is negative.
bool has_root_beyond(const RationalMatrix& a, double root, double least, const Stop& stop) {
  RationalMatrix matrix = a;  // least - |a|, where |a| stands for a or -a
  for (FieldVector<Rational>& row : matrix)
    for (Rational& entry : row)
      if (root > 0) entry = -entry;
  const std::optional<int> sign = sign_of_determinant(shifted(matrix, Rational(-least)), stop);
  if (!sign) return false;
  if (*sign < 0) return true;
  const std::vector<Rational> polynomial = annihilating_polynomial(matrix, stop);
  if (polynomial.empty()) return false;
  Rational value = 0;
  for (std::size_t k = polynomial.size(); k-- > 0;)
    value = value * Rational(-least) + polynomial[k];
  return polynomial.size() % 2 == 1 ? value < 0 : value > 0;
}

/// From |tr aᵐ| ≤ size · ρᵐ, m = 1, 2, 4, …, with a bound of the error of each entry.
double bound_of_traces(const Eigen::MatrixXd& approx, double scale) {
  constexpr int kSquarings = 14;
  Eigen::MatrixXd a = approx / scale;
  Eigen::MatrixXd error = a.cwiseAbs() * rounding_error(4);
  double best = 0;
  double power = 1;
  const auto size = static_cast<double>(a.rows());
  for (int step = 0; step <= kSquarings; ++step) {
    const double uncertain =
        inflated(error.trace() + rounding_error(a.rows()) * a.diagonal().cwiseAbs().sum());
    const double trace = std::abs(a.trace()) - uncertain;
    if (trace > 0) best = std::max(best, std::pow(trace / size, 1 / power) * kBelow);
    const Eigen::MatrixXd sizes = a.cwiseAbs();
    error =
        (sizes * error + error * sizes + error * error + rounding_error(a.rows()) * sizes * sizes)
            .unaryExpr(&inflated)
            .eval();
    a = (a * a).eval();
    if (!a.allFinite() || !error.allFinite()) break;
    power *= 2;
  }
  return best * scale * kBelow;
}

/// A rational eigenvalue next to `root`, exactly; eigenvalues that belong to Jordan blocks come
/// with large errors.
std::optional<Rational> rational_eigenvalue(const RationalMatrix& a, double root,
                                            const Stop& stop) {
  std::optional<Rational> last;
  for (const double part : {1e-13, 1e-9, 1e-6, 1e-4}) {
    std::optional<Rational> fraction = simple_fraction(root, part);
    if (!fraction || fraction == last) continue;
    if (is_singular(shifted(a, *fraction), stop) == true) return fraction;
    last = fraction;
  }
  return std::nullopt;
}

}  // namespace

SpectralRadiusBound lower_spectral_radius(const RationalMatrix& a, const Stop& stop) {
  const Eigen::MatrixXd approx = approx_matrix(a);
  const Eigen::VectorXcd values = approx.eigenvalues();
  const double radius = values.cwiseAbs().maxCoeff();
  if (!(radius > 1e-12)) return {};
  SpectralRadiusBound bound;
  for (const std::complex<double> value : values) {
    const double root = value.real();
    if (std::abs(root) < radius * (1 - 1e-3)) continue;
    const std::optional<Rational> found = rational_eigenvalue(a, root, stop);
    if (found && (!bound.eigenvalue || abs(*found) > abs(*bound.eigenvalue)))
      bound.eigenvalue = found;
    const double least = radius * kBelow;
    if (std::abs(root) > least && bound.lower < least && has_root_beyond(a, root, least, stop))
      bound.lower = least;
  }
  if (bound.eigenvalue && abs(*bound.eigenvalue) >= Rational(bound.lower)) {
    bound.lower = std::nextafter(std::abs(to_double(*bound.eigenvalue)), 0.0);
    return bound;
  }
  bound.eigenvalue.reset();
  if (bound.lower == 0) bound.lower = bound_of_traces(approx, radius);
  return bound;
}

}  // namespace limn::regular
