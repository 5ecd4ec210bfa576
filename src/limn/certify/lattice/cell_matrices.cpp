#include "limn/certify/lattice/cell_matrices.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include <fmt/core.h>

namespace limn::certify {
namespace {

constexpr std::size_t kMostPoints = 200;

/// Lattice coordinates as those of a sector.
LatticeVector in_sector(Lattice lattice, LatticeVector k) {
  return lattice == Lattice::triangle ? LatticeVector{k[0] - k[1], k[1]} : k;
}

LatticeMatrix in_sector(Lattice lattice, const LatticeMatrix& m) {
  if (lattice == Lattice::quad) return m;
  // columns: images of s1 = e1 and s2 = e1 + e2
  const LatticeVector first = in_sector(lattice, m.apply({1, 0}));
  const LatticeVector second = in_sector(lattice, m.apply({1, 1}));
  return {{{{first[0], second[0]}, {first[1], second[1]}}}};
}

LatticeMatrix times(const LatticeMatrix& a, const LatticeMatrix& b) {
  const LatticeVector first = a.apply({b.rows[0][0], b.rows[1][0]});
  const LatticeVector second = a.apply({b.rows[0][1], b.rows[1][1]});
  return {{{{first[0], second[0]}, {first[1], second[1]}}}};
}

/// M = s U with a whole number s > 1 and det U = ±1.
std::optional<std::pair<int, LatticeMatrix>> as_scaled(const LatticeMatrix& m) {
  for (int s = 2; s * s <= m.growth(); ++s) {
    if (s * s != m.growth()) continue;
    LatticeMatrix u = m;
    for (LatticeVector& row : u.rows)
      for (int& entry : row) {
        if (entry % s != 0) return std::nullopt;
        entry /= s;
      }
    return std::pair{s, u};
  }
  return std::nullopt;
}

/// One step and, where the dilation needs it, two.
struct Refinement {
  Laurent one, all;  // masks by whole offsets
  LatticeMatrix dilation, turn;
  int scale, steps;
};

Result<Refinement> refinement_of(const Mask& mask) {
  Refinement result;
  for (const auto& [k, value] : mask.coefficients) {
    if ((k[0] & 1) != (k[1] & 1)) return Error{"a mask that is dual along one direction only"};
    const bool dual = (k[0] & 1) != 0;
    // control value j is at j + ½, refined value k at (k + ½)/2
    const LatticeVector offset{(k[0] + (dual ? 1 : 0)) / 2, (k[1] + (dual ? 1 : 0)) / 2};
    result.one[in_sector(mask.lattice, offset)] += value;
  }
  result.dilation = in_sector(mask.lattice, mask.dilation);
  LatticeMatrix power = result.dilation;
  result.all = result.one;
  for (result.steps = 1; result.steps <= 2; ++result.steps) {
    if (const auto scaled = as_scaled(power)) {
      result.scale = scaled->first;
      result.turn = scaled->second;
      return result;
    }
    power = times(power, result.dilation);
    Laurent next;
    for (const auto& [k, value] : result.all)
      for (const auto& [j, weight] : result.one) {
        const LatticeVector at = result.dilation.apply({k[0], k[1]});
        next[{at[0] + j[0], at[1] + j[1]}] += weight * value;
      }
    std::erase_if(next, [](const auto& entry) { return entry.second == 0; });
    result.all = next;
  }
  return Error{"neither the dilation nor its square is a whole number times a unimodular matrix"};
}

bool is_dual(const Mask& mask) {
  return !mask.coefficients.empty() && (mask.coefficients.begin()->first[0] & 1) != 0;
}

class CellMaker {
 public:
  CellMaker(CellMatrices& cells, CellExtent extent) : cells_(cells) {
    cells_.points = {{0, 0}, {1, 0}, {0, 1}};
    if (extent == CellExtent::cell) return;
    for (int y = -1; y <= 2; ++y)
      for (int x = -1; x <= 2; ++x)
        if (x + y < 4 && std::find(cells_.points.begin(), cells_.points.end(),
                                   LatticeVector{x, y}) == cells_.points.end())
          cells_.points.push_back({x, y});
  }

