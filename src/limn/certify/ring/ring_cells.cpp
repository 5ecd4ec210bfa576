#include "limn/certify/ring/ring_cells.h"

#include <algorithm>
#include <cmath>

namespace limn::certify {
namespace {

constexpr int kWidestRing = 12;

/// Whether all that makes the surface on a cell is regular: no rule that it needs is anchored next
/// to the centre, and the control points that it weighs lie on one side of it.
bool is_regular(const CellMatrices& cells, LatticeVector p) {
  const int unit = cells.place_unit;
  int sectors_before = 0;
  int sectors_after = 0;
  const auto note = [&](int sector) {
    sectors_before += sector < 0 ? 1 : 0;
    sectors_after += sector > 0 ? 1 : 0;
  };
  for (const LatticeVector place : cells.places) {
    const auto found =
        turned_into_sector(cells.lattice, {p[0] * unit + place[0], p[1] * unit + place[1]});
    if (!found || gauge(cells.lattice, found->place) < (cells.dual ? unit / 2 : unit)) return false;
    note(found->sector);
  }
  const int half = cells.dual ? 1 : 0;
  for (const LatticeVector point : cells.points) {
    const auto found = turned_into_sector(
        cells.lattice, {2 * (p[0] + point[0]) + half, 2 * (p[1] + point[1]) + half});
    if (!found) return false;
    note(found->sector);
  }
  // three sectors of quads are more than half a turn
  return cells.lattice == Lattice::triangle || sectors_before == 0 || sectors_after == 0;
}

std::vector<LatticeVector> half_sector(const CellMatrices& cells, int inner) {
  const int outer = inner * cells.scale;
  std::vector<LatticeVector> result;
  const bool triangle = cells.lattice == Lattice::triangle;
  for (int i = 0; i <= outer; ++i)
    for (int j = 0; j <= i; ++j) {
      const bool inside = triangle ? i + j + 2 > inner && i + j < outer : i >= inner && i < outer;
      if (inside) result.push_back({i, j});
    }
  return result;
}

}  // namespace

Result<RingCells> ring_cells(const CellMatrices& cells) {
  for (int inner = 1; inner <= kWidestRing; ++inner) {
    std::vector<LatticeVector> list = half_sector(cells, inner);
    if (std::all_of(list.begin(), list.end(),
                    [&](LatticeVector p) { return is_regular(cells, p); }))
      return RingCells{inner, std::move(list)};
  }
  return Error{"no ring of cells near the vertex has regular rules all round it"};
}

CellSigns::Row CellSigns::sparse(const std::vector<Rational>& row) {
  Row result;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i] != 0) result.push_back({i, number::Ball(row[i])});
  return result;
}

number::Ball CellSigns::dot(const Row& row, const std::vector<number::Ball>& x) {
  number::Ball sum;
  for (const Entry& entry : row) sum.add_product(entry.value, x[entry.column]);
  return sum;
}

double CellSigns::error(const std::vector<double>& bound,
                        const std::vector<number::Ball>& residual) {
  double sum = 0;
  for (std::size_t j = 0; j < bound.size(); ++j)
    sum += bound[j] * std::max(residual[j].upper(), -residual[j].lower());
  return sum * (1 + 1e-12);
}

CellSigns::CellSigns(const CellMatrices& cells, const Contraction& bounds)
    : cells_(cells),
      bounds_(bounds),
      inverse_scale_(Rational(Integer(1), Integer(cells.scale))),
      quick_(cells, bounds) {
  for (std::size_t d = 0; d < cells.residual.size(); ++d) {
    residual_.emplace_back();
    for (const auto& row : cells.residual[d]) residual_.back().push_back(sparse(row));
    gradient_.push_back({sparse(cells.gradient[d][0]), sparse(cells.gradient[d][1])});
    value_.push_back(sparse(cells.value[d]));
    const int digit = static_cast<int>(d);
    const auto origin = [&](int x) {
      return number::Ball(Rational(Integer(x), Integer(cells.scale)) + cells.shift);
    };
    origin_.push_back({origin(digit % cells.scale), origin(digit / cells.scale)});
  }
  for (const Rational& size : cells.sizes) inverse_sizes_.emplace_back(Rational(1) / size);
}

Result<CellMap> CellSigns::map_on(EigenNet& net, LatticeVector cell) const {
  std::vector<NetPoint> points;
  for (const LatticeVector point : cells_.points) {
    Result<NetPoint> at = net.at({cell[0] + point[0], cell[1] + point[1]});
    if (!at) return at.error();
    points.push_back(std::move(*at));
  }
  CellMap map;
  const auto fill = [&](CellMap::Coordinate& to, auto&& of) {
    to.origin = of(points[0]);
    to.gradient = {of(points[1]) - to.origin, of(points[2]) - to.origin};
    for (std::size_t i = 3; i < points.size(); ++i) {
      const auto [x, y] = cells_.points[i];
      const number::Ball affine =
          to.origin + number::Ball(x) * to.gradient[0] + number::Ball(y) * to.gradient[1];
      to.residual.push_back((of(points[i]) - affine) * inverse_sizes_[i - 3]);
    }
  };
  fill(map.u, [](const NetPoint& p) { return p.u; });
  fill(map.v, [](const NetPoint& p) { return p.v; });
  return map;
}

CellMap::Coordinate CellSigns::part(const CellMap::Coordinate& map, std::size_t digit) const {
  CellMap::Coordinate result;
  result.origin = map.origin + origin_[digit][0] * map.gradient[0] +
                  origin_[digit][1] * map.gradient[1] + dot(value_[digit], map.residual);
  for (std::size_t i = 0; i < 2; ++i)
    result.gradient[i] = map.gradient[i] * inverse_scale_ + dot(gradient_[digit][i], map.residual);
  for (const Row& row : residual_[digit]) result.residual.push_back(dot(row, map.residual));
  return result;
}

CellMap CellSigns::part(const CellMap& map, std::size_t digit) const {
  return {part(map.u, digit), part(map.v, digit)};
}

number::Ball CellSigns::jacobian(const CellMap& map) const {
  const auto wide = [&](const CellMap::Coordinate& one, std::size_t i) {
    return one.gradient[i].widened(error(bounds_.gradient[i], one.residual));
  };
  return wide(map.u, 0) * wide(map.v, 1) - wide(map.u, 1) * wide(map.v, 0);
}

NetPoint CellSigns::values(const CellMap& map) const {
  // the cell is at 0 … 1 from its origin, or at -½ … ½ (dual)
  const number::Ball along =
      cells_.dual ? number::Ball::between(-0.5, 0.5) : number::Ball::between(0, 1);
  const auto of = [&](const CellMap::Coordinate& one) {
    const number::Ball affine = one.origin + along * one.gradient[0] + along * one.gradient[1];
    return affine.widened(error(bounds_.value, one.residual));
  };
  return {of(map.u), of(map.v)};
}

}  // namespace limn::certify
