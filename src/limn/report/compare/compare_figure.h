#pragma once
/// Limit surfaces of several schemes over one control mesh: how far apart they are, and a picture
/// [KS Figs. 14, 15, 27–34, 41–46].

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "limn/figure/figure.h"
#include "limn/figure/space/surface_scene.h"
#include "limn/mesh/surface_distance.h"

namespace limn::report {

/// A limit surface (study/surface_scenes.h) and what it is called.
struct NamedSurface {
  std::string name;
  figure::SmoothSurface surface;
};

/// Of two surfaces, by their places in a list; first < second.
struct PairDistance {
  std::size_t first = 0, second = 0;
  mesh::SurfaceDistance distance;
};

/// Of all pairs, (0, 1), (0, 2), …, (1, 2), …; `progress` is called before each. Fails as
/// `approx_surface_distance` does.
[[nodiscard]] Result<std::vector<PairDistance>> approx_distances(
    const std::vector<NamedSurface>& surfaces,
    const std::function<void(const std::string& first, const std::string& second)>& progress = {});

/// Both in one picture, the first in green and the second in pink, with the outline that each has
/// alone, and a legend. Where they are equal (`kEqualDepth`) neither: a third colour. The view is
/// the default one.
[[nodiscard]] figure::ShadedPanel overlaid(const NamedSurface& first, const NamedSurface& second);

/// Of surfaces beside the first: so many fit on a page.
inline constexpr std::size_t kMostPairs = 18;

/// How the picture looks at the surfaces.
struct CompareView {
  double azimuth = -50, elevation = 30;  ///< degrees, as in a SurfaceScene
  double resolution = 200;               ///< pixels an inch
};

/// The first surface against each of the others: both alone, both `overlaid`, and the other
/// coloured by its distance to the first. All pictures have one scale. `distances` as from
/// approx_distances. Precondition: at least two surfaces. With more
/// than `kMostPairs` beside the first the page may be too large to be written.
[[nodiscard]] figure::Figure compare_figure(const std::vector<NamedSurface>& surfaces,
                                            const std::vector<PairDistance>& distances,
                                            const CompareView& view = {});

/// "largest 0.0288 (0.568 % of the diagonal), mean 0.00904"
[[nodiscard]] std::string distance_text(const mesh::SurfaceDistance& distance);

}  // namespace limn::report
