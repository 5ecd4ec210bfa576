#include "options/sharpness_options.h"

#include <fmt/core.h>

#include "limn/refine/crease_step.h"
#include "limn/surface/tags_file.h"
#include "options/number_option.h"

namespace limn::app {
namespace {

template <class Value>
std::vector<std::string> words(const std::vector<std::pair<std::string, Value>>& known) {
  std::vector<std::string> result;
  for (const auto& [word, value] : known) result.push_back(word);
  return result;
}

/// Precondition: it is one of them.
template <class Value>
Value value_of(const std::string& name, const std::vector<std::pair<std::string, Value>>& known) {
  for (const auto& [word, value] : known)
    if (word == name) return value;
  return known.front().second;
}

}  // namespace

void SharpnessOptions::declare(CLI::App& command) {
  command
      .add_option(
          "--tags", tags_file,
          "sharp edges, corners and holes from FILE (.toml), by the numbers of MESH or by names of "
          "its faces (groups, objects, materials), beside what an .obj file's own tags ('t') say")
      ->type_name("FILE");
  command.add_flag("--no-tags", no_tags, "leave the tags of MESH itself out");
  command
      .add_option("--crease-angle", crease_angle,
                  "edges whose faces' normals differ by more than DEG degrees are infinitely sharp")
      ->type_name("DEG")
      ->check(number_between(0, 180));
  command
      .add_option(
          "--boundary", boundary,
          "edgeOnly: the boundary is a curve; edgeAndCorner: with corners where a vertex "
          "has one face; none: faces at it are left out (default: edgeOnly, or as tags say)")
      ->check(CLI::IsMember(words(boundary_modes())));
  command
      .add_option("--creases", creases,
                  "how sharpness fades, uniform or chaikin (default: uniform, or as tags say)")
      ->check(CLI::IsMember(words(crease_methods())));
  command
      .add_option(
          "--triangles", triangles,
          "smooth: triangles amid other faces are refined more evenly, where the scheme has "
          "a rule for that (default: catmullClark, or as tags say)")
      ->check(CLI::IsMember({"catmullClark", "smooth"}));
}

namespace {

/// Whether the scheme takes what keeps a cut mesh's copies together [DeRoseKassTruong1998].
bool takes_cuts(ControlMesh& control, const Scheme& scheme) {
  Sharpness held;
  mesh::hold_cuts(control.mesh, control.cuts, held);
  const Status takes = refine::check_takes_sharpness(scheme, held);
  if (takes.ok()) return true;
  add_warnings(
      control.remarks,
      {{fmt::format("vertices that were cut are not held in place: {}", takes.error().message),
        "sheets that met in one vertex may part there"}});
  return false;
}

}  // namespace

Result<Sharpness> SharpnessOptions::of(ControlMesh& control, Scheme& scheme) const {
  const bool holds = takes_cuts(control, scheme);
  Sharpness sharpness;
  BoundaryMode mode = BoundaryMode::edge_only;
  bool smooth = false;
  const auto add = [&](const SharpnessTags& tags) -> Status {
    if (tags.boundary) mode = *tags.boundary;
    if (tags.smooth_triangles) smooth = *tags.smooth_triangles;
    if (smooth && tags.smooth_triangles && triangles.empty() && !scheme.smooth_triangles) {
      Error warning(fmt::format(
          "{} has no rule for smooth triangles, which are refined like others", scheme.name));
      warning.file = tags.file;
      warning.line = tags.line;
      add_warnings(control.remarks, {warning});
    }
    return apply_tags(control.mesh, control.source, tags, sharpness);
  };
  if (Status status = add(control.tags); !status) return status.error();
  if (!tags_file.empty()) {
    surface::LabelTags labels;
    const Result<SharpnessTags> tags =
        surface::read_tags_file(tags_file, control.source.first, &labels);
    if (!tags) return tags.error();
    if (Status named =
            surface::apply_label_tags(control.mesh, control.attributes, labels, sharpness);
        !named)
      return named.error();
    if (Status status = add(*tags); !status) return status.error();
  }
  if (crease_angle >= 0)
    (void)sharpen_by_angle(control.mesh, control.points, crease_angle, sharpness);
  if (!creases.empty()) sharpness.method = value_of(creases, crease_methods());
  if (!boundary.empty()) mode = value_of(boundary, boundary_modes());
  if (holds) mesh::hold_cuts(control.mesh, control.cuts, sharpness);
  mesh::apply_boundary_mode(control.mesh, mode, control.cuts, sharpness);
  if (!triangles.empty()) smooth = triangles == "smooth";
  if (smooth && !use_smooth_triangles(scheme) && !triangles.empty())
    return Error{fmt::format("{} has no rule for smooth triangles", scheme.name),
                 "leave out --triangles, or state [smooth-triangles] in a scheme file", scheme.file,
                 0, 0};
  return sharpness;
}

}  // namespace limn::app
