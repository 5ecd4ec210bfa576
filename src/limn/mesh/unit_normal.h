#pragma once
/// Unit normals from tangents of any length, the same however large or small the model is.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// How many units of rounding (of the largest coordinate that it was summed from) a tangent has to
/// be longer than, so that its direction means something: refined points that should coincide
/// differ by a few units, and tangents weigh some dozen of them.
inline constexpr double kTangentUnits = 45;

/// Squares of normals from here to its inverse are products of numbers of which none was lost;
/// those beyond are to be found by unit_normal.
template <class Real>
inline constexpr Real kSafeSquare = Real(sizeof(Real) == sizeof(double) ? 1e-100 : 1e-28);

/// What `largest_exponent` gives of no length at all, or of one that is not finite.
inline constexpr int kNoExponent = std::numeric_limits<int>::min();

/// The least e with all |numbers| < 2^e; kNoExponent where all are 0 or one is not finite.
[[nodiscard]] inline int largest_exponent(std::span<const double> numbers) {
  double largest = 0;
  for (const double number : numbers) {
    if (!std::isfinite(number)) return kNoExponent;
    largest = std::max(largest, std::abs(number));
  }
  return largest > 0 ? std::ilogb(largest) + 1 : kNoExponent;
}

/// Points times 2^exponent: exact, unless they come near the ends of what can be represented.
[[nodiscard]] inline std::vector<Point3> scaled(std::vector<Point3> points, int exponent) {
  for (Point3& p : points)
    p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
  return points;
}

/// The unit vector along Σ tᵢ × tᵢ₊₁ of a chain of two or more tangents, which were summed in
/// `Real` from coordinates of at most `size`. Zero where rounding is all there is to it: where the
/// tangents vanish or are parallel, or are not finite. All are first scaled by a power of two, so
/// that no product overflows or is lost.
template <class Real>
[[nodiscard]] std::array<double, 3> unit_normal(std::span<const std::array<double, 3>> chain,
                                                double size) {
  int exponent = kNoExponent;
  for (const std::array<double, 3>& t : chain) {
    const int own = largest_exponent(t);
    if (own == kNoExponent && !(t == std::array<double, 3>{})) return {};
    exponent = std::max(exponent, own);
  }
  if (exponent == kNoExponent) return {};
  std::array<double, 3> normal{};
  double squares = 0;
  std::array<double, 3> last{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    std::array<double, 3> t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = std::ldexp(chain[i][k], -exponent);
    squares += t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    if (i > 0)
      for (std::size_t k = 0; k < 3; ++k)
        normal[k] += last[(k + 1) % 3] * t[(k + 2) % 3] - last[(k + 2) % 3] * t[(k + 1) % 3];
    last = t;
  }
  const double error =
      kTangentUnits * std::numeric_limits<Real>::epsilon() * std::ldexp(size, -exponent);
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > error * std::sqrt(squares)) || !(length > 0)) return {};
  for (double& number : normal) number /= length;
  return normal;
}

}  // namespace limn::mesh
