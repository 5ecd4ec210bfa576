#pragma once
/// Which properties of a PLY file are what: positions, attributes, sharpness, or left out; and the
/// bytes of attributes as they are written.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_header.h"

namespace limn::io {

/// Whether it is the list of a face's (or strip's) vertices.
bool is_index_list(const PlyProperty& property);
/// 0, 1, 2 for x, y, z; else -1.
int axis_of(const PlyProperty& property);
/// Whether it is 'face' or 'tristrips'.
bool holds_faces(const PlyElement& element);
/// The properties of an edge that are read: vertex1, vertex2, sharpness; -1: none of them.
int edge_role_of(const PlyProperty& property);
/// Whether these are edges with all of them.
bool holds_sharpness(const PlyElement& element);
/// The list of the texture coordinates of a face's corners, 'texcoord'; or null.
const PlyProperty* corner_texture(const PlyElement& element);

/// Says what of the header's properties is not kept, with or without attributes.
void remark_what_is_left_out(const PlyHeader& header, bool attributes, Remarks& remarks);

/// Where the numbers of a vertex go: x, y, z first, then the columns, then u and v.
class PlyVertexLayout {
 public:
  PlyVertexLayout(const PlyElement& element, const PlyHeader& header, bool attributes);

  /// How many numbers a vertex has.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The place of a property among them; -1: it is not read.
  [[nodiscard]] int place(std::size_t property) const { return places_[property]; }
  /// Makes the columns.
  void begin(MeshAttributes& attributes) const;
  /// Adds the numbers of a vertex.
  void add(const std::vector<double>& numbers, MeshAttributes& attributes) const;

 private:
  std::vector<int> places_;
  std::vector<VertexNumbers> columns_;  // without values
  std::optional<NumberType> texture_;   // there are u and v
  std::size_t size_ = 3;
};
/// Once faces and vertices are read: corners have the points of their vertices, or those that the
/// faces gave them, joined where they are equal.
void finish_ply_texture(const PlyHeader& header, const Polygons& mesh, MeshAttributes& attributes);

/// What the records of vertices and faces have at their ends.
class PlyExtras {
 public:
  /// Both must outlive it.
  PlyExtras(const Polygons& mesh, const MeshAttributes& attributes);

  [[nodiscard]] bool has_vertex_properties() const;
  [[nodiscard]] bool has_face_properties() const;
  /// Lines of the header.
  [[nodiscard]] std::string vertex_properties() const;
  [[nodiscard]] std::string face_properties() const;
  void append_vertex(std::string& out, Index vertex) const;
  void append_face(std::string& out, Index face) const;

 private:
  [[nodiscard]] const TextureCoordinates& texture() const { return attributes_.texture; }

  const Polygons& mesh_;
  const MeshAttributes& attributes_;
  bool wide_ = false;             // lists may have more than 255 numbers
  std::vector<Index> of_vertex_;  // the one point of each vertex; empty: corners differ
};

}  // namespace limn::io
