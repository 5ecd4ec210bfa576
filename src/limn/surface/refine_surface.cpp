#include "limn/surface/refine_surface.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "limn/fast/fast_limit.h"
#include "limn/fast/fast_refiner.h"
#include "limn/limit/crease_limit.h"
#include "limn/refine/refine.h"
#include "limn/regular/smoothness/second_differences.h"

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
        quick_(options.engine == SurfaceOptions::Engine::quick && has_fast_layout(*scheme.split) &&
               !options.has_sharpness()) {}

  Result<RefinedSurface> run() {
    start_ = std::chrono::steady_clock::now();
    if (quick_ && options_.of_limit() && !options_.curvatures) {
      const Result<bool> whole = quick_limit();
      if (!whole) return whole.error();
      if (*whole) return std::move(surface_);
    }
    Result<Refined<Point3>> refined = refined_mesh();
    if (!refined) return refined.error();
    if (!mesh_is_needed()) return std::move(surface_);  // polygons are all
    if (options_.of_limit() && refined->sharpness.fades()) return still_sharp();
    if (options_.of_limit())
      if (Status status = find_limit(*refined); !status) return status.error();
    surface_.polygons = refined->mesh.polygons(std::move(refined->values));
    const std::vector<bool> holes = std::exchange(refined->sharpness.holes, {});
    if (refined->sharpness.any()) surface_.sharp = tags_of(refined->mesh, refined->sharpness);
    if (std::find(holes.begin(), holes.end(), true) != holes.end()) leave_out_holes(holes);
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

  [[nodiscard]] Error still_sharp() const {
    return {
        fmt::format("after {} levels edges or vertices of the mesh are still sharp that will be "
                    "smooth, where limit points, normals and curvatures are not known",
                    options_.levels),
        "refine by as many levels as what fades is sharp"};
  }

  /// The vertices that only holes have are gone, from all that is by vertex.
  void leave_out_holes(const std::vector<bool>& holes) {
    std::vector<Index> kept, number(surface_.polygons.positions.size(), kNone);
    surface_.polygons = without_holes(surface_.polygons, holes, kept);
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
        approx_fast_limit_mesh(scheme_, control_, points_, options_.levels);
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
  Result<Refined<Point3>> refined_mesh() {
    if (quick_) {
      Result<Polygons> fine = fast_refine(scheme_, control_, points_, options_.levels);
      stop_clock();
      if (!fine) return fine.error();
      if (!mesh_is_needed()) {
        surface_.polygons = *std::move(fine);
        return Refined<Point3>{};
      }
      // polygons do not tell what the mesh is where two edges of it have the same ends
      if (Result<Mesh> mesh = Mesh::build(*fine))
        return Refined<Point3>{*std::move(mesh), std::move(fine->positions)};
    }
    Result<Refined<Point3>> plain = refine(
        scheme_, std::move(control_), std::move(points_), options_.levels,
        [&](int done, int levels, const Mesh& fine) {
          say(fmt::format("refining: {} of {} levels, {} vertices", done, levels,
                          fine.vertex_count()));
        },
        options_.sharpness);
    stop_clock();
    return plain;
  }

  /// Finds what is wanted of the limit surface.
  Status find_limit(const Refined<Point3>& refined) {
    say("finding limit points");
    LimitOptions options;
    options.steps_made = options_.levels;
    options.partial = options_.partial;
    options.curvatures = options_.curvatures;
    if (options_.curvatures) options.regular = surface_.regular_part = find_regular_part(scheme_);
    options.progress = [&](int left) {
      say(fmt::format("limit points: {} vertices left, near irregular ones", left));
    };
    Result<LimitPoints> limit =
        approx_limit_points(scheme_, refined.mesh, refined.values, refined.sharpness, options);
    if (!limit) return limit.error();
    if (options_.normals) {
      surface_.gaps.normals = without_normal(limit->normals);
      surface_.normals = std::move(limit->normals);
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
  std::chrono::steady_clock::time_point start_;
  RefinedSurface surface_;
};

}  // namespace

Result<RefinedSurface> refine_surface(const Scheme& scheme, Mesh control,
                                      std::vector<Point3> points, const SurfaceOptions& options) {
  return Work(scheme, std::move(control), std::move(points), options).run();
}

}  // namespace limn
