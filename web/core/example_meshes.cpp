#include "example_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/base/printable.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/lattice.h"

namespace limn::page {
namespace {

constexpr Index kRings = 3;
constexpr std::array<Index, 9> kValences{3, 4, 5, 6, 7, 8, 9, 10, 12};

std::string hill_name(Index valence, Lattice lattice) {
  return fmt::format("vertex-{}-{}", valence, lattice == Lattice::triangle ? "triangles" : "quads");
}

/// A point of a sector's plane, a edges along its first spoke and b along the next, on the hill,
/// whose height is y, as the page has it.
Point3 on_hill(Index valence, Index sector, double a, double b) {
  const double angle = 2 * std::numbers::pi / valence;
  const double x = a * std::cos(sector * angle) + b * std::cos((sector + 1) * angle);
  const double y = a * std::sin(sector * angle) + b * std::sin((sector + 1) * angle);
  return {x, 1.5 * std::exp(-(x * x + y * y) / 3), -y};
}

/// The points of `star` in the order of their numbers (mesh/lattice.h).
std::vector<Point3> hill_points(Index valence, Lattice lattice) {
  std::vector<Point3> points{on_hill(valence, 0, 0, 0)};
  for (Index ring = 1; ring <= kRings; ++ring)
    for (Index sector = 0; sector < valence; ++sector) {
      const Index count = lattice == Lattice::triangle ? ring : 2 * ring;
      for (Index i = 0; i < count; ++i) {
        const Index a = lattice == Lattice::triangle || i > ring ? count - i : ring;
        points.push_back(on_hill(valence, sector, a, std::min(i, ring)));
      }
    }
  return points;
}

Result<std::string> hill(Index valence, Lattice lattice) {
  const Mesh mesh = mesh::star(lattice, valence, kRings);
  return format_mesh("obj", mesh.polygons(hill_points(valence, lattice)));
}

/// The file's first remark; where that names the mesh, the beginning of the one after it.
std::string summary_of(const EmbeddedMesh& mesh) {
  std::string_view text = mesh.text;
  const auto take_line = [&] {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.starts_with("# ")) line.remove_prefix(2);
    return line;
  };
  const std::string_view first = take_line();
  if (!first.starts_with(std::string(mesh.name) + ":")) return base::printable(first);
  const std::string_view second = take_line();
  return base::printable(second.substr(0, second.find(':')));
}

}  // namespace

std::vector<ExampleMesh> example_meshes() {
  std::vector<ExampleMesh> list;
  for (const EmbeddedMesh& mesh : embedded_meshes())
    list.push_back({std::string(mesh.name), summary_of(mesh)});
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (const Index valence : kValences)
      list.push_back({hill_name(valence, lattice),
                      fmt::format("A hill round a vertex of valence {}, open", valence)});
  return list;
}

Result<std::string> example_mesh(const std::string& name) {
  for (const EmbeddedMesh& mesh : embedded_meshes())
    if (mesh.name == name) return std::string(mesh.text);
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (const Index valence : kValences)
      if (hill_name(valence, lattice) == name) return hill(valence, lattice);
  std::string known;
  for (const ExampleMesh& mesh : example_meshes()) known += (known.empty() ? "" : ", ") + mesh.name;
  return Error{fmt::format("there is no example mesh '{}'", base::printable(name)),
               "there are " + known};
}

}  // namespace limn::page
