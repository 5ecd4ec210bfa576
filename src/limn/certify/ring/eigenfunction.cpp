#include "limn/certify/ring/eigenfunction.h"

namespace limn::certify {
namespace {

constexpr int kMostCuts = 2;

bool is_somewhere_nonzero(const QuickCells& quick, const QuickCells::Map& map, std::size_t parts,
                          int cuts) {
  const QuickCells::Values at = quick.values(map);
  if (!at.u.holds_zero() || !at.v.holds_zero()) return true;
  for (std::size_t d = 0; d < parts && cuts > 0; ++d)
    if (is_somewhere_nonzero(quick, quick.part(map, d), parts, cuts - 1)) return true;
  return false;
}

}  // namespace

EigenMap::EigenMap(const ValenceBalls& balls, const CellMatrices& cells, int frequency,
                   const EnclosedPair& pair)
    : whole(balls.whole_vector(frequency, pair)),
      phase(balls.phase(frequency)),
      net(cells, balls.basis(), whole.pair, phase, whole.center) {}

bool Effective::is_shown(int frequency, const EnclosedPair& pair) const {
  const Result<RingCells> ring = ring_cells(cells_);
  if (!ring || pair.value.holds_zero()) return false;
  EigenMap map(balls_, cells_, frequency, pair);
  for (int cuts = 0; cuts <= kMostCuts; ++cuts)
    for (const LatticeVector cell : ring->cells) {
      const Result<CellMap> whole = signs_.map_on(map.net, cell);
      if (!whole) return false;
      if (is_somewhere_nonzero(signs_.quick(), signs_.quick().map_of(*whole),
                               cells_.residual.size(), cuts))
        return true;
    }
  return false;
}

bool Effective::is_shown(int frequency, double value) const {
  const number::BallMatrix block = balls_.block(frequency);
  const ApproxPair near = approx_nearest(block, value);
  const Result<EnclosedPair> pair = enclose_eigenpair(block, value, near.vector);
  return pair.ok() && is_shown(frequency, *pair);
}

}  // namespace limn::certify
