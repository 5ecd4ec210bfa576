#pragma once
/// A refined mesh written while it is made (`refine_surface` and `write_mesh` in one), so that it
/// may be larger than the memory.

#include <optional>
#include <string>

#include "limn/mesh/io/mesh_pieces.h"
#include "limn/surface/refine_surface.h"

namespace limn::surface {

/// What was written.
struct RefinedFile {
  std::size_t vertices = 0, faces = 0;
  SharpnessTags sharp;            ///< what is still sharp, by the numbers of its vertices
  LimitGaps gaps;                 ///< what is missing, and at which vertices
  double refinement_seconds = 0;  ///< without writing: of the last step, its share of the time
};

/// Whether `write_refined` may be able to, as far as can be told at once: the quick engine, no
/// curvatures, no connectivity, no sharpness, no attributes, and a file that takes pieces
/// (mesh_pieces.h).
[[nodiscard]] bool may_write_refined(const Scheme& scheme, const SurfaceOptions& options,
                                     const std::string& path, const std::string& extension);

/// Refines a mesh into a file, whole or not at all; the positions are limit points where the
/// options ask for these, the vertices have normals where they ask for those. The bytes are those
/// of refine_surface's mesh by write_mesh. Nothing, and no file, where this way does not lead there
/// (the plain engine is needed, or there is no quick limit); the other one will then. Precondition:
/// may_write_refined. Fails as those two; of memory only what FastPieces::estimate
/// (fast_pieces.h) tells must be there.
[[nodiscard]] Result<std::optional<RefinedFile>> write_refined(const Scheme& scheme,
                                                               const Mesh& control,
                                                               const std::vector<Point3>& points,
                                                               const SurfaceOptions& options,
                                                               const std::string& path);

}  // namespace limn::surface
