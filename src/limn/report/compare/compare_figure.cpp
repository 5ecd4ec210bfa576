#include "limn/report/compare/compare_figure.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/study/surface_scenes.h"

namespace limn::report {
namespace {

constexpr figure::Colour kGreen = {0.45, 0.78, 0.45}, kPink = {0.96, 0.56, 0.68};  // of [KS]
constexpr figure::Colour kDarkGreen = {0.02, 0.33, 0.10}, kDarkPink = {0.62, 0.03, 0.25};
constexpr figure::Colour kIvory = {0.94, 0.91, 0.76};
constexpr int kColumns = 2;

figure::SmoothSurface coloured(figure::SmoothSurface surface, const figure::Colour& colour,
                               const figure::Colour& lines) {
  surface.colour = colour;
  surface.line_colour = lines;
  return surface;
}

/// What shows all surfaces whole.
figure::ViewFrame common_frame(const std::vector<NamedSurface>& surfaces, const CompareView& view) {
  figure::SurfaceScene all = {.azimuth = view.azimuth, .elevation = view.elevation};
  for (const NamedSurface& named : surfaces) {
    all.surfaces.emplace_back().vertices = named.surface.vertices;
  }
  return figure::frame_of(all);
}

/// All by one factor.
std::vector<NamedSurface> scaled_to_draw(std::vector<NamedSurface> surfaces) {
  figure::SurfaceScene all;
  for (NamedSurface& named : surfaces) all.surfaces.push_back(std::move(named.surface));
  figure::scale_to_draw(all);
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    surfaces[s].surface = std::move(all.surfaces[s]);
  return surfaces;
}

/// The panels of one pair.
class PairPanels {
 public:
  PairPanels(const CompareView& view, const figure::ViewFrame& frame)
      : view_(view), frame_(frame) {}

  void add_to(figure::Figure& figure, const NamedSurface& first, const NamedSurface& second,
              const mesh::SurfaceDistance& distance) const {
    const figure::SmoothSurface green = coloured(first.surface, kGreen, kDarkGreen);
    const figure::SmoothSurface pink = coloured(second.surface, kPink, kDarkPink);
    figure.add(panel({green}), first.name);
    figure.add(panel({pink}), second.name);
    figure::ShadedPanel both = overlaid(first, second);
    both.scene = panel(both.scene.surfaces).scene;
    both.resolution = view_.resolution;
    figure.add(both, "Both, the nearer one seen, and the outline that each has alone.");
    figure::ShadedPanel apart = panel({pink});
    apart.values = figure::SurfaceValues{.values = distance.from_b, .low = 0};
    figure.add(apart, fmt::format("Distance of {} to {}: {}.", second.name, first.name,
                                  distance_text(distance)));
  }

 private:
  [[nodiscard]] figure::ShadedPanel panel(std::vector<figure::SmoothSurface> surfaces) const {
    return {.scene = {.surfaces = std::move(surfaces),
                      .azimuth = view_.azimuth,
                      .elevation = view_.elevation,
                      .seen_frame = frame_},
            .resolution = view_.resolution};
  }

  CompareView view_;
  figure::ViewFrame frame_;
};

}  // namespace

figure::ShadedPanel overlaid(const NamedSurface& first, const NamedSurface& second) {
  figure::ShadedPanel panel;
  panel.scene.surfaces = {coloured(first.surface, kGreen, kDarkGreen),
                          coloured(second.surface, kPink, kDarkPink)};
  panel.names = {first.name, second.name};
  panel.ties = figure::TieLook{
      kIvory, fmt::format("both: less than {} of the size apart", figure::kEqualDepth)};
  panel.outlines = true;
  return panel;
}

Result<std::vector<PairDistance>> approx_distances(
    const std::vector<NamedSurface>& surfaces,
    const std::function<void(const std::string& first, const std::string& second)>& progress) {
  std::vector<Polygons> polygons;
  polygons.reserve(surfaces.size());
  for (const NamedSurface& named : surfaces) polygons.push_back(study::polygons_of(named.surface));
  std::vector<PairDistance> distances;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
      if (progress) progress(surfaces[i].name, surfaces[j].name);
      Result<mesh::SurfaceDistance> distance =
          mesh::approx_surface_distance(polygons[i], polygons[j]);
      if (!distance) return distance.error();
      distances.push_back({i, j, std::move(*distance)});
    }
  return distances;
}

figure::Figure compare_figure(const std::vector<NamedSurface>& surfaces,
                              const std::vector<PairDistance>& distances, const CompareView& view) {
  figure::Figure figure(kColumns);
  const std::vector<NamedSurface> drawn = scaled_to_draw(surfaces);
  const PairPanels panels(view, common_frame(drawn, view));
  for (const PairDistance& pair : distances)
    if (pair.first == 0) panels.add_to(figure, drawn[0], drawn[pair.second], pair.distance);
  return figure;
}

std::string distance_text(const mesh::SurfaceDistance& distance) {
  return fmt::format("largest {:.3g} ({:.3g} % of the diagonal), mean {:.3g}", distance.largest,
                     100 * distance.largest / distance.diagonal, distance.mean);
}

}  // namespace limn::report
