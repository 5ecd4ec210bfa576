#include "limn/surface/refine_attributes.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "limn/base/large_vector.h"
#include "limn/mesh/index.h"
#include "limn/mesh/split/heritage.h"
#include "limn/refine/crease_step.h"

namespace limn {
namespace {

using mesh::at;

/// Corners are sharpness, which is for splits that halve old edges in every step. Under others
/// what ends at them is refined as a curve.
TextureRule rule_for(const Split& split, TextureRule rule) {
  const bool corners = mesh::keeps_old_edges(split) && split.halves_edges();
  if (rule >= TextureRule::boundaries || corners) return rule;
  return TextureRule::none;
}

bool has_lone_face(const Mesh& mesh) {
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    if (mesh.twin(h) == kNone && mesh.twin(mesh.prev(h)) == kNone) return true;
  return false;
}

}  // namespace

Status check_takes_texture(const Scheme& scheme, const Mesh& mesh,
                           const TextureCoordinates& texture, TextureRule rule) {
  if (texture.empty() || !mesh::has_seams(mesh, texture)) return Done{};
  const Split& split = *scheme.split;
  if (!mesh::keeps_old_edges(split))
    return Error{fmt::format("{} cannot refine texture coordinates that have seams: the faces of "
                             "its split, {}, lie across old edges",
                             scheme.name, split.name),
                 "leave them out by --attributes none, or take a scheme with a dyadic split"};
  if (rule == TextureRule::all) return Done{};
  if (scheme.stages)
    return Error{fmt::format("{} cannot refine texture coordinates that have seams: its step is a "
                             "sequence of averagings, which go on across seams",
                             scheme.name),
                 "refine them linearly by --uv all, or leave them out by --attributes none"};
  const RuleKind edge = split.births.thirds ? RuleKind::boundary_edge_end : RuleKind::boundary_edge;
  for (const RuleKind kind : {RuleKind::boundary_vertex, edge}) {
    if (scheme.rule(kind)) continue;
    return Error{fmt::format("{} cannot refine texture coordinates that have seams: it has no {} "
                             "rule",
                             scheme.name, rule_name(kind)),
                 "refine them linearly by --uv all, or leave them out by --attributes none",
                 scheme.file, 0, 0};
  }
  return Done{};
}

namespace surface::detail {

bool have_size_of(const Mesh& mesh, const MeshAttributes& attributes) {
  const auto is = [](std::size_t size, Index count) { return size == at(count); };
  return std::all_of(attributes.vertices.begin(), attributes.vertices.end(),
                     [&](const VertexNumbers& column) {
                       return is(column.values.size(), mesh.vertex_count());
                     }) &&
         (attributes.texture.empty() ||
          is(attributes.texture.of_corner.size(), mesh.halfedge_count())) &&
         std::all_of(attributes.labels.begin(), attributes.labels.end(),
                     [&](const FaceLabels& labels) {
                       return labels.empty() || is(labels.of_face.size(), mesh.face_count());
                     });
}

std::vector<refine::Column> packed(const std::vector<VertexNumbers>& numbers, Index vertex_count) {
  std::vector<refine::Column> columns((numbers.size() + 2) / 3);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].resize(at(vertex_count));
    for (std::size_t i = 0; i < 3 && 3 * c + i < numbers.size(); ++i) {
      const std::vector<double>& values = numbers[3 * c + i].values;
      const std::span<double> to = numbers_of(columns[c]);
      for (std::size_t v = 0; v < values.size(); ++v) to[3 * v + i] = values[v];
    }
  }
  return columns;
}

std::vector<VertexNumbers> unpacked(const std::vector<VertexNumbers>& numbers,
                                    const std::vector<refine::Column>& columns, std::size_t first) {
  std::vector<VertexNumbers> result;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const refine::Column& column = columns[first + k / 3];
    const std::span<const double> from = numbers_of(column);
    VertexNumbers one{numbers[k].name, numbers[k].type, std::vector<double>(column.size())};
    for (std::size_t v = 0; v < column.size(); ++v) one.values[v] = from[3 * v + k % 3];
    result.push_back(std::move(one));
  }
  return result;
}

std::optional<refine::Column> texture_column(const Split& split, const Mesh& mesh,
                                             const TextureCoordinates& texture, TextureRule rule) {
  rule = rule_for(split, rule);
  if (rule == TextureRule::all || mesh::has_seams(mesh, texture)) return std::nullopt;
  if (!mesh::faces_without(mesh, texture).empty()) return std::nullopt;
  if (rule == TextureRule::boundaries && mesh.has_boundary()) return std::nullopt;
  if (rule != TextureRule::none && has_lone_face(mesh)) return std::nullopt;
  refine::Column column(at(mesh.vertex_count()));
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    const TexturePoint& p = texture.points[at(texture.of_corner[at(h)])];
    column[at(mesh.origin(h))] = {p.u, p.v, 0};
  }
  return column;
}

