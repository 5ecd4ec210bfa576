#pragma once
/// Frequency blocks in any number that weights can be evaluated in, and real.
///
/// The block of frequency ω maps amplitudes of orbits to such (spectrum/frequency_blocks.h). A
/// mirror takes an orbit at angle a to that at -a and an amplitude to its conjugate; so the values
/// X of orbits that are their own mirror image, and p, q of pairs X = p + iq, X' = p - iq, are
/// mapped by a real matrix that is similar to the block. Eigenvectors that are real in this basis
/// are mirror symmetric.

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "limn/number/dense_matrix.h"
#include "limn/scheme/scope.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn::certify {

/// An orbit of the star, its angle exactly, and where its amplitude is in the real basis.
struct RealOrbit {
  int ring = 0;               ///< from 1
  int place = 0;              ///< the angle is place/size sectors from the spoke (dual: the corner)
  int size = 1;               ///< points of the ring in a sector
  std::size_t real = 0;       ///< row of its value, or of p
  std::size_t imaginary = 0;  ///< row of q; the same as `real` where the orbit is its own image
  bool reflected = false;     ///< the amplitude is p - iq
};

/// The real basis of a star.
struct RealBasis {
  bool has_center = false;
  int rings = 0;
  std::vector<RealOrbit> orbits;
  /// Number of the orbit in ring r ≥ 1 at place/size, whatever sector: places count modulo size.
  [[nodiscard]] std::size_t orbit(int ring, int place) const;
  std::vector<std::size_t> first_orbit;  ///< of ring r, at r - 1
};
[[nodiscard]] RealBasis real_basis(const spectrum::SectorPattern& pattern);
/// The eigenvector of the eigenvalue 1, of frequency 0: 1, but 0 for imaginary parts; the centre
/// first, where there is one.
[[nodiscard]] std::vector<int> constant_vector(const RealBasis& basis);

/// The weights of a pattern's names.
template <class Number>
struct NamedValues {
  Number n;                                 ///< the valence
  std::vector<std::vector<Number>> values;  ///< one number each, or n of a repeated role
  /// Of repeated roles where not all n positions are told apart: k of each value, and what the
  /// others add up to at this frequency with the phase of k = 0, and with that of k = -1/2. Empty:
  /// values are of k = 0 … n-1.
  std::vector<std::vector<int>> positions = {};
  std::vector<Number> amid = {}, amid_half = {};
};

/// Scope of the weight of a name at position k: the valence is n at the centre, and that of a
/// regular rule elsewhere.
template <class Number>
scheme::Scope<Number> scope_of(const Scheme& scheme, const spectrum::NamedWeight& name,
                               std::optional<int> n, int k) {
  using A = number::Arithmetic<Number>;
  scheme::Scope<Number> scope(scheme, std::nullopt, std::nullopt);
  if (!name.regular && n) scope.give("n", A::from(Rational(*n)));
  if (name.regular && *name.regular != 0) scope.give("n", A::from(Rational(*name.regular)));
  if (name.repeated) scope.give("k", A::from(Rational(k)));
  if (name.k) scope.give("k", A::from(Rational(*name.k)));
  return scope;
}

/// At the valence n, a whole number.
template <class Number>
Result<NamedValues<Number>> named_values(const Scheme& scheme,
                                         const spectrum::SectorPattern& pattern, int n) {
  using A = number::Arithmetic<Number>;
  NamedValues<Number> result{A::from(Rational(n)), {}};
  result.values.resize(pattern.names.size());
  for (std::size_t i = 0; i < pattern.names.size(); ++i) {
    const spectrum::NamedWeight& name = pattern.names[i];
    for (int k = 0; k < (name.repeated ? n : 1); ++k) {
      Result<Number> value = scope_of<Number>(scheme, name, n, k)(name.weight->value);
      if (value) value = A::multiply(*value, A::from(name.share));
      if (!value) return value.error();
      result.values[i].push_back(std::move(*value));
    }
  }
  return result;
}

/// The pattern with the weights of all rules as names, so that nothing in it is rounded. Which
/// rules apply is that of valence n.
[[nodiscard]] Result<spectrum::SectorPattern> exact_pattern(const Scheme& scheme, int n);
/// The same of so many rings.
[[nodiscard]] Result<spectrum::SectorPattern> exact_pattern(const Scheme& scheme, int n, int rings);

/// A turn of the plane by an angle α, in coordinates (p, q/σ): p' = cos α p - σ sin α (q/σ),
/// q'/σ = (sin α/σ) p + cos α (q/σ). σ is 1 but where it makes a limit exist.
template <class Number>
struct Turn {
  Turn(Number along, Number imaginary, Number real)
      : cosine(std::move(along)), to_imaginary(std::move(imaginary)), to_real(std::move(real)) {}
  /// σ = 1: cos α and sin α.
  Turn(std::pair<Number, Number> phase)  // NOLINT(google-explicit-constructor): the usual case
      : cosine(std::move(phase.first)), to_imaginary(phase.second), to_real(phase.second) {}
  Number cosine;
  Number to_imaginary;  ///< sin α/σ
  Number to_real;       ///< σ sin α
};

/// The turn by x sectors at frequency ω: α = 2πωx/n, x = numerator/denominator.
template <class Number>
using Phase = std::function<Turn<Number>(int numerator, int denominator)>;

