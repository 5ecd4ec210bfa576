#pragma once
/// One step of a star: which vertex of the refined mesh plays the part of which old one.

#include <vector>

#include "limn/mesh/lattice.h"
#include "limn/mesh/split/split.h"

namespace limn::refine {

/// The star round a vertex (the cropped star where a step turns quads by half a sector), or of a
/// dual split the face star (mesh/lattice.h), and its size. Rings of one kind only.
[[nodiscard]] Mesh split_star(const Split& split, Index n, Index rings);
/// The fewest rings that such a star can have, and that surround its centre: 1, of cropped stars 2.
[[nodiscard]] int least_star_rings(const Split& split);
[[nodiscard]] Index split_star_size(const Split& split, Index n, Index rings);

struct StarStep {
  Mesh coarse;  ///< the star (dual splits: face star) with a margin of rings round it
  SplitResult fine;
  Index size = 0;  ///< vertices of the star without its margin: numbers 0 … size-1 of `coarse`
  /// images[i]: the vertex of `fine` at the place of old vertex i < size, numbered as in
  /// `split_star`. Under sqrt3 and sqrt2 the refined star is turned by half a sector: its
  /// sector 0 looks along the old face 0.
  std::vector<Index> images;
};

/// n sectors as for `star` (mesh/lattice.h), rings ≥ least_star_rings. The margin is wide enough
/// that no image's stencil meets the rim.
[[nodiscard]] StarStep star_step(const Split& split, int n, int rings);

/// The same of a star or fan of sectors: one step, or two where the boundary moves in every second
/// one only.
struct SectorStep {
  Mesh coarse;
  std::vector<SplitResult> fine;
  Index size = 0;
  std::vector<Index> images;  ///< vertices of fine.back()
};

/// Sectors as for `sector_star`, of lattices that the split takes; rings ≥ 1. For splits that keep
/// the old vertices; of a closed star, those that do not turn.
[[nodiscard]] SectorStep sector_step(const Split& split, const mesh::Sectors& sectors, int rings);

}  // namespace limn::refine
