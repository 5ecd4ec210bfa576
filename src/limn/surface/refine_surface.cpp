#include "limn/surface/refine_surface.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "limn/base/large_vector.h"
#include "limn/fast/fast_refiner.h"
#include "limn/limit/crease_limit.h"
#include "limn/mesh/split/heritage.h"
#include "limn/refine/refine_columns.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/surface/refine_attributes.h"

namespace limn {
namespace {

/// One call of refine_surface.
class Work {
 public:
  Work(const Scheme& scheme, Mesh control, std::vector<Point3> points,
       const SurfaceOptions& options)
      : scheme_(scheme),
        control_(std::move(control)),
        points_(std::move(points)),
        options_(options),
        quick_(is_quick(scheme, control_, options)) {}

  Result<RefinedSurface> run() {
    if (options_.attributes != nullptr)
      if (Status takes = check_takes_texture(scheme_, control_, options_.attributes->texture,
                                             options_.attribute_rules.texture);
          !takes)
        return takes.error();
    start_ = std::chrono::steady_clock::now();
    if (quick_) {
      Result<FastRefiner> made =
          FastRefiner::make(scheme_, control_, options_.levels, options_.sharpness);
      if (!made) return made.error();
      refiner_ = *std::move(made);
    }
    if (quick_ && options_.of_limit() && !options_.curvatures) {
      const Result<bool> whole = quick_limit();
      if (!whole) return whole.error();
      if (*whole) {
        if (Status status = quick_attributes(surface_.polygons); !status) return status.error();
        find_holes();
        leave_out_holes(holes_);
        return std::move(surface_);
      }
    }
    Result<refine::Refined<Point3>> refined = refined_mesh();
    if (!refined) return refined.error();
    if (!mesh_is_needed()) return std::move(surface_);  // polygons are all
    if (options_.of_limit())
      if (Status status = find_limit(*refined); !status) return status.error();
    surface_.polygons = refined->mesh.polygons(std::move(refined->values));
    const std::vector<bool> holes = std::exchange(refined->sharpness.holes, {});
    if (refined->sharpness.any()) surface_.sharp = tags_of(refined->mesh, refined->sharpness);
    leave_out_holes(holes);
    if (options_.connectivity) surface_.mesh = std::move(refined->mesh);
    return std::move(surface_);
  }

 private:
  [[nodiscard]] bool mesh_is_needed() const {
    return !quick_ || options_.of_limit() || options_.connectivity;
  }

  void stop_clock() {
    const auto passed = std::chrono::steady_clock::now() - start_;
    surface_.refinement_seconds = std::chrono::duration<double>(passed).count();
  }

  void say(const std::string& what) const {
    if (options_.progress) options_.progress(what);
  }

  /// The vertices that only holes have are gone, from all that is by vertex.
  void leave_out_holes(const std::vector<bool>& holes) {
    if (std::find(holes.begin(), holes.end(), true) == holes.end()) return;
    std::vector<Index> kept, number(surface_.polygons.positions.size(), kNone);
    const Polygons all = std::move(surface_.polygons);
    surface_.polygons = without_holes(all, holes, kept);
    if (!surface_.attributes.empty() || !surface_.sides.empty()) {
      std::vector<Index> corners, faces;
      for (Index f = 0; f < all.face_count(); ++f) {
        if (holes[f]) continue;
        faces.push_back(f);
        for (Index c = all.face_begin[f]; c < all.face_begin[f + 1]; ++c) corners.push_back(c);
      }
      surface_.attributes = mapped(surface_.attributes, {&kept, &corners, &faces});
      std::vector<Index> sides;
      for (const Index c : corners)
        if (!surface_.sides.empty()) sides.push_back(surface_.sides.of_corner[c]);
      surface_.sides.of_corner = std::move(sides);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) number[kept[i]] = static_cast<Index>(i);
    const auto keep = [&](auto& values) {
      if (values.empty()) return;
      for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
      values.resize(kept.size());
    };
    const auto renumber = [&](auto& list, const auto& vertex_of) {
      for (auto& one : list) vertex_of(one) = number[vertex_of(one)];
      std::erase_if(list, [&](auto& one) { return vertex_of(one) == kNone; });
    };
    keep(surface_.limit);
    keep(surface_.normals);
    keep(surface_.curvatures);
    const auto itself = [](Index& v) -> Index& { return v; };
    renumber(surface_.gaps.normals, itself);
    for (LimitGaps::Curvatures& gaps : surface_.gaps.curvatures) renumber(gaps.vertices, itself);
    renumber(surface_.gaps.limits, [](LimitPoints::Refused& gap) -> Index& { return gap.vertex; });
    renumber(surface_.sharp.corners,
             [](SharpnessTags::Corner& corner) -> Index& { return corner.vertex; });
    for (const std::size_t end : {0U, 1U})
      renumber(surface_.sharp.creases,
               [&](SharpnessTags::Crease& crease) -> Index& { return crease.vertices[end]; });
  }

