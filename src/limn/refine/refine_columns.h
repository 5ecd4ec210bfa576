#pragma once
/// Refinement of several values of one mesh at once, by the plain engine: positions and what else
/// vertices carry. Connectivity and weights are worked out once for all.

#include <vector>

#include "limn/refine/refine.h"

namespace limn::refine {

/// Three numbers for each vertex of a mesh.
using Column = std::vector<Point3>;

/// What is refined, and how.
struct Columns {
  std::vector<Column> smooth;  ///< by the scheme's rules, like positions
  std::vector<Column> linear;  ///< on each face by itself: see linear_step
};

struct ColumnOptions {
  bool parents = false;  ///< RefinedColumns::face_of is wanted
  /// The boundary stays as it is: its vertices rest, and new ones on it are refined linearly.
  bool straight_boundary = false;
  RefineProgress progress = {};
};

struct RefinedColumns {
  Mesh mesh;
  Columns columns;
  Sharpness sharpness;         ///< what is left of it
  std::vector<Index> face_of;  ///< of each face, that of the control mesh (parent_faces); or empty
};

/// The values of new vertices by interpolation alone: an old vertex keeps its value, a new one on
/// an edge has what lies there between its ends, one in a face the mean of its corners, and one
/// that is born from a corner lies on the way to that mean (split.h says where). Cost O(fine mesh).
[[nodiscard]] Column linear_step(const Split& split, const Mesh& mesh, const Births& births,
                                 const Column& old);

/// `levels` ≥ 0 steps; each column has a value for each vertex. Fails as `refine`.
[[nodiscard]] Result<RefinedColumns> refine_columns(const Scheme& scheme, Mesh mesh,
                                                    Columns columns, Sharpness sharpness,
                                                    int levels, const ColumnOptions& options = {});

}  // namespace limn::refine
