#include "limn/figure/space/visibility.h"

#include <algorithm>
#include <cmath>
#include <utility>

#if LIMN_HAS_EMBREE
#include <embree3/rtcore.h>

#include <limits>
#endif

namespace limn::figure {

#if LIMN_HAS_EMBREE
namespace {

constexpr double kBeside = 0.51;  // from the centre of the cube of side 1; only so far rays meet it

constexpr int kMoves = 4;  // of a ray that meets an edge

struct ReleaseRays {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseRays>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseRays>;

Error no_memory() {
  Error error;
  error.message = "there is not enough memory to cast rays at this surface";
  error.hint = "draw it with fewer triangles";
  return error;
}

/// Of the surface moved into the cube of side 1 about the origin; none if memory runs out.
/// Precondition: it has triangles.
Scene scene_of(RTCDevice device, const SeenSurface& surface, const SpaceVector& centre,
               double size) {
  Scene scene(rtcNewScene(device));
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const points = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), surface.vertices.size()));
  auto* const corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), surface.triangles.size()));
  if (points == nullptr || corners == nullptr) {
    rtcReleaseGeometry(geometry);
    return nullptr;
  }
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      points[3 * v + c] = static_cast<float>((surface.vertices[v][c] - centre[c]) / size);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      corners[3 * t + c] = static_cast<unsigned>(surface.triangles[t][c]);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);  // no ray slips through between triangles
  rtcCommitScene(scene.get());
  return rtcGetDeviceError(device) == RTC_ERROR_NONE ? std::move(scene) : nullptr;
}

}  // namespace

/// One scene a surface, so that surfaces at equal depth are told apart by us.
struct RayCaster::Scenes {
  Device device;
  std::vector<Scene> scenes;  // null: nothing to meet
};

bool rays_available() { return true; }

void RayCaster::find_cube() {
  const std::optional<SeenBox> box = seen_box(surfaces_);
  if (!box) return;
  centre_ = between(box->low, box->high, 0.5);
  if (box->longest > 0) size_ = box->longest;
}

Result<RayCaster> RayCaster::over(std::vector<SeenSurface> surfaces) {
  RayCaster caster;
  caster.surfaces_ = std::move(surfaces);
  caster.find_cube();
  auto scenes = std::make_shared<Scenes>();
  scenes->device.reset(rtcNewDevice(""));
  if (!scenes->device) return no_memory();
  for (const SeenSurface& surface : caster.surfaces_) {
    Scene& scene = scenes->scenes.emplace_back();
    if (surface.triangles.empty()) continue;
    scene = scene_of(scenes->device.get(), surface, caster.centre_, caster.size_);
    if (!scene) return no_memory();
  }
  caster.scenes_ = std::move(scenes);
  return caster;
}

std::optional<RayHit> RayCaster::hit_of(std::size_t surface, double x, double y) const {
  const Scene& scene = scenes_->scenes[surface];
  if (!scene) return std::nullopt;
  const double right = (x - centre_[0]) / size_, up = (y - centre_[1]) / size_;
  if (!(std::abs(right) < kBeside) || !(std::abs(up) < kBeside)) return std::nullopt;
  RTCRayHit ray = {};
  ray.ray.org_x = static_cast<float>(right);
  ray.ray.org_y = static_cast<float>(up);
  ray.ray.org_z = 1;
  ray.ray.dir_z = -1;
  ray.ray.tfar = 2;
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1(scene.get(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const double u = ray.hit.u, v = ray.hit.v;
  return hit_on(surface, ray.hit.primID, x, y, {1 - u - v, u, v});
}

std::optional<RayHit> RayCaster::first_hit(double x, double y) const {
  std::optional<RayHit> first;
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    std::optional<RayHit> hit = hit_of(s, x, y);
    double right = x, up = y;
    for (int moves = 0; moves < kMoves && hit && on_edge(*hit, right, up); ++moves) {
      right += 0.8e-6 * size_;
      up += 0.6e-6 * size_;
      hit = hit_of(s, right, up);
    }
    if (hit && (!first || hit->depth > first->depth + kOnSurface * size_)) first = hit;
  }
  return first;
}

#else

struct RayCaster::Scenes {};

bool rays_available() { return false; }

Result<RayCaster> RayCaster::over(std::vector<SeenSurface>) {
  Error error;
  error.message = "this limn was built without Embree, so it casts no rays";
  error.hint = "install libembree-dev and build limn again with LIMN_RAYS=ON";
  return error;
}

std::optional<RayHit> RayCaster::first_hit(double, double) const { return std::nullopt; }
std::optional<RayHit> RayCaster::hit_of(std::size_t, double, double) const { return std::nullopt; }

#endif

/// The given weights, of single precision, stand only where the triangle is seen edge-on.
RayHit RayCaster::hit_on(std::size_t surface, std::size_t triangle, double x, double y,
                         std::array<double, 3> weights) const {
  const SeenSurface& on = surfaces_[surface];
  const auto& [i, j, k] = on.triangles[triangle];
  const std::array corners = {&on.vertices[i], &on.vertices[j], &on.vertices[k]};
  const auto doubled_area = [&](std::size_t a, std::size_t b) {
    const SpaceVector &p = *corners[a], &q = *corners[b];
    return (p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x);
  };
  const std::array areas = {doubled_area(1, 2), doubled_area(2, 0), doubled_area(0, 1)};
  const double area = areas[0] + areas[1] + areas[2];
  constexpr double off = -1e-3;  // what rounding to single precision may be off, but for slivers
  if (area != 0 && areas[0] / area > off && areas[1] / area > off && areas[2] / area > off)
    for (std::size_t c = 0; c < 3; ++c) weights[c] = areas[c] / area;
  double total = 0;
  for (double& weight : weights) total += weight = std::max(weight, 0.0);
  double depth = 0;
  for (std::size_t c = 0; c < 3; ++c) depth += (weights[c] /= total) * (*corners[c])[2];
  return {surface, triangle, weights, depth};
}

/// Whether single precision may take the neighbour for the triangle: then Embree's answer depends
/// on the order in which it has sorted the triangles, and that on the number of threads.
bool RayCaster::on_edge(const RayHit& hit, double x, double y) const {
  const SeenSurface& on = surfaces_[hit.surface];
  const std::array<int, 3>& triangle = on.triangles[hit.triangle];
  for (std::size_t c = 0; c < 3; ++c) {
    const SpaceVector &p = on.vertices[triangle[c]], &q = on.vertices[triangle[(c + 1) % 3]];
    const double area = (p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x);
    const double edge = std::hypot(q[0] - p[0], q[1] - p[1]);
    if (std::abs(area) <= 3e-7 * size_ * edge) return true;
  }
  return false;
}

bool RayCaster::hides(const SpaceVector& point, double tolerance) const {
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    const std::optional<RayHit> hit = hit_of(s, point[0], point[1]);
    if (hit && hit->depth > point[2] + tolerance * size_) return true;
  }
  return false;
}

}  // namespace limn::figure
