#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "limn/fast/fast_refiner.h"
#include "limn/mesh/surface_distance.h"
#include "limn/refine/crease_step.h"
#include "limn/refine/refine_estimate.h"
#include "limn/report/limit_report.h"
#include "page_state.h"

namespace limn::page {
namespace {

struct PlanOptions {
  int levels = 3, instead = 0;
  bool limit = true, normals = true, texture = false;
};

Result<PlanOptions> options_of(const std::string& text) {
  PlanOptions options;
  if (text.empty()) return options;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return Error{"the options are no JSON object", R"(as {"levels": 3})"};
  for (const auto& [key, value] : json.items()) {
    if (key == "levels" && value.is_number_integer()) {
      const auto levels = value.get<std::int64_t>();
      if (levels < 0 || levels > kMostLevels)
        return Error{fmt::format("{} levels are not between 0 and {}", levels, kMostLevels)};
      options.levels = static_cast<int>(levels);
    } else if (key == "limit" && value.is_boolean()) {
      options.limit = value.get<bool>();
    } else if (key == "normals" && value.is_boolean()) {
      options.normals = value.get<bool>();
    } else if (key == "instead" && value.is_number_integer()) {
      options.instead = static_cast<int>(value.get<std::int64_t>());
    } else if (key == "texture" && value.is_boolean()) {
      options.texture = value.get<bool>();
    } else {
      return Error{fmt::format("the option '{}' is unknown or has no such value", key)};
    }
  }
  return options;
}

Status check_size(const Scheme& scheme, const Mesh& mesh, int levels) {
  const refine::RefineEstimate estimate =
      refine::estimate_refinement(*scheme.split, mesh, levels, sizeof(Point3));
  if (estimate.vertices > kMostVertices)
    return Error{refine::text_of(estimate, levels) + ": more than a page can draw",
                 "take fewer levels"};
  return refine::check_refinable(scheme, mesh, levels, sizeof(Point3), kMostBytes);
}

/// The mesh's sharpness, and what holds copies together that repair has made, where the scheme can.
Sharpness sharpness_of(const LoadedMesh& mesh, const Scheme& scheme) {
  Sharpness held = mesh.sharpness;
  mesh::hold_cuts(mesh.mesh, mesh.cuts, held);
  return refine::check_takes_sharpness(scheme, held) ? held : mesh.sharpness;
}

SurfaceOptions surface_options(const LoadedPlan& plan) {
  SurfaceOptions options;
  options.levels = plan.levels;
  options.partial = true;
  options.sharpness = plan.sharpness;
  return options;
}

/// The faces of the refined mesh, and room for its points. Those of another plan stay as they are
/// where they do not depend on what differs: the weights.
void make_room(LoadedPlan& plan, LoadedPlan* before) {
  const FastRefiner& refiner = *plan.refiner;
  const bool same = before != nullptr && before->refiner && before->mesh == plan.mesh &&
                    before->levels == plan.levels &&
                    before->scheme->scheme.split == plan.scheme->scheme.split;
  if (before != nullptr) {
    plan.refined = std::move(before->refined);
    plan.positions = std::move(before->positions);
    plan.normals_there = std::move(before->normals_there);
    plan.scratch = std::move(before->scratch);
  }
  if (!same) plan.refined = refined_polygons(refiner, {});
}

/// Makes what can be made once, for the fast engine.
Status prepare(LoadedPlan& plan, LoadedPlan* before) {
  const Scheme& scheme = plan.scheme->scheme;
  if (!has_fast_layout(scheme) || plan.sharpness.any() || plan.sharpness.has_holes() ||
      plan.textured)
    return Done{};
  Result<FastRefiner> refiner = FastRefiner::make(scheme, plan.mesh->mesh, plan.levels);
  if (!refiner) return refiner.error();
  if (plan.limit || plan.normals) {
    Result<std::optional<FastRefiner::Limit>> limit = approx_fast_limit(scheme, *refiner);
    if (!limit || !*limit) return Done{};
    plan.on_limit = std::move(**limit);
  }
  plan.refiner = std::move(*refiner);
  make_room(plan, before);
  return Done{};
}

void update_fast(LoadedPlan& plan) {
  const std::vector<float> control = floats_of(plan.mesh->points);
  const std::size_t numbers = 3 * static_cast<std::size_t>(plan.refiner->vertex_count());
  plan.positions.resize(numbers);
  if (!plan.on_limit) return plan.refiner->evaluate<float>(control, plan.positions, plan.scratch);
  plan.normals_there.resize(numbers);
  plan.refiner->evaluate_limit<float>(*plan.on_limit, control, plan.positions, plan.normals_there,
                                      plan.scratch);
  plan.has_limit = plan.limit;
  plan.has_normals = plan.normals;
  if (!plan.limit) std::copy_n(plan.scratch.refined().data(), numbers, plan.positions.data());
}

/// The surface in double precision.
Polygons in_doubles(LoadedPlan& plan) {
  if (!plan.refiner) return plan.refined;
  Polygons polygons = plan.refined;
  polygons.positions.resize(static_cast<std::size_t>(plan.refiner->vertex_count()));
  const std::span<const double> control = numbers_of(plan.mesh->points);
  FastRefiner::Scratch<double> scratch;
  if (!plan.has_limit) {
    plan.refiner->evaluate<double>(control, numbers_of(polygons.positions), scratch);
    return polygons;
  }
  std::vector<Point3> normals(polygons.positions.size());
  plan.refiner->evaluate_limit<double>(*plan.on_limit, control, numbers_of(polygons.positions),
                                       numbers_of(normals), scratch);
  return polygons;
}

/// Notes at which vertices there is no limit, if it is the limit that is shown.
void note_gaps(LoadedPlan& plan, const LimitGaps& gaps) {
  plan.without_limit.clear();
  if (!plan.has_limit || gaps.limits.empty()) return;
  plan.without_limit.resize(plan.refined.positions.size());
  for (const LimitPoints::Refused& gap : gaps.limits) plan.without_limit[gap.vertex] = true;
  plan.reason = gaps.limits.front().reason;
}

/// By the front of refinement, which takes everything; without the limit, or the texture, where
/// there is none.
Status update_plain(LoadedPlan& plan) {
  SurfaceOptions options = surface_options(plan);
  options.limit = plan.limit;
  options.normals = plan.normals;
  MeshAttributes attributes;
  if (plan.textured) {
    attributes = texture_for(plan);
    options.attributes = &attributes;
    if (plan.pattern != "image") options.attribute_rules.texture = TextureRule::all;
  }
  const LoadedMesh& mesh = *plan.mesh;
  const auto refined = [&] {
    return refine_surface(plan.scheme->scheme, mesh.mesh, mesh.points, options);
  };
  Result<RefinedSurface> surface = refined();
  if (!surface && plan.textured) {
    const Error fault = surface.error();
    options.attributes = nullptr;
    surface = refined();
    plan.pattern = "none";
    if (surface) plan.no_texture = fault.message;
  }
  plan.has_limit = options.limit && surface;
  plan.has_normals = options.normals && surface;
  if (!surface && options.of_limit()) {
    plan.reason = surface.error().message;
    options.limit = options.normals = false;
    surface = refined();
  }
  if (!surface) return surface.error();
  plan.refined = std::move(surface->polygons);
  note_gaps(plan, surface->gaps);
  if (plan.has_limit) plan.refined.positions = std::move(surface->limit);
  plan.positions = floats_of(plan.refined.positions);
  plan.normals_there = floats_of(surface->normals);
  if (plan.textured) keep_texture(plan, surface->attributes.texture);
  return Done{};
}

Point3 point_at(const std::vector<float>& numbers, Index i) {
  const std::size_t at = 3 * static_cast<std::size_t>(i);
  return {numbers[at], numbers[at + 1], numbers[at + 2]};
}

/// Normals where there are none: the sum of those of the faces there.
void complete_normals(LoadedPlan& plan) {
  const Polygons& polygons = plan.refined;
  std::vector<Point3> sums(plan.positions.size() / 3);
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const Index* corners = polygons.corners.data() + polygons.face_begin[f];
    const Point3 first = point_at(plan.positions, corners[0]);
    Point3 area;
    for (Index i = 1; i + 1 < polygons.degree(f); ++i)
      area = area + cross(point_at(plan.positions, corners[i]) - first,
                          point_at(plan.positions, corners[i + 1]) - first);
    for (Index i = 0; i < polygons.degree(f); ++i) sums[corners[i]] = sums[corners[i]] + area;
  }
  plan.normals_there.resize(plan.positions.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (point_at(plan.normals_there, static_cast<Index>(v)) != Point3{}) continue;
    const double length = std::sqrt(dot(sums[v], sums[v]));
    if (!(length > 0)) continue;
    plan.normals_there[3 * v] = static_cast<float>(sums[v].x / length);
    plan.normals_there[3 * v + 1] = static_cast<float>(sums[v].y / length);
    plan.normals_there[3 * v + 2] = static_cast<float>(sums[v].z / length);
  }
}

/// Whether some vertex has no normal.
bool lacks_normals(const LoadedPlan& plan) {
  const std::vector<float>& n = plan.normals_there;
  for (std::size_t i = 0; i < n.size(); i += 3)
    if (n[i] == 0 && n[i + 1] == 0 && n[i + 2] == 0) return true;
  return false;
}

Json plan_json(const LoadedPlan& plan, int id) {
  Index triangles = static_cast<Index>(plan.refined.corners.size()) - 2 * plan.refined.face_count();
  if (!plan.without_limit.empty()) {
    triangles = 0;
    each_triangle(plan, [&](Index, Index, Index) { ++triangles; });
  }
  return {{"id", id},
          {"vertices", plan.positions.size() / 3},
          {"triangles", triangles},
          {"engine", plan.refiner ? "fast" : "plain"},
          {"limit", plan.has_limit},
          {"reason", plan.reason},
          {"missing", std::count(plan.without_limit.begin(), plan.without_limit.end(), true)}};
}

}  // namespace

