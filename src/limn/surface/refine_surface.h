#pragma once
/// The surface that a scheme makes of a control mesh: refined points or points of the limit
/// surface, normals, curvatures. The front of refinement: it chooses the engine. For the same mesh
/// at many positions see fast/fast_refiner.h, for values other than points refine/refine.h.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/limit/limit_points.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"
#include "limn/surface/limit_gaps.h"

namespace limn {

/// What is wanted.
struct SurfaceOptions {
  int levels = 3;           ///< refinement steps, at least 0
  bool limit = false;       ///< vertices on the limit surface, not where refinement puts them
  bool normals = false;     ///< unit normals of the limit surface at the vertices
  bool curvatures = false;  ///< principal curvatures of the limit surface at the vertices
  /// Where the limit, a normal or a curvature cannot be had at some vertices, give the rest and
  /// list those in RefinedSurface::gaps. False: a limit that cannot be had is an error.
  bool partial = false;
  bool connectivity = false;  ///< RefinedSurface::mesh, too
  /// quick: the quick engine (fast/fast_refiner.h) where it can, else the plain one; plain: the
  /// plain one. The same surface to rounding, its vertices and faces in another order.
  enum class Engine { quick, plain };
  Engine engine = Engine::quick;  ///< which one
  /// Called now and then with what is being done.
  std::function<void(const std::string& what)> progress = {};

  /// Whether anything is wanted of the limit surface.
  [[nodiscard]] bool of_limit() const { return limit || normals || curvatures; }
};

/// What `refine_surface` makes.
struct RefinedSurface {
  Polygons polygons;            ///< the refined mesh; positions as the options ask
  std::optional<Mesh> mesh;     ///< of `polygons`, where connectivity is wanted
  std::vector<Point3> normals;  ///< one per vertex, zero where there is none; empty unless wanted
  /// One per vertex, NaN where there is none; empty unless wanted.
  std::vector<LimitPoints::Curvatures> curvatures;
  /// What the regular lattice lets curvatures be; where that is unbounded there are none at all.
  RegularPart regular_part;
  LimitGaps gaps;                 ///< what is missing, and at which vertices
  double refinement_seconds = 0;  ///< without what was found of the limit after it
};

/// In double precision. Fails, with an error that says so, where the scheme needs triangles and the
/// mesh has others, where a rule is missing that the mesh needs (boundary rules, valences), where
/// 2^31 half-edges or the memory that there is are exceeded, and where the limit cannot be had
/// (but see `partial`). Cost: some nanoseconds a refined vertex by the quick engine, about a
/// hundred by the plain one; curvatures some microseconds.
[[nodiscard]] Result<RefinedSurface> refine_surface(const Scheme& scheme, Mesh control,
                                                    std::vector<Point3> points,
                                                    const SurfaceOptions& options = {});

}  // namespace limn
