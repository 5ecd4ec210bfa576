// Moves a mesh's control points and finds the limit surface in each frame: animate MESH SCHEME
// LEVELS FRAMES. Topology is worked out once.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "limn/fast/fast_refiner.h"
#include "limn/limn.h"
#include "limn/mesh/io/mesh_file.h"

namespace {

int fail(const limn::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: animate MESH SCHEME LEVELS FRAMES\n", stderr);
    return 2;
  }
  const limn::Result<limn::Scheme> scheme = limn::find_scheme(argv[2]);
  if (!scheme) return fail(scheme.error());
  const limn::Result<limn::Polygons> control = limn::read_mesh(argv[1]);
  if (!control) return fail(control.error());
  const limn::Result<limn::Mesh> mesh = limn::Mesh::build(*control);
  if (!mesh) return fail(mesh.error());
  const auto refiner = limn::FastRefiner::make(*scheme, *mesh, std::atoi(argv[3]));
  if (!refiner) return fail(refiner.error());
  const auto limit = limn::approx_fast_limit(*scheme, *refiner);
  if (!limit) return fail(limit.error());
  if (!*limit) {
    std::fputs("so few levels are too coarse for this scheme's limit\n", stderr);
    return 2;
  }

  const auto numbers = 3 * static_cast<std::size_t>(refiner->vertex_count());
  std::vector<float> moved(3 * control->positions.size()), points(numbers), normals(numbers);
  limn::FastRefiner::Scratch<float> scratch;
  const int frames = std::max(1, std::atoi(argv[4]));
  const auto start = std::chrono::steady_clock::now();
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t v = 0; v < control->positions.size(); ++v) {
      const limn::Point3& p = control->positions[v];
      const double lift = 0.1 * std::sin(0.2 * frame + 3 * p.x);
      moved[3 * v] = static_cast<float>(p.x);
      moved[3 * v + 1] = static_cast<float>(p.y);
      moved[3 * v + 2] = static_cast<float>(p.z + lift);
    }
    refiner->evaluate_limit<float>(**limit, moved, points, normals, scratch);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%d vertices, %.3f ms a frame\n", refiner->vertex_count(),
              1e3 * seconds.count() / frames);
}
