#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/study/surface_scenes.h"
#include "papers/barthe_parts.h"

namespace limn::bgsk {
namespace {

constexpr int kValence = 7;
constexpr int kRings = 3;

struct Variant {
  const char* scheme;
  const char* spectrum;  // as the paper's (4), (5), (6) state it
};
constexpr Variant kVariants[] = {
    {"loop-7-bounded", "(4)"}, {"loop-7-shrinking", "(5)"}, {"loop-7-flat", "(6)"}};

/// The star in the plane, its rings regular heptagons; the heights are those of a saddle.
std::vector<Point3> control_points(double height) {
  std::vector<Point3> points{{0, 0, 0}};
  for (int ring = 1; ring <= kRings; ++ring)
    for (int sector = 0; sector < kValence; ++sector)
      for (int k = 0; k < ring; ++k) {
        const auto spoke = [](int s) { return 2 * std::numbers::pi * s / kValence; };
        const double x = (ring - k) * std::cos(spoke(sector)) + k * std::cos(spoke(sector + 1));
        const double y = (ring - k) * std::sin(spoke(sector)) + k * std::sin(spoke(sector + 1));
        points.push_back({x, y, height * (x * x - y * y)});
      }
  return points;
}

/// The refined plane, seen from above with its edges.
Result<figure::SurfacePanel> plane_panel(const Scheme& scheme, const Mesh& control) {
  const auto fine = refine::refine(scheme, control, control_points(0), 2);
  if (!fine) return fine.error();
  figure::SurfacePanel panel;
  panel.azimuth = -90;
  panel.elevation = 90;
  panel.mesh_lines = true;
  for (const Point3& p : fine->values) panel.vertices.push_back({p.x, p.y, 0});
  for (Index f = 0; f < fine->mesh.face_count(); ++f) {
    const Index h = fine->mesh.face_begin(f);
    panel.faces.push_back(
        {fine->mesh.origin(h), fine->mesh.origin(h + 1), fine->mesh.origin(h + 2)});
  }
  return panel;
}

/// The eigenvalues by shape [BGSK (4)–(6)].
std::vector<double> spectrum_row(const Eigencomponents& found) {
  const auto leader = [&](std::size_t frequency) {
    return found.spectra[frequency].eigenvalues.front().value.real();
  };
  const double cup = found.spectra[0].eigenvalues[1].value.real();
  return {1, leader(1), leader(1), cup, leader(2), leader(2), leader(3), leader(3)};
}

std::string verdict_words(const Eigencomponents& found) {
  const Verdict& verdict = found.verdict;
  std::string words = fmt::format(
      "necessary conditions of C1: {}, curvature bounded if C1: {}, against tangent² the cup is "
      "{}, "
      "the saddle {}",
      to_string(verdict.c1_necessary), to_string(verdict.bounded_curvature),
      to_string(*verdict.cup), to_string(*verdict.saddle));
  return words;
}

}  // namespace

Status add_variants(PaperPage& page) {
  const Mesh control = mesh::star(Lattice::triangle, kValence, kRings);
  figure::Figure shaded(3);
  figure::Figure lines(3);
  report::DescribedTable numbers{{{"row", "of the figure"},
                                  {"λ0", "eigenvalue of the position"},
                                  {"λ1", "eigenvalue of the tangent plane"},
                                  {"λ2", "eigenvalue of the tangent plane"},
                                  {"λ3", "eigenvalue of the cup"},
                                  {"λ4", "eigenvalue of a saddle"},
                                  {"λ5", "eigenvalue of a saddle"},
                                  {"λ6", "dominant eigenvalue of frequency 3"},
                                  {"λ7", "dominant eigenvalue of frequency 3"},
                                  {"scheme", "its name"},
                                  {"spectrum", "of the paper's that it has"}},
                                 {}};
  report::DescribedTable verdicts{
      {{"row", "of the figure"},
       {"scheme", "its name"},
       {"spectrum", "of the paper's that it has"},
       {"c1_necessary", "whether the necessary conditions of C1 hold"},
       {"bounded_curvature", "whether curvature is bounded at the vertex, if it is C1 there"},
       {"cup", "its eigenvalue against the tangent's squared"},
       {"saddle", "its eigenvalue against the tangent's squared"}},
      {}};
  std::string words;
  for (const Variant& variant : kVariants) {
    const Result<Scheme> scheme = find_scheme(variant.scheme);
    if (!scheme) return scheme.error();
    const Result<figure::SurfacePanel> plane = plane_panel(*scheme, control);
    if (!plane) return plane.error();
    Result<figure::SmoothSurface> surface =
        study::limit_surface(*scheme, control, control_points(0.16), 6);
    if (!surface) return surface.error();
    const Result<FrequencyBlocks> blocks = FrequencyAnalysis(*scheme).blocks(kValence);
    if (!blocks) return blocks.error();
    const Eigencomponents found = approx_eigencomponents(*blocks, find_regular_part(*scheme));
    figure::SurfaceScene scene;
    scene.surfaces.push_back(std::move(*surface));
    scene.azimuth = -62;
    scene.elevation = 42;
    const figure::LightLines lights{.count = 44};
    shaded.add(*plane, fmt::format("{}: spectrum {}", variant.scheme, variant.spectrum));
    shaded.add(figure::ShadedPanel{.scene = scene, .resolution = 200},
               "the saddle's limit surface");
    shaded.add(figure::ShadedPanel{.scene = scene, .stripes = lights, .resolution = 200},
               "reflection lines");
    lines.add(figure::ReflectionLinePanel{.scene = scene, .lights = lights},
              fmt::format("{}, spectrum {}", variant.scheme, variant.spectrum));
    const double row_number = static_cast<double>(numbers.rows.size() + 1);
    std::vector<report::Cell>& row =
        numbers.rows.emplace_back(std::vector<report::Cell>{row_number});
    for (const double value : spectrum_row(found)) row.emplace_back(value);
    row.insert(row.end(), {report::Cell{variant.scheme}, report::Cell{variant.spectrum}});
    verdicts.rows.push_back({row_number, variant.scheme, variant.spectrum,
                             std::string(to_string(found.verdict.c1_necessary)),
                             std::string(to_string(found.verdict.bounded_curvature)),
                             std::string(to_string(*found.verdict.cup)),
                             std::string(to_string(*found.verdict.saddle))});
    words += fmt::format("{} {}: {}. ", variant.scheme, variant.spectrum, verdict_words(found));
  }
  Status status = page.add_figure(
      {"Figure 1", "fig01"}, shaded, numbers,
      "three versions of Loop's scheme at valence 7 with eigenvalues from one set, placed by "
      "(4), (5) and (6): a subdivided planar mesh, a saddle, and reflection lines on it.",
      "the same three behaviours, from scheme files made by `limn prescribe`. " + words);
  if (!status) return status;
  return page.add_figure(
      {"Figure 1, right column, as curves", "fig01-lines"}, lines, verdicts,
      "the right column is a picture of pixels.",
      "the reflection lines of the limit surface as curves: in row 1 they run smoothly through the "
      "vertex, in row 2 they break there, in row 3 the third frequency bends them.");
}

}  // namespace limn::bgsk
