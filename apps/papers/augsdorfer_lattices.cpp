#include <array>
#include <cmath>

#include <fmt/core.h>

#include "limn/regular/symbol.h"
#include "papers/augsdorfer_parts.h"

namespace limn::ads {
namespace {

constexpr figure::Colour kBefore{0.1, 0.3, 0.75, 1};  // the mesh before refinement, blue as printed
constexpr figure::Colour kVector{0.75, 0.1, 0.1, 1};

figure::PagePoint place(double a, double b) { return cartesian(Lattice::triangle, {a, b}); }

/// Edges of a triangle lattice of this spacing over a rhombus of control edges.
figure::NetPanel::Net lattice_net(int across, double spacing) {
  figure::NetPanel::Net net;
  const int side = static_cast<int>(std::lround(across / spacing));
  const auto at = [&](int i, int j) { return j * (side + 1) + i; };
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) {
      net.vertices.push_back(place(i * spacing, j * spacing));
      if (i < side) net.edges.push_back({at(i, j), at(i + 1, j)});
      if (j < side) net.edges.push_back({at(i, j), at(i, j + 1)});
      if (i < side && j < side) net.edges.push_back({at(i, j), at(i + 1, j + 1)});
    }
  return net;
}

/// The refined mesh, its four kinds of vertices, and the shifts between them.
figure::NetPanel shifts_panel(const std::vector<figure::PagePoint>& shifts) {
  figure::NetPanel panel;
  panel.title = "the mesh and its shifts";
  panel.place_labels = true;
  figure::NetPanel::Net after = lattice_net(2, 0.5), before = lattice_net(2, 1);
  after.colour = figure::grey(0.6);
  after.stroke = {.width = 0.4, .dash = {1.5, 1.5}};
  before.colour = kBefore;
  before.stroke = {.width = 1};
  before.dot = 2;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) {
      // 2J, 2J + X1, 2J + X2, and 2J + X3, which is X1 + X2 from an old vertex too
      const std::size_t kind = static_cast<std::size_t>(i % 2 + 2 * (j % 2));
      panel.labels.push_back({place(i / 2., j / 2.),
                              std::string(1, "ABCD"[kind]),
                              {},
                              kind == 0 ? kBefore : figure::grey(0.3)});
    }
  panel.nets = {std::move(after), std::move(before)};
  const figure::PagePoint from = place(1, 1);
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    const figure::PagePoint to{from[0] + shifts[k][0], from[1] + shifts[k][1]};
    panel.arrows.push_back({from, to, kVector});
    panel.labels.push_back({to, fmt::format("X_{{{}}}", k + 1), {}, kVector});
  }
  return panel;
}

figure::NetPanel::Net outline(const std::vector<Frequency>& corners, double scale) {
  figure::NetPanel::Net net{.dot = 0};
  const int count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) {
    const Frequency& f = corners[static_cast<std::size_t>(i)];
    net.vertices.push_back({scale * f[0], scale * f[1]});
    net.edges.push_back({i, (i + 1) % count});
  }
  return net;
}

/// The frequencies that the control mesh and the refined one tell apart, and a wave's artifacts.
figure::NetPanel frequencies_panel(const ArtifactAnalysis& analysis, Frequency f) {
  figure::NetPanel panel;
  panel.title = "frequencies";
  panel.place_labels = true;
  const std::vector<Frequency> region = nyquist_region(Lattice::triangle);
  panel.nets = {outline(region, 1), outline(region, 2)};
  panel.nets[0].colour = kBefore;
  panel.nets[0].stroke = {.width = 1};
  panel.nets[1].colour = figure::grey(0.6);
  panel.nets[1].stroke = {.width = 0.6, .dash = {1.5, 1.5}};
  figure::NetPanel::Net waves{.dot = 2};
  waves.vertices.push_back({f[0], f[1]});
  panel.labels.push_back({{f[0], f[1]}, "f", {}, {}});
  const std::vector<Frequency> artifacts = analysis.artifact_frequencies(f);
  for (std::size_t k = 0; k < artifacts.size(); ++k) {
    const figure::PagePoint to{artifacts[k][0], artifacts[k][1]};
    waves.vertices.push_back(to);
    panel.arrows.push_back({{f[0], f[1]}, to, kVector});
    panel.labels.push_back({to, fmt::format("f + Y_{{{}}}", k + 1), {}, kVector});
  }
  panel.nets.push_back(std::move(waves));
  return panel;
}

}  // namespace

Status add_lattices(PaperPage& page, const Study& study) {
  const ArtifactAnalysis& analysis = study.schemes.front().analysis;
  const double root3 = std::sqrt(3.0);
  const Frequency f{0.1 / root3, 0.2 / root3};  // that of Figure 1
  // Edge directions; half a control edge is an edge of the refined mesh.
  const std::vector<figure::PagePoint> shifts{place(0.5, 0), place(0, 0.5), place(-0.5, -0.5)};
  figure::Figure figure(2);
  figure.add(
      shifts_panel(shifts),
      "Blue: the mesh before refinement; dashed: after it. A old vertices, B, C, D new ones.");
  figure.add(frequencies_panel(analysis, f),
             "Blue: the region that the control mesh tells apart; dashed: that of the refined "
             "mesh. A wave f of the first comes back as f and its three artifacts.");
  report::DescribedTable numbers{{{"vector", "its name"},
                                  {"kind", "shift of the refined mesh or of the frequency"},
                                  {"x", "[control edges] or [cycles per control edge]"},
                                  {"y", "[control edges] or [cycles per control edge]"}},
                                 {}};
  figure::PagePoint sum{0, 0};
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    sum = {sum[0] + shifts[k][0], sum[1] + shifts[k][1]};
    numbers.rows.push_back({fmt::format("X{}", k + 1), "shift", shifts[k][0], shifts[k][1]});
  }
  numbers.rows.push_back({"f", "frequency", f[0], f[1]});
  const std::vector<Frequency> artifacts = analysis.artifact_frequencies(f);
  for (std::size_t k = 0; k < artifacts.size(); ++k)
    numbers.rows.push_back({study::artifact_name(static_cast<int>(k)), "frequency",
                            artifacts[k][0] - f[0], artifacts[k][1] - f[1]});
  return page.add_figure(
      {"Figure 2", "fig02"}, figure, numbers,
      "the parameter space of a triangle grid with its shifts X1, X2, X3; A, B, C, D at the "
      "vertices; Y1, Y2, Y3 perpendicular to the grid lines.",
      fmt::format(
          "X1 + X2 + X3 = ({:.0f}, {:.0f}), as it must be; on the right the shifts of "
          "frequency Y1, Y2, Y3, each the shortest of its class from f. In cycles per "
          "control edge they are {:.4f} long at f = 0, twice the way to the rim of the region.",
          std::abs(sum[0]), std::abs(sum[1]),
          std::hypot(analysis.artifact_frequencies({0, 0})[0][0],
                     analysis.artifact_frequencies({0, 0})[0][1])));
}

}  // namespace limn::ads
