#pragma once
/// Limit positions and normals at the vertices of a mesh, for any scheme, boundaries included.

#include <functional>
#include <string>
#include <vector>

#include "limn/extraordinary/limit_stencil.h"
#include "limn/mesh/mesh.h"

namespace limn {

struct LimitPoints {
  std::vector<Point3> positions;  ///< one per vertex
  /// Unit normals, by the faces' orientation. Zero at an isolated vertex and where the tangents
  /// vanish or are parallel. Where no tangent plane follows from the eigenvectors, that of the
  /// faces round the vertex some steps on.
  std::vector<Point3> normals;
  /// Principal curvatures, the larger first, of the quadratic surface that the tangents, the cup
  /// and the saddles make (limit_curvature.h); positive where the surface bends towards its normal.
  /// NaN at the boundary and where curvature is not bounded: by the eigenvalues of the vertex, and
  /// everywhere where LimitOptions says so of the regular surface.
  struct Curvatures {
    double largest, smallest;
  };
  std::vector<Curvatures> curvatures;  ///< empty unless asked for
};

struct LimitOptions {
  int steps_made = 0;  ///< that led to the mesh: the boundary of sqrt3 moves in every second one
  bool curvatures = false;
  RegularPart regular = {};  ///< of the scheme; where its curvature is unbounded none is given
  std::vector<Index> vertices = {};  ///< only these; empty: all. The results of others are zero
  /// False where the mesh was cut out of a larger one: what hangs on its boundary then has no
  /// meaning, and no boundary rules are needed.
  bool boundary = true;
  std::function<void(int left)> progress = {};  ///< vertices still to do
};

/// Limit points of the surface whose control points are `values`, one per vertex of `mesh`. Each is
/// a limit stencil on a neighbourhood that is regular but for its centre. Where others are near (in
/// a coarse mesh) the neighbourhood is refined until it is. A vertex of a dual split's mesh is
/// taken to the centre of its face after one step, at the boundary to the nearest such point of the
/// surface. In double precision. Fails as the limit stencils and `refine` do. Cost O(vertices) and
/// some steps round the vertices that are near irregular ones.
[[nodiscard]] Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                                      const std::vector<Point3>& values,
                                                      const LimitOptions& options = {});

}  // namespace limn
