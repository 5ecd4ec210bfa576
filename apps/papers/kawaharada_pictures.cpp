#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/refine/refine.h"
#include "limn/scheme/scope.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/study/surface_scenes.h"
#include "papers/kawaharada_parts.h"

namespace limn::ks {
namespace {

constexpr int kFirst = 3, kLast = 12;  // valences of the numbers
constexpr figure::Colour kRed{0.8, 0.1, 0.1, 1};

figure::PagePoint on_circle(double radius, double turns) {
  return {radius * std::cos(2 * std::numbers::pi * turns),
          radius * std::sin(2 * std::numbers::pi * turns)};
}

/// A wheel of k spokes; label 0 stands at the hub, the others at the rim in turn.
figure::NetPanel wheel(int k, const std::string& title, const std::vector<std::string>& texts) {
  figure::NetPanel panel;
  panel.title = title;
  panel.place_labels = true;
  figure::NetPanel::Net net{.colour = figure::grey(0.3), .dot = 1.8};
  net.vertices.push_back({0, 0});
  panel.labels.push_back({{0, 0}, texts[0]});
  for (int i = 0; i < k; ++i) {
    const figure::PagePoint at = on_circle(1, 0.25 + static_cast<double>(i) / k);
    net.vertices.push_back(at);
    net.edges.push_back({0, i + 1});
    net.edges.push_back({i + 1, (i + 1) % k + 1});
    const std::size_t which = std::min(static_cast<std::size_t>(i) + 1, texts.size() - 1);
    panel.labels.push_back({at, texts[which]});
  }
  panel.nets.push_back(std::move(net));
  return panel;
}

/// Fig. 2: the old vertices, and the new ones on the edges, in red.
figure::NetPanel numbering(int k) {
  std::vector<std::string> texts;
  for (int i = 0; i <= k; ++i) texts.push_back(fmt::format("v_{{{}}}", i));
  figure::NetPanel panel = wheel(k, "Fig. 2", texts);
  figure::NetPanel::Net fine{
      .colour = kRed, .stroke = {.width = 0.5, .dash = {2, 1.5}}, .dot = 1.6};
  for (int i = 0; i < k; ++i) {
    const figure::PagePoint at = on_circle(0.5, 0.25 + static_cast<double>(i) / k);
    fine.vertices.push_back(at);
    fine.edges.push_back({i, (i + 1) % k});
    panel.labels.push_back({at, fmt::format("v'_{{{}}}", i + 1), {}, kRed});
  }
  panel.nets.push_back(std::move(fine));
  return panel;
}

figure::NetPanel edge_stencil() {
  const double h = std::sqrt(3.0) / 2;
  figure::NetPanel panel;
  panel.title = "Fig. 3, new vertices";
  panel.place_labels = true;
  panel.nets = {{.vertices = {{-0.5, 0}, {0.5, 0}, {0, h}, {0, -h}},
                 .edges = {{0, 1}, {0, 2}, {2, 1}, {0, 3}, {3, 1}},
                 .colour = figure::grey(0.3),
                 .dot = 1.8},
                {.vertices = {{0, 0}}, .colour = kRed, .dot = 1.8}};
  for (const auto& [at, text] : {std::pair{figure::PagePoint{-0.5, 0}, "/{b}"},
                                 {{0.5, 0}, "/{b}"},
                                 {{0, h}, "/{c}"},
                                 {{0, -h}, "/{c}"}})
    panel.labels.push_back({at, text});
  return panel;
}

/// The weight of a role in the vertex rule at valence n.
Result<double> vertex_weight(const Member& member, const std::string& role, int n) {
  const Result<Scheme> scheme = member.load();
  if (!scheme) return scheme.error();
  for (const Weight& weight : scheme->rule(RuleKind::vertex)->front().weights)
    if (weight.role == role) return scheme::Scope<double>(*scheme, n, std::nullopt)(weight.value);
  return 0.0;
}

/// The stencils at each valence: Loop's, the Laplacian's (a high pass with a = 1 without its Loop),
/// its pseudo inverse's (the low pass with á = 1).
Result<report::DescribedTable> stencil_numbers(const Members& members) {
  report::DescribedTable table{
      {{"k", "edges of the vertex"},
       {"loop_self", "1 − kβ, weight of the vertex in Loop's rule (Fig. 3)"},
       {"loop_ring", "β, weight of each neighbour in Loop's rule (Fig. 3)"},
       {"laplacian_self", "weight of the vertex in L (Fig. 4)"},
       {"laplacian_ring", "weight of each neighbour in L (Fig. 4)"},
       {"inverse_self", "weight of the vertex in I − L/2 (Fig. 5)"},
       {"inverse_ring", "weight of each neighbour in I − L/2 (Fig. 5)"}},
      {}};
  const Member full{"a = 1", "laplacian-loop", {"a=1"}};
  for (int k = kFirst; k <= kLast; ++k) {
    std::vector<report::Cell>& row =
        table.rows.emplace_back(std::vector<report::Cell>{static_cast<double>(k)});
    std::vector<double> values;
    for (const Member* member : {&members.loop, &full, &members.low})
      for (const char* role : {"self", "ring"}) {
        const Result<double> weight = vertex_weight(*member, role, k);
        if (!weight) return weight.error();
        values.push_back(*weight);
      }
    for (const double value :
         {values[0], values[1], values[2] - values[0], values[3] - values[1], values[4], values[5]})
      row.emplace_back(value);
  }
  return table;
}

Status add_stencil_wheels(PaperPage& page, const Members& members) {
  constexpr int k = 5;
  const Result<report::DescribedTable> numbers = stencil_numbers(members);
  if (!numbers) return numbers.error();
  figure::Figure figure(3);
  figure.add(numbering(k), "Old vertices, and the new ones of a step in red.");
  figure.add(wheel(k, "Fig. 3, old vertices", {"1 − /{k}β", "β"}));
  figure.add(edge_stencil(), "2(/{b} + /{c}) = 1; the new vertex in red.");
  figure.add(wheel(k, "Fig. 4, the Laplacian", {"1", "−1//{k}"}), "Its sum is 0.");
  figure.add(wheel(k, "Fig. 5, its pseudo inverse", {"1/2", "1/(2/{k})"}), "Its sum is 1.");
  return page.add_figure(
      {"Figures 2 to 5", "fig02-05"}, figure, *numbers,
      "the subdivision matrix's numbering round a vertex of degree 5; the stencils of the 1-disc, "
      "of the Laplacian L and of its pseudo inverse I − L/2.",
      "the same; the numbers are the weights in the rules of loop, of laplacian-loop with a = 1 "
      "less those of loop, and of laplacian-loop-low with á = 1.");
}

/// Fig. 1 on the cube.
Status add_steps(PaperPage& page, Studio& studio) {
  const Control& cube = studio.cube;
  const Result<Scheme> loop = studio.members.loop.load();
  if (!loop) return loop.error();
  figure::SurfaceScene all;
  all.azimuth = cube.azimuth;
  all.elevation = cube.elevation;
  all.net = study::control_net(cube.mesh, cube.points);
  const figure::ViewFrame frame = limn::figure::frame_of(all);
  figure::Figure figure(4);
  report::DescribedTable numbers{{{"step", "0: the control mesh"},
                                  {"vertices", "of the mesh"},
                                  {"faces", "of the mesh, triangles"},
                                  {"volume", "enclosed [unit of cube.obj, cubed]"}},
                                 {}};
  const auto volume = [](const Mesh& mesh, const std::vector<Point3>& points) {
    double sum = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Index h = mesh.face_begin(f);
      const auto at = [&](Index i) { return points[static_cast<std::size_t>(mesh.origin(h + i))]; };
      sum += dot(at(0), cross(at(1), at(2))) / 6;
    }
    return sum;
  };
  for (int step = 0; step <= 2; ++step) {
    const auto fine = refine::refine(*loop, cube.mesh, cube.points, step);
    if (!fine) return fine.error();
    Control refined = cube;
    refined.mesh = fine->mesh;
    refined.points = fine->values;
    figure.add(control_panel(refined, frame), step == 0   ? "the mesh"
                                              : step == 1 ? "after one step"
                                                          : "after two steps");
    numbers.rows.push_back(
        {static_cast<double>(step), static_cast<double>(fine->mesh.vertex_count()),
         static_cast<double>(fine->mesh.face_count()), volume(fine->mesh, fine->values)});
  }
  const auto limit = studio.surface(cube, studio.members.loop);
  if (!limit) return limit.error();
  figure::SurfaceScene scene = all;
  scene.net = {};
  scene.seen_frame = frame;
  scene.surfaces.push_back(**limit);
  figure.add(figure::ShadedPanel{.scene = std::move(scene), .resolution = 200},
             "the limit surface");
  return page.add_figure(
      {"Figure 1", "fig01"}, figure, numbers,
      "Loop subdivision: a mesh, after one and two steps, and the limit surface.",
      fmt::format("the cube of Figure 10; the limit surface encloses {:.4f}.",
                  size_of(**limit).volume));
}

}  // namespace

