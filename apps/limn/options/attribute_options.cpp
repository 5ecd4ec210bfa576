#include "options/attribute_options.h"

#include <fmt/core.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limn::app {
namespace {

std::vector<std::string> rule_names() {
  std::vector<std::string> names;
  for (const auto& [name, rule] : texture_rules()) names.push_back(name);
  return names;
}

}  // namespace

void AttributeOptions::declare(CLI::App& command) {
  command
      .add_option("--attributes", numbers,
                  "colours and other numbers of vertices: smooth, by the scheme's rules like "
                  "positions; linear; none: all attributes of MESH are left out, texture "
                  "coordinates and names of faces too")
      ->capture_default_str()
      ->check(CLI::IsMember({"smooth", "linear", "none"}));
  declare_texture(command);
}

void AttributeOptions::declare_texture(CLI::App& command) {
  command
      .add_option("--uv", texture,
                  "what of texture coordinates stays in place at seams and boundaries; all: they "
                  "are linear on each face (default: cornersPlus1). Boundaries, all and linear "
                  "numbers are refined by the plain engine")
      ->check(CLI::IsMember(rule_names()));
}

AttributeRules AttributeOptions::rules() const {
  AttributeRules rules;
  rules.linear = numbers == "linear";
  for (const auto& [name, rule] : texture_rules())
    if (name == texture) rules.texture = rule;
  return rules;
}

void leave_out_lost(MeshAttributes& attributes, const std::string& extension,
                    const std::string& output, MeshRemarks& remarks) {
  const std::vector<std::string> lost = lost_attributes(extension, attributes);
  if (lost.empty()) return;
  attributes = kept_attributes(extension, std::move(attributes));
  Error warning(
      fmt::format("left out: {}, which {} files cannot hold", fmt::join(lost, ", "), extension),
      "obj holds texture coordinates, colours and names of faces, ply all numbers of vertices");
  warning.file = output;
  add_warnings(remarks, {warning});
}

Status AttributeOptions::fit(ControlMesh& control, const Scheme& scheme,
                             const std::string& extension, const std::string& output) const {
  leave_out_lost(control.attributes, extension, output, control.remarks);
  const Status takes =
      check_takes_texture(scheme, control.mesh, control.attributes.texture, rules().texture);
  if (takes) return Done{};
  if (!texture.empty()) return takes.error();
  Error warning = takes.error();
  warning.message = "left out: texture coordinates: " + warning.message;
  add_warnings(control.remarks, {warning});
  control.attributes.texture = {};
  return Done{};
}

nlohmann::ordered_json attributes_json(const MeshAttributes& attributes) {
  nlohmann::ordered_json json;
  json["numbers"] = nlohmann::ordered_json::array();
  for (const VertexNumbers& column : attributes.vertices) json["numbers"].push_back(column.name);
  json["texture_points"] = attributes.texture.points.size();
  json["labels"] = nlohmann::ordered_json::object();
  for (const LabelKind kind : kLabelKinds)
    if (!attributes.of(kind).empty())
      json["labels"][words_of(kind)] = attributes.of(kind).names.size();
  return json;
}

}  // namespace limn::app
