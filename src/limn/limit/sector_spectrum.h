#pragma once
/// Eigenvalues at a vertex whose faces need not be alike, where no rotation makes blocks of the
/// matrix: all of it at once.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/truth.h"
#include "limn/limit/sector_matrix.h"

namespace limn::limit {

/// The spectrum of a star of sectors and what it says. A C1 surface needs more than `c1_necessary`:
/// a characteristic map that is regular and injective, and C1 surfaces where all is regular and
/// along the seams; none of that is looked at here.
struct SectorSpectrum {
  SectorMatrix matrix;
  std::vector<std::complex<double>> eigenvalues;  ///< all, largest modulus first
  /// The two that lead all others but 1, the larger one first, where they are real and have two
  /// eigenvectors; nothing elsewhere. Unlike at a vertex of n equal faces they may differ.
  std::optional<std::array<double, 2>> tangent;
  Truth convergent = Truth::undecided;    ///< 1 is simple, all others are smaller
  Truth c1_necessary = Truth::undecided;  ///< two lead all others but 1
  std::vector<std::string> reasons;       ///< of each no and undecided
};

/// Of a closed star. In double precision. Fails as sector_matrix does, and where the scheme's split
/// does not take such faces, has no old vertices or turns. Cost: the cube of the matrix's size.
[[nodiscard]] Result<SectorSpectrum> approx_sector_spectrum(const Scheme& scheme,
                                                            const mesh::Sectors& sectors);

}  // namespace limn::limit
