#include "limn/mesh/mesh.h"

#include <algorithm>
#include <cassert>

#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"

namespace limn {
namespace {

// the common degree of the faces, or 0; so that every mesh of equal faces takes the quick path
// of face() and next(), however it was made
Index common_degree(const std::vector<Index>& face_begin) {
  if (face_begin.size() < 2) return 0;
  const Index degree = face_begin[1];
  for (std::size_t f = 1; f < face_begin.size(); ++f)
    if (face_begin[f] - face_begin[f - 1] != degree) return 0;
  return degree;
}

// the half-edge that stands for each edge: the lower of the two
std::vector<Index> edge_halfedges(const Mesh::Arrays& arrays) {
  std::vector<Index> result =
      base::large_vector<Index>(static_cast<std::size_t>(arrays.edge_count), kNone);
  base::parallel_for_each(static_cast<Index>(arrays.edge.size()), [&](Index h) {
    if (arrays.twin[h] == kNone || h < arrays.twin[h]) result[arrays.edge[h]] = h;
  });
  return result;
}

// the half-edge of each vertex: the lowest on the boundary, else the lowest; serial, since
// several half-edges write to a vertex (at a bow-tie, which Mesh::build has yet to refuse,
// several boundary ones too)
std::vector<Index> vertex_halfedges(const Mesh::Arrays& arrays) {
  std::vector<Index> result =
      base::large_vector<Index>(static_cast<std::size_t>(arrays.vertex_count), kNone);
  const Index count = static_cast<Index>(arrays.origin.size());
  for (Index h = count; h-- > 0;) result[arrays.origin[h]] = h;
  for (Index h = count; h-- > 0;)
    if (arrays.twin[h] == kNone) result[arrays.origin[h]] = h;
  return result;
}

}  // namespace

Mesh Mesh::from_arrays(Arrays arrays) {
  assert(arrays.twin.size() == arrays.origin.size() && arrays.edge.size() == arrays.origin.size());
  Mesh mesh;
  const Index halfedges = static_cast<Index>(arrays.origin.size());
  mesh.degree_ = arrays.degree > 0 ? arrays.degree : common_degree(arrays.face_begin);
  if (halfedges == 0) mesh.degree_ = 0;
  mesh.edge_halfedge_ = edge_halfedges(arrays);
  mesh.vertex_halfedge_ = vertex_halfedges(arrays);
  mesh.origin_ = std::move(arrays.origin);
  mesh.twin_ = std::move(arrays.twin);
  mesh.edge_ = std::move(arrays.edge);
  if (mesh.degree_ > 0) {
    assert(halfedges % mesh.degree_ == 0);
    mesh.face_count_ = halfedges / mesh.degree_;
    return mesh;
  }
  mesh.face_begin_ = std::move(arrays.face_begin);
  if (mesh.face_begin_.empty()) mesh.face_begin_ = {0};
  mesh.face_count_ = static_cast<Index>(mesh.face_begin_.size()) - 1;
  mesh.face_ = base::large_vector<Index>(mesh.origin_.size());
  base::parallel_for_each(mesh.face_count_, [&](Index f) {
    std::fill(mesh.face_.begin() + mesh.face_begin_[f],
              mesh.face_.begin() + mesh.face_begin_[f + 1], f);
  });
  return mesh;
}

bool Mesh::has_boundary() const {
  return std::find(twin_.begin(), twin_.end(), kNone) != twin_.end();
}

Index Mesh::valence(Index v) const {
  const Index first = vertex_halfedge_[v];
  if (first == kNone) return 0;
  Index count = 0, h = first;
  do {
    ++count;
    h = rotate(h);
  } while (h != kNone && h != first);
  return h == kNone ? count + 1 : count;  // a fan of k faces has k + 1 edges
}

Index Mesh::max_valence() const {
  Index most = 0;
  for (Index v = 0; v < vertex_count(); ++v) most = std::max(most, valence(v));
  return most;
}

Index Mesh::max_degree() const {
  if (degree_ > 0) return degree_;
  Index most = 0;
  for (Index f = 0; f < face_count_; ++f) most = std::max(most, degree(f));
  return most;
}

Polygons Mesh::polygons(std::vector<Point3> positions) const {
  assert(positions.size() == vertex_halfedge_.size());
  Polygons result;
  result.positions = std::move(positions);
  base::reserve_large(result.corners, origin_.size());
  result.corners = origin_;
  result.face_begin = base::large_vector<Index>(static_cast<std::size_t>(face_count_) + 1);
  for (Index f = 0; f <= face_count_; ++f) result.face_begin[f] = face_begin(f);
  return result;
}

}  // namespace limn
