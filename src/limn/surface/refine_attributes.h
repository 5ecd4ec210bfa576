#pragma once
/// Attributes on the way through refinement: the parts that refine_surface puts together.

#include <optional>
#include <vector>

#include "limn/fast/fast_refiner.h"
#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/attributes/texture_mesh.h"
#include "limn/refine/refine_columns.h"
#include "limn/scheme/scheme.h"
#include "limn/surface/refine_surface.h"

namespace limn::surface {

namespace detail {

/// Whether there are as many numbers, corners and labels as the mesh has vertices, half-edges and
/// faces.
[[nodiscard]] bool have_size_of(const Mesh& mesh, const MeshAttributes& attributes);

/// Numbers of vertices, three to a column; the last ones filled up with zeros.
[[nodiscard]] std::vector<refine::Column> packed(const std::vector<VertexNumbers>& numbers,
                                                 Index vertex_count);
/// From `first` on, the columns of what `numbers` was before; they have other values now.
[[nodiscard]] std::vector<VertexNumbers> unpacked(const std::vector<VertexNumbers>& numbers,
                                                  const std::vector<refine::Column>& columns,
                                                  std::size_t first);

/// The texture coordinates as one more column (u, v, 0), where the rules refine them like
/// positions: there are no seams, each face has them, and nothing else stays in place. Nothing
/// where that is not so.
[[nodiscard]] std::optional<refine::Column> texture_column(const Split& split, const Mesh& mesh,
                                                           const TextureCoordinates& texture,
                                                           TextureRule rule);
/// That column refined, as texture coordinates of a mesh, given the vertices of its corners.
[[nodiscard]] TextureCoordinates texture_of_column(std::vector<Index> corners,
                                                   const refine::Column& column, NumberType type);

/// Refines texture coordinates by the plain engine. `face_of`: of each face of the result, that of
/// the control mesh. Preconditions: check_takes_texture, `levels` > 0.
[[nodiscard]] Result<TextureCoordinates> refine_texture(const Scheme& scheme, const Mesh& control,
                                                        const Sharpness& sharpness,
                                                        const TextureCoordinates& texture,
                                                        TextureRule rule, int levels,
                                                        const std::vector<Index>& face_of);

/// Whether the quick engine refines texture coordinates that are no texture_column, as a mesh of
/// their own: not where they are linear or their boundary rests, nor where there is a reason
/// why_no_fast_sharpness (fast/fast_refiner.h). Cost O(control mesh).
[[nodiscard]] bool has_quick_texture(const Scheme& scheme, const Mesh& control,
                                     const Sharpness& sharpness, const TextureCoordinates& texture,
                                     TextureRule rule);
/// Refines them so, in the order of the quick engine's faces. Preconditions: that is so, and those
/// of refine_texture.
[[nodiscard]] Result<TextureCoordinates> quick_texture(const Scheme& scheme, const Mesh& control,
                                                       const Sharpness& sharpness,
                                                       const TextureCoordinates& texture,
                                                       TextureRule rule, int levels);

/// Of each face of the result, the face of the control mesh that it lies in. Cost O(F).
[[nodiscard]] std::vector<Index> parents_of(const FastRefiner& refiner);

/// Labels and material files of faces that lie in the control faces `face_of`.
void hand_down_labels(const MeshAttributes& control, const std::vector<Index>& face_of,
                      MeshAttributes& fine);

}  // namespace detail
}  // namespace limn::surface
