#include "limn/spectrum/block_formulas.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/number/closed_roots.h"

namespace limn::spectrum {
namespace {

constexpr std::size_t kLargestSquare = 12;  // whose determinant is expanded
constexpr int kEverySlope = 2;              // half sectors in a sector

/// e^{iπω/n}
number::Indeterminate half_sector() { return number::variable("half-sector"); }

/// Sums that stop at the first error.
class Sum {
 public:
  void add(const Result<number::Symbolic>& term) {
    if (!sum_) return;
    sum_ = term ? number::Symbolic::add(*sum_, *term) : term;
  }
  [[nodiscard]] const Result<number::Symbolic>& value() const { return sum_; }

 private:
  Result<number::Symbolic> sum_ = number::Symbolic(0);
};

Result<number::Symbolic> turned(const number::Symbolic& value, int half_sectors) {
  if (half_sectors == 0) return value;
  return number::Symbolic::multiply(value, number::Polynomial({{half_sector(), half_sectors}}, 1));
}

/// Sets of rows, each of which depends on itself and earlier ones alone: the strongly connected
/// parts of a square of the matrix.
std::vector<std::vector<std::size_t>> connected_parts(const SymbolicMatrix& matrix,
                                                      std::size_t first, std::size_t last) {
  const std::size_t size = last - first;
  std::vector<std::vector<bool>> reaches(size, std::vector<bool>(size));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      reaches[i][j] = i == j || !matrix[first + i][first + j].is_zero();
  for (std::size_t via = 0; via < size; ++via)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j)
        if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
  std::vector<std::vector<std::size_t>> parts;
  std::vector<bool> seen(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (seen[i]) continue;
    parts.emplace_back();
    for (std::size_t j = i; j < size; ++j)
      if (reaches[i][j] && reaches[j][i]) {
        seen[j] = true;
        parts.back().push_back(first + j);
      }
  }
  return parts;
}

/// By rows, with the determinants of the upper rows for every set of columns.
Result<number::Symbolic> determinant(const SymbolicMatrix& matrix) {
  const std::size_t size = matrix.size();
  if (size > kLargestSquare)
    return Error{fmt::format("a block of {} orbits is too large for formulas", size)};
  std::vector<number::Symbolic> minors(std::size_t{1} << size);
  minors[0] = 1;
  for (std::size_t columns = 1; columns < minors.size(); ++columns) {
    const auto row = static_cast<std::size_t>(__builtin_popcountll(columns)) - 1;
    Sum sum;
    for (std::size_t j = 0; j < size; ++j) {
      const std::size_t bit = std::size_t{1} << j;
      if ((columns & bit) == 0 || matrix[row][j].is_zero()) continue;
      const number::Symbolic& minor = minors[columns ^ bit];
      if (minor.is_zero()) continue;
      const bool odd = __builtin_popcountll(columns & ~(2 * bit - 1)) % 2 != 0;
      sum.add(number::Symbolic::multiply(odd ? matrix[row][j].negated() : matrix[row][j], minor));
    }
    if (!sum.value()) return sum.value();
    minors[columns] = *sum.value();
  }
  return minors.back();
}

Result<number::Polynomial> characteristic_polynomial(const SymbolicMatrix& matrix,
                                                     const std::vector<std::size_t>& part,
                                                     const number::Indeterminate& unknown) {
  SymbolicMatrix square(part.size(), std::vector<number::Symbolic>(part.size()));
  for (std::size_t i = 0; i < part.size(); ++i)
    for (std::size_t j = 0; j < part.size(); ++j) {
      const number::Symbolic negated = matrix[part[i]][part[j]].negated();
      const Result<number::Symbolic> entry = number::Symbolic::add(
          negated, i == j ? number::Symbolic(number::Polynomial(unknown)) : number::Symbolic(0));
      if (!entry) return entry.error();
      square[i][j] = *entry;
    }
  const Result<number::Symbolic> value = determinant(square);
  if (!value) return value.error();
  return value->numerator();
}

/// Phases as cosines. A mirror maps the block of ω to that of -ω, so that z and 1/z come alike.
Result<number::Polynomial> with_cosines(const number::Polynomial& a,
                                        const SymbolicFrequency& frequency,
                                        const number::Symbolic& n) {
  std::map<int, number::Polynomial> powers = a.powers_of(half_sector());
  Sum sum;
  for (const auto& [j, coefficient] : powers) {
    const auto mirrored = powers.find(-j);
    if (mirrored == powers.end() || !(mirrored->second == coefficient))
      return Error{"the scheme has no mirror symmetry, which formulas need"};
    if (j < 0) continue;
    Result<number::Symbolic> angle = number::Symbolic::multiply(
        number::Polynomial(number::pi_indeterminate()) * number::Polynomial(j), frequency.value);
    if (angle) angle = number::Symbolic::divide(*angle, n);
    if (angle) angle = number::symbolic_cos(*angle);
    if (angle)
      angle = number::Symbolic::multiply(*angle, coefficient * number::Polynomial(j == 0 ? 1 : 2));
    sum.add(angle);
  }
  if (!sum.value()) return sum.value().error();
  return sum.value()->numerator();
}

/// Orbits first … last-1 of a block, which with all earlier ones are invariant.
struct RingPart {
  int ring;
  std::size_t first, last;
};

std::vector<RingPart> ring_parts(const SymbolicMatrix& matrix, const std::vector<Orbit>& orbits) {
  const std::size_t shift = matrix.size() - orbits.size();
  std::vector<RingPart> parts;
  std::size_t first = 0;
  for (std::size_t end = shift; end < matrix.size();) {
    const int ring = orbits[end - shift].ring;
    while (end < matrix.size() && orbits[end - shift].ring == ring) ++end;
    bool invariant = true;
    for (std::size_t i = 0; i < end; ++i)
      for (std::size_t j = end; j < matrix.size(); ++j)
        invariant = invariant && matrix[i][j].is_zero();
    if (!invariant) continue;
    parts.push_back({ring, first, end});
    first = end;
  }
  return parts;
}

void append(FrequencyFormulas& formulas, int ring, const number::ClosedRoots& roots) {
  for (const ClosedRoot& root : roots.roots) {
    const auto same = std::find_if(
        formulas.eigenvalues.begin(), formulas.eigenvalues.end(),
        [&](const EigenFormula& one) { return one.ring == ring && one.root.text == root.text; });
    if (same != formulas.eigenvalues.end())
      same->root.multiplicity += root.multiplicity;
    else
      formulas.eigenvalues.push_back({ring, root, std::nullopt});
  }
  for (const number::ClosedRoots::Left& left : roots.left)
    formulas.left.push_back({ring, left.degree, left.polynomial});
}

}  // namespace