Status add_foundations(PaperPage& page, Studio& studio) {
  page.add_heading("§2, §3 Subdivision, the Laplacian and their stencils");
  if (Status status = add_steps(page, studio); !status) return status;
  return add_stencil_wheels(page, studio.members);
}

Status add_circle(PaperPage& page, const Members& members) {
  page.add_heading("§5.1 The eigenvalues of D_k");
  constexpr int k = 7;
  const Result<Scheme> scheme = members.loop.load();
  if (!scheme) return scheme.error();
  const Result<FrequencyBlocks> blocks = FrequencyAnalysis(*scheme, 1).blocks(k);
  if (!blocks) return blocks.error();
  const Eigencomponents found = approx_eigencomponents(*blocks);
  std::vector<double> b;  // weight of ends and of wings at a regular edge
  for (const char* role : {"end", "wing"})
    for (const Weight& weight : scheme->rule(RuleKind::edge)->front().weights)
      if (weight.role == role) {
        const Result<double> value = scheme::Scope<double>(*scheme, k, std::nullopt)(weight.value);
        if (!value) return value.error();
        b.push_back(*value);
      }
  const double centre = b[0], radius = 2 * std::abs(b[1]);
  figure::NetPanel panel;
  panel.place_labels = true;
  constexpr int kRound = 180;
  figure::NetPanel::Net circle{.colour = figure::grey(0.5), .dot = 0},
      drops{.colour = figure::grey(0.6), .stroke = {.width = 0.4, .dash = {1.5, 1.5}}, .dot = 1.1},
      values{.colour = kRed, .dot = 2.2};
  for (int i = 0; i < kRound; ++i) {
    const figure::PagePoint at = on_circle(radius, static_cast<double>(i) / kRound);
    circle.vertices.push_back({centre + at[0], at[1]});
    circle.edges.push_back({i, (i + 1) % kRound});
  }
  report::DescribedTable numbers{{{"frequency", "rotational, j of 0 … k/2"},
                                  {"eigenvalue", "of D_k, from the scheme's 1-ring"},
                                  {"formula", "b + 2c cos(2πj/k); at j = 0 less kβ"}},
                                 {}};
  double worst = 0;
  for (int j = 0; j < k; ++j) {
    const figure::PagePoint at = on_circle(radius, static_cast<double>(j) / k);
    drops.vertices.push_back({centre + at[0], at[1]});
    drops.vertices.push_back({centre + at[0], 0});
    drops.edges.push_back({2 * j, 2 * j + 1});
  }
  for (int j = 0; j <= k / 2; ++j) {
    const auto& list = found.spectra[static_cast<std::size_t>(j)].eigenvalues;
    const double value = list[j == 0 ? 1 : 0].value.real();
    const Result<double> ring = scheme::Scope<double>(
        *scheme, k, std::nullopt)(scheme->rule(RuleKind::vertex)->front().weights.back().value);
    if (!ring) return ring.error();
    const double formula =
        centre + 2 * b[1] * std::cos(2 * std::numbers::pi * j / k) - (j == 0 ? k * *ring : 0);
    worst = std::max(worst, std::abs(value - formula));
    numbers.rows.push_back({static_cast<double>(j), value, formula});
    values.vertices.push_back({value, 0});
    panel.labels.push_back({{value, 0}, j == 0 ? "cup" : fmt::format("/{{j}} = {}", j), {}, kRed});
  }
  figure::NetPanel::Net middle{.vertices = {{centre, 0}}, .dot = 1.2};
  panel.labels.push_back({{centre, 0}, "(/{b}, 0)"});
  panel.arrows.push_back({{-0.02, 0}, {centre + 1.25 * radius, 0}, figure::grey(0.2)});
  panel.nets = {circle, drops, values, middle};
  figure::Figure figure(1, 300);
  figure.add(panel, fmt::format("Loop's /{{b}} = {:.4g}, /{{c}} = {:.4g} at /{{k}} = {}.", centre,
                                b[1], k));
  return page.add_figure(
      {"Figure 35", "fig35"}, figure, numbers,
      "eigenvalues of D_k (red) under points of the circle about (b, 0) with the radius |2c|.",
      fmt::format("the same: the blocks of the 1-ring have them, to {:.0e}. That of frequency 0, "
                  "b + 2c − kβ, is not under a point of the circle.",
                  worst));
}

}  // namespace limn::ks
