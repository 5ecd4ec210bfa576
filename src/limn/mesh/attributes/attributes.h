#pragma once
/// What the vertices, corners and faces of a mesh carry beside positions: numbers of vertices
/// (colours, temperatures, weights), texture coordinates with seams, and names of faces (groups,
/// objects, materials, smoothing groups). It travels beside `Polygons`, by the same numbers of
/// vertices, corners and faces, and every reader, repair, refinement and writer hands it on:
///
///     const Result<MeshFile> file = read_mesh_file("head.obj", {.attributes = true});
///     file->attributes.texture.of_corner[c]   // the texture coordinates of corner c
///     auto fine = refine_surface(scheme, mesh, points, {.attributes = &file->attributes});
///     write_mesh("fine.obj", fine->polygons, {.attributes = fine->attributes});
///
/// *Numbers of vertices* are columns, one for each number, under the names that PLY files use:
/// `red`, `green`, `blue`, `alpha` are the colour. They are refined like coordinates of positions.
///
/// *Texture coordinates* belong to corners: each corner names one of a list of points (u, v). An
/// edge whose two faces name different points at an end is a *seam*: the texture is cut there. What
/// counts is which point is named, not where it lies. u runs to the right and v up; files that have
/// it otherwise (glTF) are turned over as they are read and written.
///
/// *Labels* are names of faces, one of each kind at most.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn {

// How texture coordinates are refined where the texture ends.

/// What stays in place where the texture ends, at seams and boundaries. The names are USD's.
enum class TextureRule : std::uint8_t {
  none,           ///< nothing: seams and boundaries are curves
  corners_only,   ///< points that one face has
  corners_plus1,  ///< and points of vertices where three charts or more meet, or where a sharp edge
                  ///< ends at a seam or the same point is on both sides
  corners_plus2,  ///< and the ends of seams, and both points where one of two is a corner
  boundaries,     ///< all of seams and boundaries: they stay straight
  all             ///< everything: texture coordinates are linear on each face
};
/// Their names: "none", "cornersOnly", "cornersPlus1", "cornersPlus2", "boundaries", "all".
[[nodiscard]] const std::vector<std::pair<std::string, TextureRule>>& texture_rules();

/// How files store a number. In memory all are doubles.
enum class NumberType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// Numbers of the vertices, one for each.
struct VertexNumbers {
  std::string name;                       ///< as a PLY property has it: no blanks
  NumberType type = NumberType::float64;  ///< as the file stored them, and as PLY stores them again
  std::vector<double> values;             ///< V of them

  /// The same in every part; not-a-numbers differ.
  friend bool operator==(const VertexNumbers&, const VertexNumbers&) = default;
};

/// A point of a texture.
struct TexturePoint {
  double u = 0;  ///< to the right
  double v = 0;  ///< up
  /// Equal coordinates.
  friend bool operator==(const TexturePoint&, const TexturePoint&) = default;
};

/// Texture coordinates, corner by corner.
struct TextureCoordinates {
  std::vector<TexturePoint> points;       ///< in any order
  std::vector<Index> of_corner;           ///< the point of each corner, or kNone; empty: of none
  NumberType type = NumberType::float64;  ///< float32 where a file stored them so

  /// Whether no corner has any.
  [[nodiscard]] bool empty() const { return of_corner.empty(); }
  /// The same in every part.
  friend bool operator==(const TextureCoordinates&, const TextureCoordinates&) = default;
};

/// Names of faces, of one kind.
struct FaceLabels {
  std::vector<std::string> names;  ///< each once, in the order in which they are met
  std::vector<Index> of_face;      ///< the name of each face, or kNone; empty: none has one

  /// Whether no face has a name.
  [[nodiscard]] bool empty() const { return of_face.empty(); }
  /// The same in every part.
  friend bool operator==(const FaceLabels&, const FaceLabels&) = default;
};

/// Kinds of labels, in the order in which OBJ files state them.
enum class LabelKind : std::uint8_t { object, group, material, smoothing };
/// All of them.
inline constexpr std::array kLabelKinds{LabelKind::object, LabelKind::group, LabelKind::material,
                                        LabelKind::smoothing};
/// For messages, plural: "object names", "groups", "materials", "smoothing groups".
[[nodiscard]] const char* words_of(LabelKind kind);

/// All that a mesh carries. Its lists fit the mesh: as many numbers as there are vertices, as many
/// corners, as many faces.
struct MeshAttributes {
  std::vector<VertexNumbers> vertices;           ///< columns, each name once
  TextureCoordinates texture;                    ///< of the corners
  std::array<FaceLabels, 4> labels;              ///< by LabelKind
  std::vector<std::string> material_files = {};  ///< what 'mtllib' lines name, line by line

  /// The labels of one kind.
  [[nodiscard]] const FaceLabels& of(LabelKind kind) const {
    return labels.at(static_cast<std::size_t>(kind));
  }
  /// The same, to change them.
  [[nodiscard]] FaceLabels& of(LabelKind kind) { return labels.at(static_cast<std::size_t>(kind)); }
  /// The column of that name, or null.
  [[nodiscard]] const VertexNumbers* find(std::string_view name) const;
  /// Whether there is a label of any kind.
  [[nodiscard]] bool has_labels() const;
  /// Whether there is nothing at all.
  [[nodiscard]] bool empty() const;
  /// The same in every part.
  friend bool operator==(const MeshAttributes&, const MeshAttributes&) = default;
};

/// Whether the lists fit so many vertices, corners and faces, and name what there is. Cost O(size).
[[nodiscard]] bool attributes_fit(const MeshAttributes& attributes, const Polygons& mesh);

/// The columns red, green, blue and, where there is one, alpha; null where one of the first three
/// is missing.
struct ColourColumns {
  std::array<const VertexNumbers*, 4> column{};  ///< the last may be null
  /// Whether there is a colour.
  [[nodiscard]] explicit operator bool() const { return column[0] != nullptr; }
};
/// Those of a mesh.
[[nodiscard]] ColourColumns colour_of(const MeshAttributes& attributes);
/// The number that stands for full intensity: of whole numbers the largest, else 1.
[[nodiscard]] double full_intensity(NumberType type);

/// Of a list of numbers of vertices, corners or faces: what each new one is made of, kNone of none.
struct AttributeMap {
  const std::vector<Index>* vertex_of;  ///< of each new vertex an old one
  const std::vector<Index>* corner_of;  ///< of each new corner an old one, or kNone
  const std::vector<Index>* face_of;    ///< of each new face an old one
};
/// The attributes of a mesh whose vertices, corners and faces are (copies of) old ones, in any
/// order. A corner that is none of the old ones has no texture coordinates. Cost O(size).
[[nodiscard]] MeshAttributes mapped(const MeshAttributes& attributes, const AttributeMap& map);

/// Where corners of one vertex have equal texture coordinates they get one point, so that there is
/// no seam between them; points that no corner has go. For files that state coordinates corner by
/// corner, and for vertices that were joined. Cost O(corners), and the valences' squares.
void join_equal_points(const Polygons& mesh, TextureCoordinates& texture);

}  // namespace limn
