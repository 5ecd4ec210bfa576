#pragma once
/// Which rows of a matrix depend on one another. Sorted by its parts a matrix is block triangular,
/// so its eigenvalues are those of the parts' square matrices, which are small in a subdivision
/// matrix: what a point depends on mostly lies further in.

#include <Eigen/Dense>
#include <vector>

namespace limn::spectrum {

/// (i, j): entry (i, j) is not 0; or, of `reaches`, a path of such entries leads from i to j.
using BoolMatrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

struct ConnectedParts {
  std::vector<std::vector<Eigen::Index>> parts;  ///< rows, ascending; every row is in one part
  std::vector<std::size_t> part_of;              ///< by row
  BoolMatrix reaches;                            ///< each row reaches itself
};

/// Rows that reach each other are one part. Cost: at most rows² columns joined.
[[nodiscard]] ConnectedParts connected_parts(const BoolMatrix& entries);

/// The rows on paths from one of these rows to another, the ends included, ascending. The Jordan
/// blocks of eigenvalues that no other part has are those of the square matrix of these rows.
[[nodiscard]] std::vector<Eigen::Index> rows_between(const ConnectedParts& connected,
                                                     const std::vector<Eigen::Index>& ends);

}  // namespace limn::spectrum
