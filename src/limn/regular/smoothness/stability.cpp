#include "limn/regular/smoothness/stability.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/core.h>

#include "limn/regular/limit_values.h"
#include "limn/regular/smoothness/transition_operators.h"

namespace limn::regular {
namespace {

constexpr int kMostCuts = 26;  // of the frequency plane, along each axis
constexpr int kMostSquares = 100'000;
constexpr double kCosineRounding =
    1e-9;  // far above what sums of cosines in double precision are off by

/// Σ c_k e^{-iω·k}, k by whole offsets.
struct Wave {
  std::vector<LatticeVector> k;
  std::vector<double> c;

  [[nodiscard]] double squared_size(double x, double y) const {
    double real = 0;
    double imaginary = 0;
    for (std::size_t i = 0; i < k.size(); ++i) {
      const double angle = k[i][0] * x + k[i][1] * y;
      real += c[i] * std::cos(angle);
      imaginary += c[i] * std::sin(angle);
    }
    return real * real + imaginary * imaginary;
  }
  /// Bounds |gradient| in the sense |f(x) - f(y)| ≤ slope · max(|x1 - y1|, |x2 - y2|).
  [[nodiscard]] double slope() const {
    double sum = 0;
    for (std::size_t i = 0; i < k.size(); ++i)
      sum += std::abs(c[i]) * (std::abs(k[i][0]) + std::abs(k[i][1]));
    return sum;
  }
};

/// The values of φ at M⁻¹Z², one wave for each class modulo Z².
std::vector<Wave> waves(const Mask& mask, const Laurent& stencil) {
  Laurent values;  // by j: φ(M⁻¹ j), less the shift of a dual mask, which changes no size
  for (const auto& [k, weight] : integer_offsets(mask))
    for (const auto& [twice, value] : stencil)
      values[{k[0] + twice[0] / 2, k[1] + twice[1] / 2}] += weight * value;
  const std::vector<LatticeVector> classes = cosets(mask.dilation);
  std::vector<Wave> list(classes.size());
  for (const auto& [j, value] : values) {
    const auto s = static_cast<std::size_t>(coset_of(mask.dilation, j));
    list[s].k.push_back(*mask.dilation.divide({j[0] - classes[s][0], j[1] - classes[s][1]}));
    list[s].c.push_back(to_double(value));
  }
  return list;
}

/// Looks for a common zero of waves in squares, and cuts those where there may be one.
class ZeroSearch {
 public:
  explicit ZeroSearch(const std::vector<Wave>& waves) : waves_(waves) {
    double sum = 0;
    for (const Wave& wave : waves) sum += wave.slope() * wave.slope();
    slope_ = std::sqrt(sum);
  }

  /// Whether there is none, proved, in the square of that centre and half side.
  bool excludes(double x, double y, double half, int cuts = 0) {
    double sum = 0;
    for (const Wave& wave : waves_) sum += wave.squared_size(x, y);
    if (std::sqrt(sum) > slope_ * half * (1 + kCosineRounding) + kCosineRounding) return true;
    if (cuts == kMostCuts || ++squares_ > kMostSquares) return false;
    for (const double dx : {-half / 2, half / 2})
      for (const double dy : {-half / 2, half / 2})
        if (!excludes(x + dx, y + dy, half / 2, cuts + 1)) return false;
    return true;
  }

 private:
  const std::vector<Wave>& waves_;
  double slope_ = 0;
  int squares_ = 0;
};

}  // namespace

Stability prove_stability(const Mask& mask) {
  const Result<Laurent> stencil = limit_stencil(mask);
  if (!stencil) return {Truth::undecided, stencil.error().message};
  if (stencil->size() == 1)
    return {Truth::yes, "interpolatory: at the lattice points φ is 1 at one and 0 at the others"};
  const std::vector<Wave> list = waves(mask, *stencil);
  constexpr double kPi = std::numbers::pi;
  if (ZeroSearch(list).excludes(0, 0, kPi * (1 + kCosineRounding)))
    return {Truth::yes, "no wave on the control points has the limit 0 at all refined points"};
  return {Truth::undecided,
          "some wave on the control points may have the limit 0 (the values of φ at the refined "
          "points do not exclude it)"};
}

}  // namespace limn::regular
