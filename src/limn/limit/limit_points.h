#pragma once
/// Limit positions and normals at the vertices of a mesh, for any scheme, boundaries included.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/polygons.h"
#include "limn/scheme/mask.h"
#include "limn/scheme/scheme.h"

namespace limn {

// Normals of vertices that have several sides.

/// Along a crease, and at a corner where creases meet, a surface has a normal on each side. They
/// are given corner by corner; a vertex with one side has its normal elsewhere.
struct SideNormals {
  std::vector<Point3> normals;   ///< of length 1; zero where a side has none
  std::vector<Index> of_corner;  ///< the one of each corner; kNone: its vertex's own. May be empty

  /// Whether no vertex has several sides.
  [[nodiscard]] bool empty() const { return normals.empty(); }
};

// Why a vertex of a limit surface has no curvature.

/// Why a vertex has no curvature.
enum class NoCurvature : char {
  none,         ///< it has one
  boundary,     ///< it lies on the boundary
  no_limit,     ///< it has no limit point, or no faces
  no_normal,    ///< its tangents vanish or are parallel, or there is no tangent pair
  unbounded,    ///< by the eigenvalues of the vertex: it grows towards it, or may
  regular,      ///< the scheme's regular surface has unbounded curvature everywhere
  direction,    ///< bounded, with another value from each side: second derivatives jump there
  not_regular,  ///< its neighbourhood never becomes regular (dual splits, beside the boundary)
  unknown,      ///< what it would follow from cannot be had
  too_large,    ///< not a number in double precision
};
/// In words, as a clause that a warning ends with.
[[nodiscard]] std::string_view to_string(NoCurvature reason);

/// What `approx_limit_points` finds: arrays with an entry for each vertex of the mesh.
struct LimitPoints {
  std::vector<Point3> positions;  ///< one per vertex
  /// Unit normals, by the faces' orientation; they do not depend on the size of the model. Zero
  /// where there is none: at an isolated vertex, at an interior one of valence 2, and where the
  /// tangents vanish or are parallel, to rounding. Where no tangent plane follows from the
  /// eigenvectors, that of the faces round the vertex some steps on.
  std::vector<Point3> normals;
  /// Principal curvatures of the quadratic surface that the tangents, the cup
  /// and the saddles make (limit_curvature.h); positive where the surface bends towards its normal.
  /// NaN where there is none, for which `no_curvature` has the reason.
  struct Curvatures {
    double largest;   ///< 1/length
    double smallest;  ///< 1/length, at most `largest`
  };
  std::vector<Curvatures> curvatures;     ///< empty unless asked for
  std::vector<NoCurvature> no_curvature;  ///< why a vertex has none; as many as `curvatures`
  /// A vertex without a limit. It stays where it is and has no normal.
  struct Refused {
    Index vertex;        ///< of the mesh
    std::string reason;  ///< one sentence
  };
  std::vector<Refused> refused;  ///< by ascending vertex; empty unless LimitOptions::partial
};

/// What is asked of `approx_limit_points`.
struct LimitOptions {
  int steps_made =
      0;  ///< at least 0, that led to the mesh: the boundary of sqrt3 moves in every second one
  bool curvatures = false;   ///< fill LimitPoints::curvatures
  RegularPart regular = {};  ///< of the scheme; where its curvature is unbounded none is given
  std::vector<Index> vertices = {};  ///< only these; empty: all. The results of others are zero
  /// False where the mesh was cut out of a larger one: what depends on its boundary then has no
  /// meaning, and no boundary rules are needed.
  bool boundary = true;
  /// Where a limit cannot be had at some vertices (the scheme does not converge there, or what
  /// controls them is too large), give those of the others. A missing rule is an error all the
  /// same.
  bool partial = false;
  std::function<void(int left)> progress = {};  ///< vertices still to do
};

/// Limit points of the surface whose control points are `values`, one per vertex of `mesh`. Each is
/// a limit stencil on a neighbourhood that is regular but for its centre. Where others are near (in
/// a coarse mesh) the neighbourhood is refined until it is. A vertex of a dual split's mesh is
/// taken to the centre of its face after one step, at the boundary to the nearest such point of the
/// surface. In double precision. Fails as the limit stencils do, and, naming the vertex, where its
/// limit depends on a rule that the scheme does not have: boundary rules are needed only where the
/// mesh has a boundary. A curvature that is not known takes nothing from the rest. Cost O(vertices)
/// and some steps round the vertices that are near irregular ones.
[[nodiscard]] Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                                      const std::vector<Point3>& values,
                                                      const LimitOptions& options = {});

}  // namespace limn
