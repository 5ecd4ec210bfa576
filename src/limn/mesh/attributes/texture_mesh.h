#pragma once
/// Texture coordinates as a mesh of their own: the mesh cut along the seams, so that a scheme
/// refines them with its rules for boundaries and corners. The rules are those of USD and
/// OpenSubdiv, whose documentation is the reference.

#include <vector>

#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::mesh {

/// Whether the two faces of some edge name different points at an end of it. `of_corner`: by
/// half-edges of the mesh. Corners without a point have, at one vertex, the same. Cost O(H).
[[nodiscard]] bool has_seams(const Mesh& mesh, const TextureCoordinates& texture);

/// The faces and half-edges of a mesh, by the same numbers, with the points of the texture as
/// vertices.
struct TextureMesh {
  Mesh mesh;                   ///< with boundaries at seams
  std::vector<Point3> points;  ///< of each of its vertices, u, v and 0
  Sharpness sharpness;         ///< that of the mesh, and corners as the rule says
  /// Of each of its vertices the first that is the same vertex of the mesh with the same point of
  /// the texture: itself, but where fans apart from one another name one point. These rest. Empty
  /// where each is itself and has a face.
  std::vector<Index> first;
};
/// Of `boundaries` and `all`, which do not follow from corners alone, nothing is made a corner.
/// `texture` is not empty. Cost O(H).
[[nodiscard]] TextureMesh make_texture_mesh(const Mesh& mesh, const Sharpness& sharpness,
                                            const TextureCoordinates& texture, TextureRule rule);

/// Which faces have no texture coordinates, or not at each corner; empty: all have. Cost O(H).
[[nodiscard]] std::vector<bool> faces_without(const Mesh& mesh, const TextureCoordinates& texture);

/// The vertices of a texture mesh, refined or not, as texture coordinates, but of faces that are
/// `without`: polygons whose positions are u, v and 0. `first` is TextureMesh::first: what was one
/// point of the texture is one again. Points are numbered as vertices are, or, where some of these
/// are no point of their own or faces are without, as they are met. Cost O(H), O(V) in the first.
[[nodiscard]] TextureCoordinates texture_of(Polygons polygons, const std::vector<Index>& first,
                                            const std::vector<bool>& without, NumberType type);

}  // namespace limn::mesh
