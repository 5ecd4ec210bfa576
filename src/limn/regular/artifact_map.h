#pragma once
/// The magnitudes of all components in the limit over a rectangle of frequencies, quickly: the
/// symbols are sums over rows of the lattice, and in each row the two coordinates of the frequency
/// separate, so that no cosine is evaluated per point.

#include "limn/regular/artifacts.h"

namespace limn::regular {

/// Frequencies (x0 + i dx, y0 + j dy), 0 ≤ i < nx, 0 ≤ j < ny.
struct FrequencyGrid {
  double x0 = 0, y0 = 0, dx = 0, dy = 0;
  int nx = 0, ny = 0;
};

/// nx × ny frequencies at the centres of equal cells that fill the bounding box of the Nyquist
/// region.
[[nodiscard]] FrequencyGrid nyquist_grid(Lattice lattice, int nx, int ny);

/// map[c][j * nx + i]: component c (the signal, then the artifacts) at frequency (i, j), as
/// ArtifactAnalysis::in_limit gives it to about 1e-14; of dual splits the artifacts up to sign.
/// One thread. Precondition: limit_status().ok().
[[nodiscard]] std::vector<std::vector<double>> limit_map(const ArtifactAnalysis& analysis,
                                                         const FrequencyGrid& grid);

}  // namespace limn::regular
