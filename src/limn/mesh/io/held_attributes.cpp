/// Which attributes the formats hold, and what of them no file can.

#include <cmath>

#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/text_writer.h"

namespace limn {
namespace {

/// What a format holds of attributes.
struct Holds {
  bool numbers = false, colours = false, texture = false, labels = false;
};
Holds held_by(std::string_view extension) {
  if (io::is_extension(extension, "obj")) return {false, true, true, true};
  if (io::is_extension(extension, "ply")) return {true, true, true, false};
  if (io::is_extension(extension, "glb")) return {false, true, true, false};
  return {};
}
bool is_colour(const VertexNumbers& column) {
  return column.name == "red" || column.name == "green" || column.name == "blue" ||
         column.name == "alpha";
}

}  // namespace

bool holds_corner_normals(std::string_view extension) {
  return io::is_extension(extension, "obj") || io::is_extension(extension, "glb");
}

std::vector<std::string> lost_attributes(std::string_view extension,
                                         const MeshAttributes& attributes) {
  const Holds holds = held_by(extension);
  const bool colour = static_cast<bool>(colour_of(attributes));
  std::vector<std::string> lost;
  if (colour && !holds.colours) lost.emplace_back("vertex colours");
  for (const VertexNumbers& column : attributes.vertices)
    if (!holds.numbers && !(colour && is_colour(column)))
      lost.push_back("the vertex property '" + column.name + "'");
  if (!attributes.texture.empty() && !holds.texture) lost.emplace_back("texture coordinates");
  for (const LabelKind kind : kLabelKinds)
    if (!attributes.of(kind).empty() && !holds.labels) lost.emplace_back(words_of(kind));
  if (!attributes.material_files.empty() && !holds.labels)
    lost.emplace_back("names of material files");
  return lost;
}

MeshAttributes kept_attributes(std::string_view extension, MeshAttributes attributes) {
  const Holds holds = held_by(extension);
  const bool colour = holds.colours && colour_of(attributes);
  if (!holds.numbers)
    std::erase_if(attributes.vertices,
                  [&](const VertexNumbers& column) { return !(colour && is_colour(column)); });
  if (!holds.texture) attributes.texture = {};
  if (!holds.labels) {
    attributes.labels = {};
    attributes.material_files.clear();
  }
  return attributes;
}

namespace io {

Fault attribute_fault(const MeshAttributes& attributes, double largest) {
  const auto fault = [](const std::string& what, std::size_t number, double value) {
    std::string message = what + " " + std::to_string(number) + " is ";
    append(message, value);
    const bool finite = std::isfinite(value);
    return Fault{message + (finite ? ", beyond what the format's floats hold" : ""),
                 "leave attributes out by --attributes none", !finite};
  };
  const auto is_beyond = [&](double value) { return !(std::abs(value) <= largest); };
  for (const VertexNumbers& column : attributes.vertices)
    for (std::size_t v = 0; v < column.values.size(); ++v)
      if (is_beyond(column.values[v]))
        return fault("the property '" + column.name + "' of vertex", v, column.values[v]);
  const std::vector<TexturePoint>& points = attributes.texture.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const double value : {points[i].u, points[i].v})
      if (is_beyond(value)) return fault("a coordinate of texture point", i, value);
  return {};
}

}  // namespace io
}  // namespace limn
