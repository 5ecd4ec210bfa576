#include "limn/certify/ring/eigen_net.h"

#include <algorithm>

namespace limn::certify {
namespace {

constexpr int kDeepest = 40;

/// The refined value at label k of the refined star's sector 0, as the mask numbers it.
LatticeVector label_of(const CellMatrices& cells, LatticeVector k) {
  LatticeVector fine = cells.labels.apply(k);
  for (int& coordinate : fine) coordinate /= cells.label_divisor;
  return fine;
}

/// The same as turned_into_sector, of places on the second spoke round, too, on triangles, where
/// one way to it is shorter than the other: a face at the centre may weigh what lies over its
/// edges.
std::optional<SectorPlace> turned_to_spoke(Lattice lattice, LatticeVector place) {
  std::optional<SectorPlace> found = turned_into_sector(lattice, place);
  const auto [x, y] = place;
  if (found || lattice != Lattice::triangle) return found;
  if (x + y == 0 && y > 0) return SectorPlace{2, {y, 0}};
  if (x == 0 && y < 0) return SectorPlace{-2, {-y, 0}};
  return std::nullopt;
}

NetPoint turned(const NetPoint& p, const Turn<number::Ball>& by) {
  return {p.u * by.cosine - p.v * by.to_real, p.u * by.to_imaginary + p.v * by.cosine};
}

/// What one step's coordinates are multiplied by: 1/λ, turned back where the star turns.
Turn<number::Ball> outwards(const CellMatrices& cells, const number::Ball& eigenvalue,
                            const Phase<number::Ball>& phase) {
  const Turn<number::Ball> back =
      cells.turns ? phase(-1, 2) : Turn<number::Ball>({number::Ball(1), number::Ball(0)});
  return {back.cosine / eigenvalue, back.to_imaginary / eigenvalue, back.to_real / eigenvalue};
}

}  // namespace

std::pair<int, int> ring_and_place(const CellMatrices& cells, LatticeVector j) {
  const auto [x, y] = j;
  if (cells.lattice == Lattice::triangle) return {x + y, y};
  const int ring = std::max(x, y);
  // the rings of cropped stars (mesh/lattice.h): a square's corner is in the next ring
  if (cells.turns && x == y) return {ring + 1, ring + 1};
  const int place = x == ring ? y : 2 * ring - x;
  // dual: counted from the spoke, while orbits are from the corner
  return cells.dual ? std::pair{ring + 1, place - ring} : std::pair{ring, place};
}

std::vector<std::pair<LatticeVector, Rational>> sources_of(const CellMatrices& cells,
                                                           LatticeVector k) {
  std::vector<std::pair<LatticeVector, Rational>> result;
  const LatticeVector fine = label_of(cells, k);
  for (const auto& [offset, weight] : cells.one_mask)
    if (const auto j = cells.dilation.divide({fine[0] - offset[0], fine[1] - offset[1]}))
      result.emplace_back(*j, weight);
  return result;
}

bool is_near_center(const CellMatrices& cells, LatticeVector k) {
  if (cells.dual) return std::max(k[0], k[1]) < 1;  // at (k + ½)/2
  const LatticeVector at = cells.dilation.apply_adjugate(label_of(cells, k));
  const int sign = cells.dilation.determinant() < 0 ? -1 : 1;
  const auto found = turned_into_sector(cells.lattice, {sign * at[0], sign * at[1]});
  return !found || gauge(cells.lattice, found->place) < cells.dilation.growth();
}

int gauge(Lattice lattice, LatticeVector place) {
  return lattice == Lattice::triangle ? place[0] + place[1] : std::max(place[0], place[1]);
}

std::optional<SectorPlace> turned_into_sector(Lattice lattice, LatticeVector place) {
  const bool triangle = lattice == Lattice::triangle;
  const auto [x, y] = place;
  if (x == 0 && y == 0) return SectorPlace{0, place};
  if (x > 0 && y >= 0) return SectorPlace{0, place};
  if (y < 0) {
    const LatticeVector back{-y, triangle ? x + y : x};
    if (back[1] >= 0) return SectorPlace{-1, back};
    return std::nullopt;
  }
  const LatticeVector on{triangle ? x + y : y, -x};
  if (on[0] > 0) return SectorPlace{1, on};
  return std::nullopt;
}

EigenNet::EigenNet(const CellMatrices& cells, const RealBasis& basis, const EnclosedPair& pair,
                   const Phase<number::Ball>& phase, number::Ball center)
    : cells_(cells),
      basis_(basis),
      pair_(pair),
      phase_(phase),
      center_(std::move(center)),
      factor_(outwards(cells, pair.value, phase)) {}

Result<NetPoint> EigenNet::at(LatticeVector j) { return at(j, 0); }

Result<NetPoint> EigenNet::at(LatticeVector j, int depth) {
  const int half = cells_.dual ? 1 : 0;
  const auto found = turned_to_spoke(cells_.lattice, {2 * j[0] + half, 2 * j[1] + half});
  if (!found) return Error{"a control point lies more than a sector away"};
  const LatticeVector inside{(found->place[0] - half) / 2, (found->place[1] - half) / 2};
  Result<NetPoint> point = in_sector(inside, depth);
  if (!point || found->sector == 0) return point;
  return turned(*point, phase_(found->sector, 1));
}

Result<NetPoint> EigenNet::in_sector(LatticeVector j, int depth) {
  if (!cells_.dual && j == LatticeVector{0, 0}) return NetPoint{center_, number::Ball(0)};
  if (const auto known = known_.find(j); known != known_.end()) return known->second;
  const auto [ring, place] = ring_and_place(cells_, j);
  if (depth > kDeepest) return Error{"control points do not follow from inner ones"};
  Result<NetPoint> point = ring <= basis_.rings
                               ? Result<NetPoint>(from_amplitude(basis_.orbit(ring, place)))
                               : extended(j, depth + 1);
  if (point && ring <= basis_.rings) {
    const RealOrbit& orbit = basis_.orbits[basis_.orbit(ring, place)];
    point = turned(*point, phase_(place, orbit.size));
  }
  if (point) known_.emplace(j, *point);
  return point;
}

NetPoint EigenNet::from_amplitude(std::size_t number) const {
  const RealOrbit& orbit = basis_.orbits[number];
  const number::Ball& p = pair_.vector[orbit.real];
  if (orbit.real == orbit.imaginary) return {p, number::Ball(0)};
  const number::Ball& q = pair_.vector[orbit.imaginary];
  return {p, orbit.reflected ? -q : q};
}

Result<NetPoint> EigenNet::extended(LatticeVector k, int depth) {
  if (is_near_center(cells_, k)) return Error{"a control point next to the centre is missing"};
  NetPoint sum;
  for (const auto& [j, weight] : sources_of(cells_, k)) {
    Result<NetPoint> source = at(j, depth);
    if (!source) return source;
    const number::Ball by(weight);
    sum.u.add_product(by, source->u);
    sum.v.add_product(by, source->v);
  }
  return turned(sum, factor_);
}

}  // namespace limn::certify