  /// Refinement and limit in one; false where the limit has no quick way.
  Result<bool> quick_limit() {
    Result<std::optional<FastLimitMesh>> quick =
        approx_fast_limit_mesh(scheme_, *refiner_, points_);
    stop_clock();
    // where there is no limit somewhere, the plain way knows where, and gives the rest
    if (!quick && !options_.partial) return quick.error();
    if (!quick || !*quick) return false;
    FastLimitMesh& found = **quick;
    if (options_.connectivity) {
      Result<Mesh> mesh = Mesh::build(found.refined);
      if (!mesh) return false;
      surface_.mesh = *std::move(mesh);
    }
    if (options_.limit) surface_.limit = std::move(found.limit);
    if (options_.normals) {
      surface_.gaps.normals = without_normal(found.normals);
      surface_.normals = std::move(found.normals);
    }
    surface_.polygons = std::move(found.refined);
    return true;
  }

  /// Points where refinement puts them. Where polygons are all that is wanted of the quick engine
  /// they are in surface_, and the result is empty.
  Result<refine::Refined<Point3>> refined_mesh() {
    if (quick_) {
      std::vector<Point3> points =
          base::large_vector<Point3>(static_cast<std::size_t>(refiner_->vertex_count()));
      refiner_->evaluate<double>(numbers_of(points_), numbers_of(points));
      Polygons fine = refined_polygons(*refiner_, std::move(points));
      if (Status status = quick_attributes(fine); !status) return status.error();
      find_holes();
      SharpnessTags sharp = refiner_->sharp_tags();
      refiner_.reset();  // its memory is for what comes now
      stop_clock();
      if (!mesh_is_needed()) {
        surface_.polygons = std::move(fine);
        surface_.sharp = std::move(sharp);
        leave_out_holes(holes_);
        return refine::Refined<Point3>{};
      }
      if (std::optional<refine::Refined<Point3>> built = built_again(fine, sharp))
        return std::move(*built);
    }
    Result<refine::Refined<Point3>> plain = plain_mesh();
    stop_clock();
    return plain;
  }

  /// Which faces of the quick engine's mesh are holes.
  void find_holes() {
    const std::vector<bool>& holes = options_.sharpness.holes;
    if (holes.empty()) return;
    for (const Index f : surface::detail::parents_of(*refiner_))
      holes_.push_back(holes[static_cast<std::size_t>(f)]);
  }

  /// The quick engine's mesh; nothing where two edges of it have the same ends, so that polygons do
  /// not tell what it is.
  [[nodiscard]] std::optional<refine::Refined<Point3>> built_again(Polygons& fine,
                                                                   const SharpnessTags& sharp) {
    Result<Mesh> mesh = Mesh::build(fine);
    if (!mesh) return std::nullopt;
    refine::Refined<Point3> built{*std::move(mesh), {}};
    if (!apply_tags(built.mesh, {}, sharp, built.sharpness)) return std::nullopt;
    built.values = std::move(fine.positions);
    built.sharpness.holes = std::move(holes_);
    return built;
  }