Status update(LoadedPlan& plan) {
  if (plan.moves == plan.mesh->moves) return Done{};
  if (plan.refiner)
    update_fast(plan);
  else if (Status status = update_plain(plan); !status)
    return status;
  if (plan.normals && (!plan.has_normals || !plan.refiner || lacks_normals(plan)))
    complete_normals(plan);
  plan.moves = plan.mesh->moves;
  return Done{};
}

std::string PageCore::plan(int scheme, int mesh, const std::string& options) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    const auto control = state_->meshes.find(mesh);
    if (!control) return control.error();
    const Result<PlanOptions> wanted = options_of(options);
    if (!wanted) return wanted.error();
    if (Status status = check_size((*loaded)->scheme, (*control)->mesh, wanted->levels); !status)
      return status.error();
    auto plan = std::make_shared<LoadedPlan>();
    plan->scheme = *loaded;
    plan->mesh = *control;
    plan->levels = wanted->levels;
    plan->limit = wanted->limit;
    plan->normals = wanted->normals;
    plan->textured = wanted->texture;
    plan->sharpness = sharpness_of(**control, (*loaded)->scheme);
    const auto before = state_->plans.find(wanted->instead);
    state_->plans.remove(wanted->instead);
    if (Status status = prepare(*plan, before ? before->get() : nullptr); !status)
      return status.error();
    if (Status status = update(*plan); !status) return status.error();
    const int id = state_->plans.add(plan);
    return plan_json(*plan, id);
  });
}