TextureCoordinates texture_of_column(std::vector<Index> corners, const refine::Column& column,
                                     NumberType type) {
  TextureCoordinates result;
  result.type = type;
  result.of_corner = std::move(corners);
  base::reserve_large(result.points, column.size());
  for (const Point3& p : column) result.points.push_back({p.x, p.y});
  return result;
}

Result<TextureCoordinates> refine_texture(const Scheme& scheme, const Mesh& control,
                                          const Sharpness& sharpness,
                                          const TextureCoordinates& texture, TextureRule rule,
                                          int levels, const std::vector<Index>& face_of) {
  rule = rule_for(*scheme.split, rule);
  mesh::TextureMesh cut = mesh::make_texture_mesh(control, sharpness, texture, rule);
  refine::Columns columns;
  const bool linear = rule == TextureRule::all;
  (linear ? columns.linear : columns.smooth).push_back(std::move(cut.points));
  refine::ColumnOptions options;
  options.straight_boundary = rule == TextureRule::boundaries;
  Result<refine::RefinedColumns> fine = refine::refine_columns(
      scheme, std::move(cut.mesh), std::move(columns), std::move(cut.sharpness), levels, options);
  if (!fine) return fine.error();
  std::vector<bool> without;
  if (const std::vector<bool> of_control = mesh::faces_without(control, texture);
      !of_control.empty())
    for (const Index f : face_of) without.push_back(f == kNone || of_control[at(f)]);
  const refine::Column& points = (linear ? fine->columns.linear : fine->columns.smooth)[0];
  return mesh::texture_of(fine->mesh.polygons(points), cut.first, without, texture.type);
}

bool has_quick_texture(const Scheme& scheme, const Mesh& control, const Sharpness& sharpness,
                       const TextureCoordinates& texture, TextureRule rule) {
  rule = rule_for(*scheme.split, rule);
  if (rule >= TextureRule::boundaries || !mesh::keeps_old_edges(*scheme.split)) return false;
  const mesh::TextureMesh cut = mesh::make_texture_mesh(control, sharpness, texture, rule);
  return refine::check_takes_sharpness(scheme, cut.sharpness).ok() &&
         !why_no_fast_sharpness(scheme, cut.mesh, cut.sharpness);
}

Result<TextureCoordinates> quick_texture(const Scheme& scheme, const Mesh& control,
                                         const Sharpness& sharpness,
                                         const TextureCoordinates& texture, TextureRule rule,
                                         int levels) {
  mesh::TextureMesh cut =
      mesh::make_texture_mesh(control, sharpness, texture, rule_for(*scheme.split, rule));
  Result<FastRefiner> refiner =
      FastRefiner::make(scheme, std::move(cut.mesh), levels, std::move(cut.sharpness));
  if (!refiner) return refiner.error();
  std::vector<Point3> points = base::large_vector<Point3>(at(refiner->vertex_count()));
  refiner->evaluate<double>(numbers_of(std::as_const(cut.points)), numbers_of(points));
  std::vector<bool> without;
  if (const std::vector<bool> of_control = mesh::faces_without(control, texture);
      !of_control.empty()) {
    for (const Index f : parents_of(*refiner)) without.push_back(of_control[at(f)]);
  }
  return mesh::texture_of(refined_polygons(*refiner, std::move(points)), cut.first, without,
                          texture.type);
}

std::vector<Index> parents_of(const FastRefiner& refiner) {
  std::vector<Index> face_of = base::large_vector<Index>(at(refiner.face_count()));
  refiner.write_parents(face_of);
  return face_of;
}

void hand_down_labels(const MeshAttributes& control, const std::vector<Index>& face_of,
                      MeshAttributes& fine) {
  fine.material_files = control.material_files;
  for (std::size_t k = 0; k < control.labels.size(); ++k) {
    const FaceLabels& labels = control.labels.at(k);
    if (labels.empty()) continue;
    FaceLabels& to = fine.labels.at(k);
    to = {labels.names, {}};
    to.of_face.reserve(face_of.size());
    for (const Index f : face_of) to.of_face.push_back(f == kNone ? kNone : labels.of_face[at(f)]);
  }
}

}  // namespace surface::detail
}  // namespace limn