Result<BlockFormulas> BlockFormulas::make(const SectorPattern& pattern, SymbolicWeights& weights,
                                          const std::string& unknown) {
  BlockFormulas result(pattern, weights.n(), unknown);
  for (const NamedWeight& name : pattern.names) {
    result.plain_.emplace_back(0);
    result.repeated_.emplace_back();
    if (name.repeated) {
      Result<RepeatedWeight> value = weights.repeated(name);
      if (!value) return value.error();
      result.repeated_.back() = std::move(*value);
    } else {
      Result<number::Symbolic> value = weights.plain(name);
      if (!value) return value.error();
      result.plain_.back() = std::move(*value);
    }
  }
  return result;
}

int BlockFormulas::highest_harmonic() const {
  int highest = 0;
  for (const RepeatedWeight& weight : repeated_)
    for (const auto* harmonics : {&weight.harmonics, &weight.half_harmonics})
      if (!harmonics->empty()) highest = std::max(highest, harmonics->rbegin()->first);
  return highest;
}

Result<SymbolicMatrix> BlockFormulas::block(const SymbolicFrequency& frequency) const {
  const bool constant = frequency.number == 0;
  const int shift = pattern_.has_center && constant ? 1 : 0;
  const std::size_t size = pattern_.orbits.size() + static_cast<std::size_t>(shift);
  SymbolicMatrix block(size, std::vector<number::Symbolic>(size));
  for (const SectorTerm& term : pattern_.terms) {
    const bool central = term.row == kCenter || term.column == kCenter;
    if ((central || term.every_sector) && !constant) continue;
    Result<number::Symbolic> value = term_value(term, frequency);
    number::Symbolic& entry = block[static_cast<std::size_t>(term.row + shift)]
                                   [static_cast<std::size_t>(term.column + shift)];
    if (value) value = number::Symbolic::add(entry, *value);
    if (!value) return value.error();
    entry = std::move(*value);
  }
  return block;
}

