#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/surface_distance.h"
#include "limn/report/compare/compare_figure.h"
#include "limn/study/surface_scenes.h"
#include "papers/kawaharada_parts.h"

namespace limn::ks {
namespace {

constexpr double kResolution = 200;
constexpr double kSupport = 3.01;  // where basis functions are not 0
constexpr double kFar = std::numeric_limits<double>::infinity();

figure::SurfaceScene empty_scene(const Control& control, const figure::ViewFrame& frame) {
  figure::SurfaceScene scene;
  scene.azimuth = control.azimuth;
  scene.elevation = control.elevation;
  scene.seen_frame = frame;
  return scene;
}

/// A figure of one control mesh: which of the paper's it holds, and what it says of them.
struct Plate {
  PaperItem item;
  std::string printed;
  bool shows_control = false;
  std::vector<Member> alone = {};                        ///< a panel each
  std::vector<std::pair<Member, Member>> overlaid = {};  ///< the first green, the second pink
};

/// The numbers of a plate in words.
std::string found_words(const Control& control, const Plate& plate,
                        const std::vector<SurfaceSize>& sizes) {
  if (!plate.overlaid.empty())
    return "each surface is seen where it lies over the other; distances from limit points.";
  const bool open = control.mesh.has_boundary();
  std::string words = open ? "lowest and highest points: " : "enclosed volumes: ";
  for (std::size_t i = 0; i < plate.alone.size(); ++i) {
    words += fmt::format("{}{} ", i == 0 ? "" : ", ", plate.alone[i].words);
    words += open ? fmt::format("{:.4f} and {:.4f}", sizes[i].lowest + 0.0, sizes[i].highest)
                  : fmt::format("{:.4f}", sizes[i].volume);
  }
  return words + ".";
}

/// What shows all that is in a plate.
Result<figure::ViewFrame> frame_of(Studio& studio, const Control& control, const Plate& plate) {
  figure::SurfaceScene all;
  all.azimuth = control.azimuth;
  all.elevation = control.elevation;
  if (plate.shows_control) all.net = study::control_net(control.mesh, control.points);
  std::vector<Member> members = plate.alone;
  for (const auto& [green, pink] : plate.overlaid) members.insert(members.end(), {green, pink});
  for (const Member& member : members) {
    const auto surface = studio.surface(control, member);
    if (!surface) return surface.error();
    all.surfaces.emplace_back().vertices = (*surface)->vertices;
  }
  return limn::figure::frame_of(all);
}

Status add_alone(figure::Figure& figure, report::DescribedTable& numbers,
                 std::vector<SurfaceSize>& sizes, Studio& studio, const Control& control,
                 const Plate& plate, const figure::ViewFrame& frame) {
  const std::string unit = fmt::format("[unit of {}.obj", control.name);
  numbers.columns = {
      {"surface", "the scheme of the limit surface"},
      {"area", "of it " + unit + ", squared]"},
      {"volume",
       (control.mesh.has_boundary() ? "between it and z = 0 " : "enclosed ") + unit + ", cubed]"},
      {"lowest", "least z " + unit + "]"},
      {"highest", "largest z " + unit + "]"}};
  for (const Member& member : plate.alone) {
    const auto surface = studio.surface(control, member);
    if (!surface) return surface.error();
    figure::SurfaceScene scene = empty_scene(control, frame);
    scene.surfaces.push_back(**surface);
    figure.add(figure::ShadedPanel{.scene = std::move(scene), .resolution = kResolution},
               member.words);
    const SurfaceSize size = size_of(**surface);
    sizes.push_back(size);
    numbers.rows.push_back({member.words, size.area, size.volume, size.lowest, size.highest});
  }
  return Done{};
}

figure::SpaceVector between(const std::vector<figure::SpaceVector>& list, int from, int to,
                            double t) {
  const figure::SpaceVector& a = list[static_cast<std::size_t>(from)];
  const figure::SpaceVector& b = list[static_cast<std::size_t>(to)];
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// The part of a surface beyond the vertical plane through the middle of its control mesh, as the
/// viewer sees it: what it covers comes to light.
figure::SmoothSurface far_half(const figure::SmoothSurface& surface, const Control& control) {
  const double azimuth = control.azimuth * std::numbers::pi / 180;
  const auto nearness = [&](double x, double y) {
    return std::cos(azimuth) * x + std::sin(azimuth) * y;
  };
  double middle = 0;
  for (const Point3& p : control.points) middle += nearness(p.x, p.y);
  middle /= static_cast<double>(control.points.size());
  figure::SmoothSurface half = surface;
  half.triangles.clear();
  const auto height = [&](int v) {  // above the plane, towards the viewer
    const figure::SpaceVector& p = half.vertices[static_cast<std::size_t>(v)];
    return nearness(p[0], p[1]) - middle;
  };
  for (const std::array<int, 3>& t : surface.triangles) {
    std::vector<int> kept;  // corners of the part beyond the plane
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = t[i], to = t[(i + 1) % 3];
      const double a = height(from), b = height(to);
      if (a <= 0) kept.push_back(from);
      if ((a <= 0) == (b <= 0)) continue;
      kept.push_back(static_cast<int>(half.vertices.size()));
      half.vertices.push_back(between(half.vertices, from, to, a / (a - b)));
      half.normals.push_back(between(half.normals, from, to, a / (a - b)));
    }
    for (std::size_t i = 2; i < kept.size(); ++i)
      half.triangles.push_back({kept[0], kept[i - 1], kept[i]});
  }
  return half;
}

Status add_overlays(figure::Figure& figure, report::DescribedTable& numbers, Studio& studio,
                    const Control& control, const Plate& plate, const figure::ViewFrame& frame) {
  const std::string unit = fmt::format("[unit of {}.obj]", control.name);
  numbers.columns = {{"green", "the scheme of the green limit surface"},
                     {"pink", "the scheme of the pink one"},
                     {"largest_distance", "between the two " + unit},
                     {"mean_distance", "between the two " + unit},
                     {"diagonal", "of the box round both " + unit}};
  for (const auto& [green, pink] : plate.overlaid) {
    const auto first = studio.surface(control, green), second = studio.surface(control, pink);
    if (!first) return first.error();
    if (!second) return second.error();
    const Result<mesh::SurfaceDistance> apart =
        mesh::approx_surface_distance(study::polygons_of(**first), study::polygons_of(**second));
    if (!apart) return apart.error();
    figure::ShadedPanel panel = report::overlaid({green.words, **first}, {pink.words, **second});
    figure::SurfaceScene scene = empty_scene(control, frame);
    scene.surfaces = std::move(panel.scene.surfaces);
    panel.scene = std::move(scene);
    panel.resolution = kResolution;
    figure.add(panel, "Distance: " + report::distance_text(*apart));
    if (!control.mesh.has_boundary()) {
      panel.scene.surfaces.front() = far_half(panel.scene.surfaces.front(), control);
      panel.outlines = false;
      figure.add(std::move(panel), "the same without the near half of the green one");
    }
    numbers.rows.push_back({green.words, pink.words, apart->largest, apart->mean, apart->diagonal});
  }
  return Done{};
}

Status add_plate(PaperPage& page, Studio& studio, const Control& control, const Plate& plate) {
  figure::Figure figure(2);
  report::DescribedTable numbers;
  std::vector<SurfaceSize> sizes;
  const Result<figure::ViewFrame> frame = frame_of(studio, control, plate);
  if (!frame) return frame.error();
  if (plate.shows_control) figure.add(control_panel(control, *frame), control.title);
  Status status = plate.overlaid.empty()
                      ? add_alone(figure, numbers, sizes, studio, control, plate, *frame)
                      : add_overlays(figure, numbers, studio, control, plate, *frame);
  if (!status) return status;
  return page.add_figure(plate.item, figure, numbers, plate.printed,
                         found_words(control, plate, sizes));
}

/// The figures of one section, in the paper's order.
Status add_torus_and_cube(PaperPage& page, Studio& studio) {
  const Members& m = studio.members;
  page.add_heading("§3.4 Laplacian Loop: the torus and the cube");
  const std::vector<Member> loops{m.loop, m.high, m.low};
  for (const auto& [control, plate] : std::vector<std::pair<const Control*, Plate>>{
           {&studio.torus,
            {{"Figures 6 to 9", "fig06-09"},
             "a torus and its limit surfaces: Loop, high pass with a = kβ − 2/8 + 2/8 cos(3π/k), "
             "low "
             "pass with á = 1.",
             true,
             loops}},
           {&studio.cube,
            {{"Figures 10 to 13", "fig10-13"},
             "the same of a cube: the high pass keeps the outline more than Loop does.",
             true,
             loops}},
           {&studio.torus,
            {{"Figure 14", "fig14"},
             "Loop in green, low pass in pink: the low pass shrinks the surface.",
             false,
             {},
             {{m.loop, m.low}}}},
           {&studio.cube,
            {{"Figure 15", "fig15"}, "the same of the cube.", false, {}, {{m.loop, m.low}}}}})
    if (Status status = add_plate(page, studio, *control, plate); !status) return status;
  return Done{};
}

/// A cut through basis functions, along an edge of the control mesh.
Status add_profiles(PaperPage& page, Studio& studio) {
  const Members& m = studio.members;
  figure::Figure figure(2);
  report::DescribedTable numbers{{{"x", "along a line of edges [control edges]"}}, {}};
  for (const auto& list : {std::vector<Member>{m.butterfly, m.eighth, m.sixteenths},
                           {m.loop, m.optimal_high, m.optimal, m.optimal_low}}) {
    figure::ChartPanel panel;
    panel.x_label = "edges of the control mesh";
    for (const Member& member : list) {
      const auto surface = studio.surface(studio.raised, member);
      if (!surface) return surface.error();
      std::vector<std::pair<double, double>> points;
      for (const figure::SpaceVector& p : (*surface)->vertices)
        if (std::abs(p[1]) < 1e-9 && std::abs(p[0]) < kSupport) points.emplace_back(p[0], p[2]);
      std::sort(points.begin(), points.end());
      figure::ChartPanel::Series series{.name = member.words};
      for (std::size_t i = 0; i < points.size(); ++i) {
        series.x.push_back(points[i].first);
        series.y.push_back(points[i].second);
        if (numbers.columns.size() == 1) numbers.rows.push_back({points[i].first});
        numbers.rows[i].emplace_back(points[i].second);
      }
      numbers.columns.push_back({member.words, "height of its basis function over x"});
      panel.series.push_back(std::move(series));
    }
    figure.add(std::move(panel));
  }
  return page.add_figure(
      {"Basis functions in section", "profiles"}, figure, numbers, "(not in the paper)",
      "the surfaces of Figures 24 to 26 and 37 to 40 over a line of edges: a butterfly's peak gets "
      "sharper with b, an optimal scheme's is lower with every step to the low pass.");
}

Status add_butterflies(PaperPage& page, Studio& studio) {
  const Members& m = studio.members;
  page.add_heading("§4.2 Laplacian butterfly: the basis function and the cube");
  const std::vector<Member> butterflies{m.butterfly, m.eighth, m.sixteenths};
  const std::vector<std::pair<Member, Member>> pairs{{m.butterfly, m.eighth},
                                                     {m.eighth, m.sixteenths}};
  for (
      const auto& [control, plate] : std::vector<std::pair<const Control*, Plate>>{
          {&studio.raised,
           {{"Figures 23 to 26", "fig23-26"},
            "a flat mesh with one vertex raised, and the basis functions of the butterfly and of "
            "the low pass with b = 1/8 and b = 3/16.",
            true,
            butterflies}},
          {&studio.raised,
           {{"Figures 27 and 28", "fig27-28"},
            "pairs of basis functions in green and pink.",
            false,
            {},
            pairs}},
          {&studio.cube,
           {{"Figures 29 to 32", "fig29-32"},
            "the same schemes of a cube, with the stencil of Zorin et al. at extraordinary points.",
            true,
            butterflies}},
          {&studio.cube, {{"Figures 33 and 34", "fig33-34"}, "pairs of those.", false, {}, pairs}}})
    if (Status status = add_plate(page, studio, *control, plate); !status) return status;
  return Done{};
}

Status add_optimal(PaperPage& page, Studio& studio) {
  const Members& m = studio.members;
  page.add_heading("§5.2 Optimal schemes: the basis function and the cube");
  for (const auto& [control, plate] : std::vector<std::pair<const Control*, Plate>>{
           {&studio.raised,
            {{"Figures 37 to 40", "fig37-40"},
             "basis functions of the optimal schemes (high pass, middle, low pass) and of Loop.",
             false,
             {m.optimal_high, m.optimal, m.optimal_low, m.loop}}},
           {&studio.raised,
            {{"Figures 41 to 45", "fig41-45"},
             "pairs of them in green and pink.",
             false,
             {},
             {{m.loop, m.optimal_high},
              {m.loop, m.optimal},
              {m.loop, m.optimal_low},
              {m.optimal_high, m.optimal},
              {m.optimal, m.optimal_low}}}},
           {&studio.cube,
            {{"Figure 46", "fig46"},
             "the cube under the optimal scheme (green) and its low pass (pink).",
             false,
             {},
             {{m.optimal, m.optimal_low}}}}})
    if (Status status = add_plate(page, studio, *control, plate); !status) return status;
  return Done{};
}

Status add_control_files(PaperPage& page, const Studio& studio) {
  page.add_heading("Control meshes");
  for (const Control* control : {&studio.torus, &studio.cube, &studio.raised}) {
    const Result<std::string> text = format_mesh("obj", control->mesh.polygons(control->points));
    if (!text) return text.error();
    if (Status status = page.add_file(control->name + ".obj", *text, control->title); !status)
      return status;
  }
  return Done{};
}

}  // namespace

figure::ShadedPanel control_panel(const Control& control, const figure::ViewFrame& frame) {
  figure::SmoothSurface faces;
  for (Index f = 0; f < control.mesh.face_count(); ++f) {
    const Index first = control.mesh.face_begin(f);
    std::array<Point3, 3> corner;
    for (Index i = 0; i < 3; ++i) corner[i] = control.points[control.mesh.origin(first + i)];
    const Point3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const int at = static_cast<int>(faces.vertices.size());
    for (const Point3& p : corner) {
      faces.vertices.push_back({p.x, p.y, p.z});
      faces.normals.push_back({normal.x, normal.y, normal.z});
    }
    faces.triangles.push_back({at, at + 1, at + 2});
  }
  figure::SurfaceScene scene = empty_scene(control, frame);
  scene.surfaces.push_back(std::move(faces));
  scene.net = study::control_net(control.mesh, control.points);
  return {.scene = std::move(scene), .resolution = kResolution};
}

SurfaceSize size_of(const figure::SmoothSurface& surface) {
  SurfaceSize size{.lowest = kFar, .highest = -kFar};
  const auto point = [&](int v) {
    const figure::SpaceVector& p = surface.vertices[static_cast<std::size_t>(v)];
    return Point3{p[0], p[1], p[2]};
  };
  for (const auto& [i, j, k] : surface.triangles) {
    const Point3 a = point(i), b = point(j), c = point(k);
    const Point3 normal = cross(b - a, c - a);
    size.area += std::sqrt(dot(normal, normal)) / 2;
    size.volume += normal.z / 2 * (a.z + b.z + c.z) / 3;
  }
  for (const figure::SpaceVector& p : surface.vertices) {
    size.lowest = std::min(size.lowest, p[2]);
    size.highest = std::max(size.highest, p[2]);
  }
  return size;
}

Status add_surfaces(PaperPage& page, Studio& studio) {
  for (const auto& add : {add_torus_and_cube, add_butterflies, add_optimal, add_profiles})
    if (Status status = add(page, studio); !status) return status;
  return add_control_files(page, studio);
}

Result<Scheme> Member::load() const {
  Result<Scheme> found = find_scheme(scheme);
  if (!found) return found;
  if (Status status = set_parameters(*found, parameters); !status) return status.error();
  return found;
}

Studio::Studio() : torus(torus_control()), cube(cube_control()), raised(raised_control()) {}

Result<const figure::SmoothSurface*> Studio::surface(const Control& control, const Member& member) {
  const std::pair key{control.name, member.words};
  if (const auto known = surfaces_.find(key); known != surfaces_.end()) return &known->second;
  const Result<Scheme> scheme = member.load();
  if (!scheme) return scheme.error();
  Result<figure::SmoothSurface> made =
      study::limit_surface(*scheme, control.mesh, control.points, control.steps);
  if (!made) return made.error();
  return &surfaces_.emplace(key, std::move(*made)).first->second;
}

}  // namespace limn::ks
