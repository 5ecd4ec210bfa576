#pragma once
/// The surface that a scheme makes of a control mesh: refined points, points of the limit surface,
/// normals, curvatures. The front of refinement: it chooses the engine. For the same mesh at many
/// positions see fast/fast_refiner.h.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/limit/limit_points.h"
#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/scheme/scheme.h"

namespace limn {

// What a mesh carries, refined: the choices, and what a scheme can take.

/// What becomes of attributes.
struct AttributeRules {
  bool linear = false;  ///< numbers of vertices: on each face by itself, not by the scheme's rules
  TextureRule texture = TextureRule::corners_plus1;  ///< what of texture coordinates stays in place
};

/// Whether a scheme can refine these texture coordinates. Where they have seams, its split must
/// keep old edges, and unless the rule is `all` it must have rules for boundaries; the error names
/// what is missing and a way out.
[[nodiscard]] Status check_takes_texture(const Scheme& scheme, const Mesh& mesh,
                                         const TextureCoordinates& texture, TextureRule rule);

// The vertices at which something asked of a limit surface cannot be had.

/// Vertices at which something is missing, in ascending order.
struct LimitGaps {
  std::vector<LimitPoints::Refused> limits;  ///< without a limit point, and why
  std::vector<Index> normals;                ///< without a normal
  /// Vertices that have no curvature for one reason.
  struct Curvatures {
    NoCurvature reason;           ///< why
    std::vector<Index> vertices;  ///< where
  };
  std::vector<Curvatures> curvatures;  ///< by reason

  /// Whether anything is missing anywhere.
  [[nodiscard]] bool any() const {
    return !limits.empty() || !normals.empty() || !curvatures.empty();
  }
};

/// The vertices whose normal is zero.
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals);
/// The same where vertices may have several sides: those of which one has no normal. Cost O(H).
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals,
                                                const Mesh& mesh, const SideNormals& sides);
/// The vertices that have no curvature, by reason.
[[nodiscard]] std::vector<LimitGaps::Curvatures> without_curvature(
    const std::vector<NoCurvature>& reasons);

/// What is wanted.
struct SurfaceOptions {
  int levels = 3;           ///< refinement steps, at least 0
  bool limit = false;       ///< RefinedSurface::limit
  bool normals = false;     ///< RefinedSurface::normals
  bool curvatures = false;  ///< RefinedSurface::curvatures
  /// Where the limit, a normal or a curvature cannot be had at some vertices, give the rest and
  /// list those in RefinedSurface::gaps; a vertex that has no limit stays where refinement puts it.
  /// False: a limit that cannot be had is an error.
  bool partial = false;
  bool connectivity = false;  ///< RefinedSurface::mesh, too
  /// Of the control mesh. Where there is a reason why_no_fast_sharpness (fast/fast_refiner.h), the
  /// plain engine refines it, whatever `engine` says; and where something is sharp that stays so,
  /// it finds what is wanted of the limit surface.
  Sharpness sharpness = {};
  /// What the control mesh carries, by its numbers of vertices, half-edges and faces; or null. They
  /// fit it (attributes_fit); an error where their counts do not. Linear numbers, linear texture
  /// coordinates and those whose boundary stays, and labels under √3, √2 and dual splits need the
  /// plain engine, whatever `engine` says.
  const MeshAttributes* attributes = nullptr;
  AttributeRules attribute_rules = {};  ///< how they are refined
  /// quick: the quick engine (fast/fast_refiner.h) where it can, else the plain one; plain: the
  /// plain one. The same surface to rounding, its vertices and faces in another order.
  enum class Engine { quick, plain };
  Engine engine = Engine::quick;  ///< which one
  /// Called now and then with what is being done.
  std::function<void(const std::string& what)> progress = {};

  /// Whether anything is wanted of the limit surface.
  [[nodiscard]] bool of_limit() const { return limit || normals || curvatures; }
  /// Whether there is anything in `sharpness`.
  [[nodiscard]] bool has_sharpness() const { return sharpness.any() || sharpness.has_holes(); }
};

/// What `refine_surface` makes.
struct RefinedSurface {
  /// The refined mesh, with the points where refinement puts them; without the faces of holes, and
  /// without vertices that have no other faces.
  Polygons polygons;
  std::optional<Mesh> mesh;  ///< its connectivity, where that is wanted; with the faces of holes
  SharpnessTags sharp;       ///< what of it is still sharp, by the numbers of `polygons`
  /// Where the vertices are on the limit surface: one for each, or empty where not wanted.
  std::vector<Point3> limit;
  /// What it carries: numbers of vertices and texture coordinates where refinement puts them (not
  /// the limit surface's), labels of the control faces that its faces lie in.
  MeshAttributes attributes;
  /// The limit surface's, of length 1; zero where there is none, and of vertices that have several
  /// sides. One for each vertex, or empty.
  std::vector<Point3> normals;
  SideNormals sides;  ///< normals of vertices with several sides, by corners of `polygons`
  /// The limit surface's principal ones; NaN where there are none. One for each vertex, or empty.
  std::vector<LimitPoints::Curvatures> curvatures;
  /// What the regular lattice lets curvatures be; where that is unbounded there are none at all.
  RegularPart regular_part;
  LimitGaps gaps;                 ///< what is missing, and at which vertices
  double refinement_seconds = 0;  ///< without what was found of the limit after it
};

/// Whether the quick engine refines this, as far as can be told at once.
[[nodiscard]] bool is_quick(const Scheme& scheme, const Mesh& control,
                            const SurfaceOptions& options);

/// In double precision. Fails, with an error that says so, where the scheme needs triangles and the
/// mesh has others, where a rule is missing that the mesh needs (boundary rules, valences), where
/// 2^31 half-edges or the memory that there is are exceeded, where the scheme cannot take the
/// sharpness (check_takes_sharpness, refine/crease_step.h) or the texture coordinates
/// (check_takes_texture), and where the limit cannot be had (but see `partial`). Cost: some
/// nanoseconds a refined vertex by the quick engine, about a hundred by the plain one; curvatures
/// some microseconds.
[[nodiscard]] Result<RefinedSurface> refine_surface(const Scheme& scheme, Mesh control,
                                                    std::vector<Point3> points,
                                                    const SurfaceOptions& options = {});

}  // namespace limn
