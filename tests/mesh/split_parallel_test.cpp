// However many threads: the same meshes, bit for bit.

#include <gtest/gtest.h>

#include "limn/base/parallel.h"
#include "limn/mesh/split/split.h"
#include "random_mesh.h"

namespace limn::test {
namespace {

TEST(SplitParallel, ThreadsDoNotChangeTheMesh) {
  for (const Split& split : splits()) {
    // large enough for many chunks, and with a boundary
    for (const Mesh& mesh :
         {mesh::torus(split.lattice, 80, 81), mesh::star(split.lattice, 7, 45)}) {
      for (const int step : {0, 1}) {
        set_thread_limit(1);
        const auto serial = snapshot(split.apply(mesh, step).mesh);
        for (const int threads : {0, 2, 3}) {
          set_thread_limit(threads);
          EXPECT_EQ(snapshot(split.apply(mesh, step).mesh), serial) << split.name;
        }
      }
    }
  }
  set_thread_limit(0);
}

}  // namespace
}  // namespace limn::test