/// The real matrix of one frequency. `constant`: ω = 0, the centre comes first where there is one;
/// else it has none. Precondition: all phases that `phase` gives are those of that frequency.
template <class Number>
class RealBlock {
 public:
  RealBlock(const spectrum::SectorPattern& pattern, const RealBasis& basis,
            const NamedValues<Number>& values, const Phase<Number>& phase, bool constant)
      : pattern_(pattern), basis_(basis), values_(values), phase_(phase), constant_(constant) {}

  number::DenseMatrix<Number> make() {
    shift_ = constant_ && basis_.has_center ? 1 : 0;
    const std::size_t size = basis_.orbits.size() + shift_;
    matrix_ = number::DenseMatrix<Number>(size, size);
    for (const spectrum::SectorTerm& term : pattern_.terms) {
      if (!constant_ &&
          (term.row == spectrum::kCenter || term.column == spectrum::kCenter || term.every_sector))
        continue;
      Number factor = Number(Rational(term.coefficient));
      for (const int name : term.names)
        factor = factor * values_.values[static_cast<std::size_t>(name)].front();
      if (term.every_sector) factor = factor * values_.n;
      add(term, factor);
    }
    return std::move(matrix_);
  }

 private:
  /// Numerator and denominator of an angle in sectors: from the row's point to the column's.
  [[nodiscard]] std::pair<int, int> angle(const spectrum::SectorTerm& term) const {
    const auto place = [&](int orbit) {
      return orbit == spectrum::kCenter
                 ? std::pair{0, 1}
                 : std::pair{basis_.orbits[static_cast<std::size_t>(orbit)].place,
                             basis_.orbits[static_cast<std::size_t>(orbit)].size};
    };
    if (term.column == spectrum::kCenter || term.row == spectrum::kCenter) return {0, 1};
    const auto [row, row_size] = place(term.row);
    const auto [column, column_size] = place(term.column);
    const double known =
        static_cast<double>(column) / column_size - static_cast<double>(row) / row_size;
    const int halves = static_cast<int>(std::lround(2 * (term.angle - known)));
    return {halves * row_size * column_size + 2 * column * row_size - 2 * row * column_size,
            2 * row_size * column_size};
  }

  void add(const spectrum::SectorTerm& term, const Number& factor) {
    const auto [numerator, denominator] = angle(term);
    const Turn<Number> first = phase_(numerator, denominator);
    if (term.repeated < 0) return add(term, scaled(first, factor));
    const auto name = static_cast<std::size_t>(term.repeated);
    const std::vector<Number>& weights = values_.values[name];
    Turn<Number> sum = scaled(first, values_.amid.empty() ? Number(0) : values_.amid[name]);
    const auto add_to_sum = [&](const Turn<Number>& at) {
      sum = {sum.cosine + at.cosine, sum.to_imaginary + at.to_imaginary, sum.to_real + at.to_real};
    };
    if (!values_.amid_half.empty())
      add_to_sum(scaled(phase_(2 * numerator - term.slope * denominator, 2 * denominator),
                        values_.amid_half[name]));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const int k = values_.positions.empty() ? static_cast<int>(i) : values_.positions[name][i];
      add_to_sum(scaled(phase_(numerator + term.slope * k * denominator, denominator), weights[i]));
    }
    add(term, scaled(sum, factor));
  }

  static Turn<Number> scaled(const Turn<Number>& z, const Number& factor) {
    return {z.cosine * factor, z.to_imaginary * factor, z.to_real * factor};
  }

  /// X_row += z X_column, in real coordinates.
  void add(const spectrum::SectorTerm& term, const Turn<Number>& z) {
    if (term.row != spectrum::kCenter &&
        basis_.orbits[static_cast<std::size_t>(term.row)].reflected)
      return;  // the conjugate of its image's row
    const auto rows = coordinates(term.row);
    const auto columns = coordinates(term.column);
    const bool reflected = term.column != spectrum::kCenter &&
                           basis_.orbits[static_cast<std::size_t>(term.column)].reflected;
    // z (p ± iq) = (z1 p ∓ z2 q) + i (z2 p ± z1 q)
    sum(rows.first, columns.first, z.cosine, false);
    const bool pair_row = rows.first != rows.second;
    if (pair_row) sum(rows.second, columns.first, z.to_imaginary, false);
    if (columns.first == columns.second) return;
    sum(rows.first, columns.second, z.to_real, !reflected);
    if (pair_row) sum(rows.second, columns.second, z.cosine, reflected);
  }

  void sum(std::size_t row, std::size_t column, const Number& value, bool negative) {
    Number& entry = matrix_(row, column);
    entry = negative ? entry - value : entry + value;
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> coordinates(int orbit) const {
    if (orbit == spectrum::kCenter) return {0, 0};
    const RealOrbit& one = basis_.orbits[static_cast<std::size_t>(orbit)];
    return {one.real + shift_, one.imaginary + shift_};
  }

  const spectrum::SectorPattern& pattern_;
  const RealBasis& basis_;
  const NamedValues<Number>& values_;
  const Phase<Number>& phase_;
  bool constant_;
  std::size_t shift_ = 0;
  number::DenseMatrix<Number> matrix_;
};

}  // namespace limn::certify