  /// By the plain engine, with the attributes.
  Result<refine::Refined<Point3>> plain_mesh() {
    const MeshAttributes* const attributes = options_.attributes;
    refine::Columns columns;
    columns.smooth.push_back(std::move(points_));
    std::optional<refine::Column> texture;
    refine::ColumnOptions how;
    how.progress = [&](int done, int levels, const Mesh& fine) {
      say(fmt::format("refining: {} of {} levels, {} vertices", done, levels, fine.vertex_count()));
    };
    Mesh control;
    if (attributes != nullptr) {
      add_columns(control_, columns, texture);
      how.parents =
          attributes->has_labels() || (!attributes->texture.empty() &&
                                       !mesh::faces_without(control_, attributes->texture).empty());
      if (!attributes->texture.empty() && !texture) control = control_;
    }
    Result<refine::RefinedColumns> fine = refine::refine_columns(
        scheme_, std::move(control_), std::move(columns), options_.sharpness, options_.levels, how);
    if (!fine) return fine.error();
    refine::Refined<Point3> result{std::move(fine->mesh), std::move(fine->columns.smooth[0]),
                                   std::move(fine->sharpness)};
    if (attributes == nullptr) return result;
    std::vector<Index> corners;
    for (Index h = 0; texture && h < result.mesh.halfedge_count(); ++h)
      corners.push_back(result.mesh.origin(h));
    take_columns(fine->columns, std::move(corners));
    hand_down(fine->face_of);
    if (attributes->texture.empty() || texture || options_.levels == 0) return result;
    Result<TextureCoordinates> refined = surface::detail::refine_texture(
        scheme_, control, options_.sharpness, attributes->texture, options_.attribute_rules.texture,
        options_.levels, fine->face_of);
    if (!refined) return refined.error();
    surface_.attributes.texture = *std::move(refined);
    return result;
  }

  /// What of the attributes goes the way of positions.
  void add_columns(const Mesh& mesh, refine::Columns& columns,
                   std::optional<refine::Column>& texture) const {
    const MeshAttributes& attributes = *options_.attributes;
    std::vector<refine::Column>& to =
        options_.attribute_rules.linear ? columns.linear : columns.smooth;
    for (refine::Column& column : surface::detail::packed(attributes.vertices, mesh.vertex_count()))
      to.push_back(std::move(column));
    if (attributes.texture.empty()) return;
    texture = surface::detail::texture_column(*scheme_.split, mesh, attributes.texture,
                                              options_.attribute_rules.texture);
    if (texture) columns.smooth.push_back(*texture);
  }

  /// The same columns, refined; the first smooth one is that of the positions. `corners`: the
  /// vertices of all corners, where one is that of the texture; else empty.
  void take_columns(const refine::Columns& columns, std::vector<Index> corners) {
    const MeshAttributes& attributes = *options_.attributes;
    const bool linear = options_.attribute_rules.linear;
    surface_.attributes.vertices = surface::detail::unpacked(
        attributes.vertices, linear ? columns.linear : columns.smooth, linear ? 0 : 1);
    if (!corners.empty())
      surface_.attributes.texture = surface::detail::texture_of_column(
          std::move(corners), columns.smooth.back(), attributes.texture.type);
  }

  void hand_down(const std::vector<Index>& face_of) {
    if (options_.levels == 0)  // points keep their numbers
      surface_.attributes.texture = options_.attributes->texture;
    surface::detail::hand_down_labels(*options_.attributes, face_of, surface_.attributes);
  }

