#pragma once
/// What is in front: rays cast at surfaces in the viewer's coordinates, along the line of sight.
/// Embree finds the triangle; place and depth on it are computed in double precision. A ray that
/// meets an edge, where two triangles are met alike, is moved aside by some millionths of the
/// scene's size: nothing depends on the number of threads.
///
///     Result<RayCaster> rays = RayCaster::over(seen_surfaces(scene));
///     if (const auto hit = rays->first_hit(x, y)) …
///     const bool gone = rays->hides(point);

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "limn/base/error.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// Whether this limn was built with Embree. If not, `RayCaster::over` is an error.
[[nodiscard]] bool rays_available();

/// What a ray meets first.
struct RayHit {
  std::size_t surface = 0;
  std::size_t triangle = 0;            ///< of the surface
  std::array<double, 3> weights = {};  ///< of its corners: ≥ 0, sum 1
  double depth = 0;                    ///< towards the eye
};

class RayCaster {
 public:
  /// Keeps the surfaces. O(triangles · log): half a second a million. Errors: no
  /// Embree in this limn; memory that Embree cannot have.
  [[nodiscard]] static Result<RayCaster> over(std::vector<SeenSurface> surfaces);

  [[nodiscard]] const std::vector<SeenSurface>& surfaces() const { return surfaces_; }

  /// The first of all surfaces that an eye sees at (x, y) of the viewer's plane. Of surfaces less
  /// than `kOnSurface` of the scene's size apart, the earlier one. Threads may share a caster.
  [[nodiscard]] std::optional<RayHit> first_hit(double x, double y) const;

  /// Whether a surface lies in front of the point, by more than `tolerance` times the size of the
  /// scene; a point of a surface is not hidden by the surface round it.
  [[nodiscard]] bool hides(const SpaceVector& point, double tolerance = kOnSurface) const;

  static constexpr double kOnSurface = kEqualDepth;

 private:
  struct Scenes;
  RayCaster() = default;
  void find_cube();
  [[nodiscard]] std::optional<RayHit> hit_of(std::size_t surface, double x, double y) const;
  [[nodiscard]] bool on_edge(const RayHit& hit, double x, double y) const;
  [[nodiscard]] RayHit hit_on(std::size_t surface, std::size_t triangle, double x, double y,
                              std::array<double, 3> weights) const;

  std::vector<SeenSurface> surfaces_;
  SpaceVector centre_ = {};
  double size_ = 1;  // of a cube that holds everything
  std::shared_ptr<const Scenes> scenes_;
};

}  // namespace limn::figure