  Status make() {
    if (Status grown = grow_points(); !grown) return grown;
    for (std::size_t i = 0; i < cells_.points.size(); ++i) index_[cells_.points[i]] = i;
    find_sizes();
    for (int y = 0; y < cells_.scale; ++y)
      for (int x = 0; x < cells_.scale; ++x)
        if (Status made = add_digit({x, y}); !made) return made;
    return Done{};
  }

  /// Calls sink(j, weight) for all that refined value k weighs.
  template <class Sink>
  void sources(LatticeVector k, Sink&& sink) const {
    const int s = cells_.scale;
    for (const auto& [offset, weight] : cells_.mask) {
      const LatticeVector times_s{k[0] - offset[0], k[1] - offset[1]};
      if (times_s[0] % s == 0 && times_s[1] % s == 0)
        sink(LatticeVector{times_s[0] / s, times_s[1] / s}, weight);
    }
  }

 private:
  Status grow_points() {
    std::vector<LatticeVector>& points = cells_.points;
    std::set<LatticeVector> seen(points.begin(), points.end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const LatticeVector point = points[i];
      for (int y = 0; y < cells_.scale; ++y)
        for (int x = 0; x < cells_.scale; ++x)
          sources({point[0] + x, point[1] + y}, [&](LatticeVector j, const Rational&) {
            if (seen.insert(j).second) points.push_back(j);
          });
      if (points.size() > kMostPoints)
        return Error{fmt::format("a cell of the lattice depends on more than {} control values",
                                 kMostPoints)};
    }
    return Done{};
  }

  void find_sizes() {
    for (std::size_t i = 3; i < cells_.points.size(); ++i) {
      const auto [x, y] = cells_.points[i];
      const int size = std::abs(x * (x - 1)) + std::abs(y * (y - 1)) + std::abs(2 * x * y);
      cells_.sizes.emplace_back(Integer(std::max(size, 1)), Integer(2));
    }
  }

  /// A refined value as combination of those at `points`.
  [[nodiscard]] std::vector<Rational> form(LatticeVector k) const {
    std::vector<Rational> row(cells_.points.size());
    sources(k, [&](LatticeVector j, const Rational& weight) { row[index_.at(j)] += weight; });
    return row;
  }

  /// What a form is of constants and of the two coordinates.
  [[nodiscard]] std::array<Rational, 3> on_affine(const std::vector<Rational>& row) const {
    std::array<Rational, 3> result;
    for (std::size_t i = 0; i < row.size(); ++i) {
      result[0] += row[i];
      result[1] += row[i] * Rational(cells_.points[i][0]);
      result[2] += row[i] * Rational(cells_.points[i][1]);
    }
    return result;
  }

  /// Its part in the residuals, scaled by their sizes.
  [[nodiscard]] std::vector<Rational> on_residuals(const std::vector<Rational>& row) const {
    std::vector<Rational> result(row.begin() + 3, row.end());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] *= cells_.sizes[i];
    return result;
  }

  static std::vector<Rational> difference(std::vector<Rational> a, const std::vector<Rational>& b,
                                          const Rational& factor = 1) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= factor * b[i];
    return a;
  }

  Status add_digit(LatticeVector digit) {
    std::vector<std::vector<Rational>> forms;
    forms.reserve(cells_.points.size());
    for (const LatticeVector point : cells_.points)
      forms.push_back(form({digit[0] + point[0], digit[1] + point[1]}));
    if (Status affine = check_affine(digit, forms); !affine) return affine;
    const std::vector<Rational> along_1 = difference(forms[1], forms[0]);
    const std::vector<Rational> along_2 = difference(forms[2], forms[0]);
    cells_.value.push_back(on_residuals(forms[0]));
    cells_.gradient.push_back({on_residuals(along_1), on_residuals(along_2)});
    RationalRows& residual = cells_.residual.emplace_back();
    for (std::size_t i = 3; i < forms.size(); ++i) {
      std::vector<Rational> row = difference(forms[i], forms[0]);
      row = difference(row, along_1, Rational(cells_.points[i][0]));
      row = difference(row, along_2, Rational(cells_.points[i][1]));
      row = on_residuals(row);
      for (Rational& entry : row) entry /= cells_.sizes[i - 3];
      residual.push_back(std::move(row));
    }
    return Done{};
  }

