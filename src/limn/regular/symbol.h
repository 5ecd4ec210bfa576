#pragma once
/// Frequencies, phases and symbols on the regular lattice [ADS §2.1].
///
/// A frequency f is Cartesian, in cycles per control edge; the lattice's basis is that of
/// mesh/lattice.h. The wave e^{2πi f·x} has the phase t_j = 2π f·e_j per control basis vector
/// e_j, and θ = M⁻ᵀ t per refined one.

#include <array>
#include <vector>

#include "limn/mesh/split/split.h"
#include "limn/number/laurent.h"

namespace limn {

/// A wave's frequency, Cartesian, in cycles per control edge.
using Frequency = std::array<double, 2>;
/// A wave's phases in radians, one per basis vector of a lattice.
using Phase = std::array<double, 2>;

/// The Cartesian vector with these coordinates in the lattice's basis.
[[nodiscard]] std::array<double, 2> cartesian(Lattice lattice, std::array<double, 2> coordinates);

/// t: 2π f·e1 and 2π f·e2.
[[nodiscard]] Phase control_phase(Lattice lattice, Frequency f);
/// The frequency with that phase per control basis vector, in radians.
[[nodiscard]] Frequency frequency_of_phase(Lattice lattice, Phase t);

/// The corners, counterclockwise, of the region of frequencies nearer to 0 than to any other
/// of the dual lattice: beyond it a wave on the control lattice is the same as one inside.
/// A hexagon with corners (±2/3, 0), (±1/3, ±1/√3) on triangles, the square of side 1 on quads.
[[nodiscard]] std::vector<Frequency> nyquist_region(Lattice lattice);

/// How far from 0 a ray leaves that region; its direction in degrees from the x axis.
[[nodiscard]] double nyquist_distance(Lattice lattice, double degrees);

/// A real trigonometric polynomial Σ a(k) e^{-iθ·k} of a point-symmetric a: Σ a(k) cos(θ·k).
class Symbol {
 public:
  /// One term a(k) cos(θ·k).
  struct Term {
    std::array<double, 2> k;  ///< the offset in the lattice's basis; halves for dual splits
    double weight;            ///< a(k)
  };

  /// 0
  Symbol() = default;
  /// From coefficients by twice the offset, multiplied by `scale`. Precondition: a(-k) = a(k).
  explicit Symbol(const Laurent& doubled, double scale = 1);
  /// From coefficients by offset. Precondition: a(-k) = a(k).
  explicit Symbol(const std::vector<Term>& all);

  /// The value at the phases θ, in radians. Cost: one cosine per term.
  [[nodiscard]] double operator()(Phase theta) const;
  /// One of each pair k, -k, with the weight of both.
  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }

 private:
  std::vector<Term> terms_;
};

/// a·b. Cost: the product of the numbers of terms.
[[nodiscard]] Symbol product(const Symbol& a, const Symbol& b);

/// True where a(-k) = a(k) for every k, exactly.
[[nodiscard]] bool is_point_symmetric(const Laurent& a);

}  // namespace limn
