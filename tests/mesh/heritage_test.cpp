// Which old faces the faces of a refined mesh are parts of.

#include "limn/mesh/split/heritage.h"

#include <gtest/gtest.h>

#include <map>

#include "mesh/random_mesh.h"

namespace limn::test {
namespace {

/// Of splits that keep old edges: how many faces each old one becomes.
Index children_of(const Split& split, Index degree) {
  if (split.births.thirds) return 9;
  if (split.mixed) return std::max(degree, Index{4});
  return split.births.faces ? degree : 4;
}

class Heritage : public ::testing::TestWithParam<const Split*> {
 protected:
  static Mesh random_mesh(const Split& split, unsigned seed) {
    RandomMesh random(seed);
    if (split.lattice == Lattice::triangle) return random.triangles();
    const Mesh mesh = random.polygons();
    return split.any_polygons ? mesh : find_split("quad-dyadic")->apply(mesh, 0).mesh;
  }
};

TEST_P(Heritage, EachOldFaceHasItsChildren) {
  const Split& split = *GetParam();
  for (unsigned seed = 1; seed < 60; ++seed) {
    const Mesh mesh = random_mesh(split, seed);
    for (int step = 0; step < 2; ++step) {
      const SplitResult fine = split.apply(mesh, step);
      const std::vector<Index> parents = mesh::parent_faces(split, mesh, fine);
      ASSERT_EQ(parents.size(), static_cast<std::size_t>(fine.mesh.face_count()));
      std::map<Index, Index> count;
      for (const Index f : parents) {
        ASSERT_GE(f, 0) << split.name << ", seed " << seed;
        ASSERT_LT(f, mesh.face_count());
        ++count[f];
      }
      if (split.is_dual() || split.boundary_rests()) continue;
      for (Index f = 0; f < mesh.face_count(); ++f)
        ASSERT_EQ(count[f], children_of(split, mesh.degree(f))) << split.name << ", seed " << seed;
    }
  }
}

/// The old faces that a new vertex may lie in.
std::vector<Index> faces_of(const Mesh& mesh, const Births& births, Index vertex) {
  std::vector<Index> faces;
  const auto round = [&](Index v) {
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (mesh.origin(h) == v) faces.push_back(mesh.face(h));
  };
  if (vertex < births.from_vertices) {
    round(vertex);
    return faces;
  }
  Index i = vertex - births.from_vertices;
  if (i < births.from_edges) {
    const Index e = mesh.edge(edge_child(mesh, births, i).halfedge);
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (mesh.edge(h) == e) faces.push_back(mesh.face(h));
    return faces;
  }
  i -= births.from_edges;
  if (i < births.from_faces)
    return {births.faces.empty() ? i : births.faces[static_cast<std::size_t>(i)]};
  return {mesh.face(i - births.from_faces)};
}

TEST_P(Heritage, AParentHasACornerOfEachOfItsFaces) {
  const Split& split = *GetParam();
  for (unsigned seed = 1; seed < 40; ++seed) {
    const Mesh mesh = random_mesh(split, seed);
    const SplitResult fine = split.apply(mesh, 0);
    const std::vector<Index> parents = mesh::parent_faces(split, mesh, fine);
    const bool inside = !split.is_dual() && !split.boundary_rests();
    for (Index g = 0; g < fine.mesh.halfedge_count(); ++g) {
      const std::vector<Index> faces = faces_of(mesh, fine.births, fine.mesh.origin(g));
      const bool found =
          std::find(faces.begin(), faces.end(),
                    parents[static_cast<std::size_t>(fine.mesh.face(g))]) != faces.end();
      if (inside) ASSERT_TRUE(found) << split.name << ", seed " << seed;
    }
  }
}

std::vector<const Split*> all_splits() {
  std::vector<const Split*> list;
  for (const Split& split : splits()) list.push_back(&split);
  return list;
}
INSTANTIATE_TEST_SUITE_P(Splits, Heritage, ::testing::ValuesIn(all_splits()), [](const auto& one) {
  std::string name(one.param->name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace limn::test