  /// Affine values must be refined to affine ones of the same gradient.
  Status check_affine(LatticeVector digit, const std::vector<std::vector<Rational>>& forms) {
    const Rational s(cells_.scale);
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const std::array<Rational, 3> found = on_affine(forms[i]);
      const LatticeVector k{digit[0] + cells_.points[i][0], digit[1] + cells_.points[i][1]};
      if (i == 0 && cells_.residual.empty()) cells_.shift = found[1];
      if (found[0] != 1 || found[1] != Rational(k[0]) / s + cells_.shift ||
          found[2] != Rational(k[1]) / s + cells_.shift)
        return Error{"the mask does not reproduce affine functions: its sum rules are of order 1"};
    }
    return Done{};
  }

  CellMatrices& cells_;
  std::map<LatticeVector, std::size_t> index_;
};

/// Where the values lie that refinements of a cell need, those of the first of two steps included.
void find_places(CellMatrices& cells, const Refinement& refinement) {
  const int half = cells.dual ? 1 : 0;
  const int growth = refinement.dilation.growth();
  cells.place_unit = 2 * cells.scale * (cells.steps == 2 ? growth : 1);
  const int unit = cells.place_unit;
  std::set<LatticeVector> places;
  for (const LatticeVector point : cells.points)
    for (int y = 0; y < cells.scale; ++y)
      for (int x = 0; x < cells.scale; ++x) {
        const LatticeVector k{point[0] + x, point[1] + y};
        const int per = unit / (2 * cells.scale);
        places.insert({(2 * k[0] + half) * per, (2 * k[1] + half) * per});
        if (cells.steps == 1) continue;
        // value k of the turned lattice weighs the first step's values j: turn k - M j in the mask
        const LatticeVector fine = refinement.turn.apply(k);
        for (const auto& [offset, weight] : refinement.one) {
          const auto j = refinement.dilation.divide({fine[0] - offset[0], fine[1] - offset[1]});
          if (!j) continue;
          // j lies at M^-1 j of the control lattice
          const LatticeVector at = refinement.dilation.apply_adjugate(*j);
          const int sign = refinement.dilation.determinant() < 0 ? -1 : 1;
          places.insert({sign * at[0] * (unit / growth), sign * at[1] * (unit / growth)});
        }
      }
  cells.places.assign(places.begin(), places.end());
}

/// The refined star's spokes: the sector's own, shorter, or those through its middle.
Status find_labels(CellMatrices& cells, const Refinement& refinement) {
  cells.one_mask = refinement.one;
  cells.dilation = refinement.dilation;
  cells.labels = {{{{1, 0}, {0, 1}}}};
  cells.turns = cells.steps > 1;
  if (!cells.turns) return Done{};
  const int growth = refinement.dilation.growth();
  const bool triangle = cells.lattice == Lattice::triangle;
  if (growth != (triangle ? 3 : 2))
    return Error{"a turned lattice of this growth is not known here"};
  // columns (s1 + s2)/growth and that turned by a sector
  const LatticeMatrix middle =
      triangle ? LatticeMatrix{{{{1, -1}, {1, 2}}}} : LatticeMatrix{{{{1, -1}, {1, 1}}}};
  cells.labels = times(refinement.dilation, middle);
  cells.label_divisor = growth;
  return Done{};
}

}  // namespace

Result<CellMatrices> cell_matrices(const Mask& mask, CellExtent extent) {
  const Result<Refinement> refinement = refinement_of(mask);
  if (!refinement) return refinement.error();
  CellMatrices cells;
  cells.lattice = mask.lattice;
  cells.dual = is_dual(mask);
  cells.scale = refinement->scale;
  cells.steps = refinement->steps;
  if (cells.dual && cells.steps > 1)
    return Error{"cells of dual masks that turn the lattice are not known here"};
  // refined value U k is called k, so that the lattice does not turn
  const LatticeMatrix& turn = refinement->turn;
  for (const auto& [k, value] : refinement->all) {
    const auto turned = turn.divide({k[0], k[1]});
    cells.mask[*turned] = value;
  }
  if (Status labelled = find_labels(cells, *refinement); !labelled) return labelled.error();
  if (Status made = CellMaker(cells, extent).make(); !made) return made.error();
  find_places(cells, *refinement);
  return cells;
}

}  // namespace limn::certify
