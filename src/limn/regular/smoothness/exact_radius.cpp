#include "limn/regular/smoothness/exact_radius.h"

#include <algorithm>
#include <cmath>

#include "limn/number/rational_power.h"
#include "limn/regular/algebra/determinant.h"

namespace limn::regular {
namespace {

using Vector = FieldVector<Rational>;

constexpr double kSteps = 32;  // of a scale between two powers of 2

using number::power;

/// The whole number n-th root of one, if it is that.
std::optional<Rational> whole_root(const Rational& q, int n) {
  const Rational root(std::nearbyint(std::pow(to_double(q), 1.0 / n)));
  if (power(root, static_cast<std::size_t>(n)) != q) return std::nullopt;
  return root;
}

Rational inner(const Vector& a, const Vector& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != 0 && b[i] != 0) sum += a[i] * b[i];
  return sum;
}

Vector scaled(Vector v, const Rational& by) {
  for (Rational& entry : v) entry *= by;
  return v;
}

/// x rounded to a few binary digits: what is exact from here on has short numbers.
Rational short_number(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return Rational(std::ldexp(std::nearbyint(part * kSteps), exponent) / kSteps);
}

/// An eigenvector, and the left one with which its inner product is 1.
struct Pair {
  Vector right, left;
};

/// Nothing where the eigenvalue is none, or is not simple.
std::optional<Pair> eigenvectors(RationalMatrix a, const Rational& eigenvalue) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i][i] -= eigenvalue;
  const Echelon<Rational> right = null_space(a);
  if (right.dimension() != 1) return std::nullopt;
  const Echelon<Rational> left = null_space(transposed(a));
  const Rational both = inner(left.rows()[0], right.rows()[0]);
  if (both == 0) return std::nullopt;
  return Pair{right.rows()[0], scaled(left.rows()[0], 1 / both)};
}

/// Scales, as logarithms to base 2, that make |w_i v_j| s_j / s_i alike for (i, j) and (j, i).
std::vector<double> balance(const std::vector<Pair>& pairs) {
  std::vector<double> scales;
  for (const Pair& one : pairs) {
    double sum = 0;
    for (const Pair& other : pairs) {
      const double there = std::abs(to_double(inner(one.left, other.right)));
      const double back = std::abs(to_double(inner(other.left, one.right)));
      if (there > 0 && back > 0) sum += std::log2(there / back) / 2;
    }
    scales.push_back(sum / static_cast<double>(pairs.size()));
  }
  return scales;
}

}  // namespace

std::optional<Rational> rational_root(const Rational& q, int n) {
  if (n == 1) return q;
  const std::optional<Rational> above = whole_root(numerator(q), n);
  const std::optional<Rational> below = whole_root(denominator(q), n);
  if (!above || !below) return std::nullopt;
  return *above / *below;
}

std::vector<FieldVector<Rational>> balanced_leading_vectors(
    const std::vector<RationalMatrix>& matrices, const Rational& level, const Product& best) {
  std::vector<Pair> pairs;
  for (const std::vector<int>& word : best.equals) {
    std::vector<const RationalMatrix*> list;
    list.reserve(word.size());
    for (const int factor : word) list.push_back(&matrices[static_cast<std::size_t>(factor)]);
    const RationalMatrix product = product_of(list);
    for (const int sign : {1, -1})
      if (std::optional<Pair> pair = eigenvectors(product, power(level, word.size()) * sign))
        pairs.push_back(std::move(*pair));
  }
  std::vector<Vector> start;
  if (!pairs.empty()) {
    const std::vector<double> scales = balance(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      start.push_back(scaled(pairs[i].right, short_number(std::exp2(scales[i] - scales[0]))));
    return start;
  }
  for (const Eigen::VectorXd& leading : best.leading) {
    Vector& v = start.emplace_back();
    for (const double entry : leading) v.push_back(short_number(entry));
  }
  return start;
}

std::optional<int> bound_exactly(const std::vector<RationalMatrix>& matrices, const Rational& level,
                                 const Product& best, const ExactPolytopeLimits& limits) {
  const auto vertices = find_invariant_polytope(
      matrices, level, balanced_leading_vectors(matrices, level, best), limits);
  if (!vertices) return std::nullopt;
  return static_cast<int>(vertices->size());
}

}  // namespace limn::regular