void PageCore::unplan(int plan) { state_->plans.remove(plan); }

TopologyAnswer PageCore::topology(int plan) {
  TopologyAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->plans.find(plan);
    if (!found) return found.error();
    each_triangle(**found, [&](Index a, Index b, Index c) {
      for (const Index corner : {a, b, c})
        made.triangles.push_back(static_cast<std::uint32_t>((*found)->refined.corners[corner]));
    });
    return Json::object();
  });
  return made;
}

SurfaceAnswer PageCore::evaluate(int plan) {
  SurfaceAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->plans.find(plan);
    if (!found) return found.error();
    LoadedPlan& now = **found;
    const auto start = std::chrono::steady_clock::now();
    if (Status status = update(now); !status) return status.error();
    made.positions = now.positions;
    if (now.normals) made.normals = now.normals_there;
    const auto passed = std::chrono::steady_clock::now() - start;
    return Json{{"limit", now.has_limit},
                {"normals", now.has_normals ? "limit" : "faces"},
                {"milliseconds", std::chrono::duration<double, std::milli>(passed).count()}};
  });
  return made;
}

CurvatureAnswer PageCore::curvature(int plan) {
  CurvatureAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->plans.find(plan);
    if (!found) return found.error();
    const LoadedPlan& now = **found;
    SurfaceOptions options = surface_options(now);
    options.curvatures = true;
    const Result<RefinedSurface> surface =
        refine_surface(now.scheme->scheme, now.mesh->mesh, now.mesh->points, options);
    if (!surface) return surface.error();
    if (surface->polygons.corners != now.refined.corners)
      return Error{"curvatures are not known in the order of this mesh's vertices"};
    int missing = 0;
    for (const LimitPoints::Curvatures& one : surface->curvatures) {
      made.gaussian.push_back(static_cast<float>(one.largest * one.smallest));
      made.mean.push_back(static_cast<float>((one.largest + one.smallest) / 2));
      missing += std::isnan(one.largest) ? 1 : 0;
    }
    return Json{{"missing", missing}, {"reasons", report::gaps_json(surface->gaps)["curvatures"]}};
  });
  return made;
}

FieldAnswer PageCore::distance(int plan, int other) {
  FieldAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto a = state_->plans.find(plan);
    if (!a) return a.error();
    const auto b = state_->plans.find(other);
    if (!b) return b.error();
    for (const auto& one : {*a, *b})
      if (Status status = update(*one); !status) return status.error();
    const Result<mesh::SurfaceDistance> apart =
        mesh::approx_surface_distance(in_doubles(**a), in_doubles(**b));
    if (!apart) return apart.error();
    for (const double distance : apart->from_a) made.values.push_back(static_cast<float>(distance));
    return Json{{"largest", apart->largest}, {"mean", apart->mean}, {"diagonal", apart->diagonal}};
  });
  return made;
}

}  // namespace limn::page