Result<number::Symbolic> BlockFormulas::term_value(const SectorTerm& term,
                                                   const SymbolicFrequency& frequency) const {
  Result<number::Symbolic> value = number::Symbolic(number::Polynomial(Rational(term.coefficient)));
  for (const int name : term.names)
    if (value) value = number::Symbolic::multiply(*value, plain_[static_cast<std::size_t>(name)]);
  if (value && term.every_sector) value = number::Symbolic::multiply(*value, n_);
  if (value && term.repeated >= 0) {
    const Result<number::Symbolic> sum = along(term, frequency);
    if (!sum) return sum.error();
    value = number::Symbolic::multiply(*value, *sum);
  }
  if (value && frequency.number != 0) value = turned(*value, half_sectors(term));
  return value;
}

/// From the row's sector to the column's.
int BlockFormulas::half_sectors(const SectorTerm& term) const {
  const auto angle = [&](int orbit) {
    return pattern_.orbits[static_cast<std::size_t>(orbit)].angle;
  };
  return static_cast<int>(std::lround(2 * (term.angle - angle(term.column) + angle(term.row))));
}

/// Σ w(k) e^{2πi slope ω k/n}
Result<number::Symbolic> BlockFormulas::along(const SectorTerm& term,
                                              const SymbolicFrequency& frequency) const {
  const RepeatedWeight& weight = repeated_[static_cast<std::size_t>(term.repeated)];
  const bool level = term.slope == 0 || frequency.number == 0;
  const std::optional<int> omega = level ? 0 : frequency.number;
  Sum sum;
  for (const auto* harmonics : {&weight.harmonics, &weight.half_harmonics})
    for (const auto& [m, coefficient] : *harmonics) {
      if (omega != m) continue;
      const bool is_half = harmonics == &weight.half_harmonics;
      const Result<number::Symbolic> there =
          turned(coefficient, is_half && !level ? -term.slope : 0);
      const Result<number::Symbolic> whole = there ? number::Symbolic::multiply(*there, n_) : there;
      sum.add(m == 0 || !whole
                  ? whole
                  : number::Symbolic::multiply(*whole, number::Polynomial(Rational(1, 2))));
    }
  const int step = level ? 0 : kEverySlope * term.slope;
  for (const auto& [j, extra] : weight.first) sum.add(turned(extra, step * j));
  for (const auto& [j, extra] : weight.last) sum.add(turned(extra, -step * j));
  return sum.value();
}

Result<FrequencyFormulas> BlockFormulas::eigenvalues(const SymbolicFrequency& frequency) const {
  FrequencyFormulas formulas;
  const Result<SymbolicMatrix> matrix = block(frequency);
  if (!matrix) return matrix.error();
  for (const RingPart& rings : ring_parts(*matrix, pattern_.orbits))
    for (const std::vector<std::size_t>& part : connected_parts(*matrix, rings.first, rings.last)) {
      Result<number::Polynomial> polynomial = characteristic_polynomial(*matrix, part, unknown_);
      if (polynomial) polynomial = with_cosines(*polynomial, frequency, n_);
      if (!polynomial) return polynomial.error();
      const Result<number::ClosedRoots> roots = number::closed_roots(*polynomial, unknown_);
      if (!roots) return roots.error();
      append(formulas, rings.ring, *roots);
    }
  return formulas;
}

}  // namespace limn::spectrum
