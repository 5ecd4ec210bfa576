/// libFuzzer target: the input is a scheme file. Nothing may crash or take long, a refusal must
/// name a place in the text, and what is accepted must refine small meshes, or say why it cannot.
///
///     ./scheme_file_fuzz -max_len=8192 -timeout=10 CORPUS schemes

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"
#include "limn/scheme/scheme.h"

namespace {

using limn::Index;
using limn::Lattice;
using limn::Mesh;
using limn::Point3;
using limn::Result;
using limn::Scheme;

// in a folder that is not there, so that `extends` finds the shipped schemes only
constexpr const char* kPath = "/no-such-folder/fuzz.toml";

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

Mesh build(Index vertices, const std::vector<std::vector<Index>>& faces) {
  limn::Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(vertices));
  for (const auto& face : faces) {
    polygons.corners.insert(polygons.corners.end(), face.begin(), face.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return Mesh::build(polygons).value();
}

/// Closed and open, regular and not.
const std::vector<Mesh>& meshes(Lattice lattice) {
  static const std::vector<Mesh> triangles{build(4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}),
                                           limn::mesh::torus(Lattice::triangle, 4, 3),
                                           limn::mesh::star(Lattice::triangle, 5, 2),
                                           limn::mesh::star(Lattice::triangle, 6, 1)};
  static const std::vector<Mesh> polygons{
      build(8,
            {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}),
      build(6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}),
      limn::mesh::torus(Lattice::quad, 4, 3), limn::mesh::star(Lattice::quad, 5, 2),
      limn::mesh::face_star(5, 2)};
  return lattice == Lattice::triangle ? triangles : polygons;
}

void check_error(const limn::Error& error, const std::string& text) {
  check(!error.message.empty(), "an error has a message");
  for (const char c : error.text())
    check(static_cast<unsigned char>(c) >= ' ' || c == '\n', "a message is lines of text");
  if (error.file != kPath) return;  // in a scheme that the text extends
  const auto lines = std::count(text.begin(), text.end(), '\n') + 2;
  check(error.line >= 0 && error.line <= lines, "the line is one of the text");
  check(error.column >= 0 && error.column <= static_cast<int>(text.size()) + 2,
        "the column is one of the text");
}

void refine_all(const Scheme& scheme) {
  for (const Mesh& mesh : meshes(scheme.split->lattice)) {
    std::vector<Point3> positions(static_cast<std::size_t>(mesh.vertex_count()));
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = {std::cos(static_cast<double>(v)), std::sin(3.0 * static_cast<double>(v)),
                      static_cast<double>(v % 3)};
    const Result<limn::refine::Refined<Point3>> refined =
        limn::refine::refine<Point3>(scheme, mesh, std::move(positions), 2);
    if (!refined) {
      check(!refined.error().message.empty(), "a failure to refine has a message");
      continue;
    }
    check(static_cast<Index>(refined->values.size()) == refined->mesh.vertex_count(),
          "a value for each vertex");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Result<Scheme> scheme = limn::parse_scheme(text, kPath);
  if (scheme)
    refine_all(*scheme);
  else
    check_error(scheme.error(), text);
  return 0;
}