  /// By the quick engine.
  Status quick_attributes(const Polygons& fine) {
    if (options_.attributes == nullptr || options_.attributes->empty()) return Done{};
    refine::Columns columns;
    columns.smooth.emplace_back();
    std::optional<refine::Column> texture;
    add_columns(control_, columns, texture);
    for (std::size_t i = 1; i < columns.smooth.size(); ++i) {
      refine::Column column = base::large_vector<Point3>(fine.positions.size());
      refiner_->evaluate<double>(numbers_of(std::as_const(columns.smooth[i])), numbers_of(column));
      columns.smooth[i] = std::move(column);
    }
    take_columns(columns, texture ? fine.corners : std::vector<Index>());
    std::vector<Index> face_of;
    if (options_.attributes->has_labels()) face_of = surface::detail::parents_of(*refiner_);
    hand_down(face_of);
    const TextureCoordinates& coordinates = options_.attributes->texture;
    if (coordinates.empty() || texture || options_.levels == 0) return Done{};
    Result<TextureCoordinates> refined =
        surface::detail::quick_texture(scheme_, control_, options_.sharpness, coordinates,
                                       options_.attribute_rules.texture, options_.levels);
    if (!refined) return refined.error();
    surface_.attributes.texture = *std::move(refined);
    return Done{};
  }

  /// Finds what is wanted of the limit surface.
  Status find_limit(const refine::Refined<Point3>& refined) {
    say("finding limit points");
    LimitOptions options;
    options.steps_made = options_.levels;
    options.partial = options_.partial;
    options.curvatures = options_.curvatures;
    if (options_.curvatures) options.regular = surface_.regular_part = find_regular_part(scheme_);
    options.progress = [&](int left) {
      say(fmt::format("limit points: {} vertices left, near irregular ones", left));
    };
    Result<limit::SharpLimitPoints> limit = limit::approx_limit_points(
        scheme_, refined.mesh, refined.values, refined.sharpness, options, options_.normals);
    if (!limit) return limit.error();
    if (options_.normals) {
      surface_.gaps.normals = without_normal(limit->normals, refined.mesh, limit->sides);
      surface_.normals = std::move(limit->normals);
      surface_.sides = std::move(limit->sides);
    }
    if (options_.curvatures) {
      surface_.gaps.curvatures = without_curvature(limit->no_curvature);
      surface_.curvatures = std::move(limit->curvatures);
    }
    surface_.gaps.limits = std::move(limit->refused);
    if (options_.limit) surface_.limit = std::move(limit->positions);
    return Done{};
  }

  const Scheme& scheme_;
  Mesh control_;
  std::vector<Point3> points_;
  const SurfaceOptions& options_;
  bool quick_;
  std::optional<FastRefiner> refiner_;  // where quick_
  std::chrono::steady_clock::time_point start_;
  std::vector<bool> holes_;  // of the quick engine's faces
  RefinedSurface surface_;
};

}  // namespace

bool is_quick(const Scheme& scheme, const Mesh& control, const SurfaceOptions& options) {
  const Split& split = *scheme.split;
  if (options.engine != SurfaceOptions::Engine::quick || !has_fast_layout(scheme)) return false;
  if (!refine::check_takes_sharpness(scheme, options.sharpness) ||
      why_no_fast_sharpness(scheme, control, options.sharpness))
    return false;
  if (options.attributes == nullptr) return true;
  const MeshAttributes& attributes = *options.attributes;
  if (options.attribute_rules.linear && !attributes.vertices.empty()) return false;
  if (attributes.has_labels() && !mesh::keeps_old_edges(split)) return false;
  const TextureRule rule = options.attribute_rules.texture;
  return attributes.texture.empty() ||
         surface::detail::texture_column(split, control, attributes.texture, rule).has_value() ||
         surface::detail::has_quick_texture(scheme, control, options.sharpness, attributes.texture,
                                            rule);
}

Result<RefinedSurface> refine_surface(const Scheme& scheme, Mesh control,
                                      std::vector<Point3> points, const SurfaceOptions& options) {
  if (options.attributes != nullptr && !surface::detail::have_size_of(control, *options.attributes))
    return Error{"the attributes do not fit the mesh",
                 "give a number for each vertex, a texture point for each corner, a label for each "
                 "face"};
  return Work(scheme, std::move(control), std::move(points), options).run();
}

}  // namespace limn
