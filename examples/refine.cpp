// Refines a mesh with a scheme: refine MESH SCHEME LEVELS OUT
#include <cstdio>
#include <cstdlib>

#include "limn/limn.h"

namespace {

int fail(const limn::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: refine MESH SCHEME LEVELS OUT\n", stderr);
    return 2;
  }
  const limn::Result<limn::Scheme> scheme = limn::find_scheme(argv[2]);
  if (!scheme) return fail(scheme.error());
  const limn::Result<limn::Polygons> control = limn::read_mesh(argv[1]);
  if (!control) return fail(control.error());
  const limn::Result<limn::Mesh> mesh = limn::Mesh::build(*control);
  if (!mesh) return fail(mesh.error());
  const limn::Result<limn::RefinedSurface> fine =
      limn::refine_surface(*scheme, *mesh, control->positions, {.levels = std::atoi(argv[3])});
  if (!fine) return fail(fine.error());
  const limn::Status written = limn::write_mesh(argv[4], fine->polygons);
  return written ? 0 : fail(written.error());
}
