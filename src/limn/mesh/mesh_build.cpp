// Mesh::build: polygons to half-edges, or the reason why they are no oriented 2-manifold.

#include <algorithm>
#include <optional>

#include "limn/base/parallel.h"
#include "limn/mesh/mesh.h"

namespace limn {
namespace {

using Fault = std::optional<Error>;

Error fault(std::string message, std::string hint) {
  Error error;
  error.message = std::move(message);
  error.hint = std::move(hint);
  return error;
}

std::string number(std::size_t i) { return std::to_string(i); }
std::string number(Index i) { return std::to_string(i); }

std::vector<Index> filled(Index count, Index value) {
  return std::vector<Index>(static_cast<std::size_t>(count), value);
}

// "0, 2 and 5"; long lists are cut, since a fault needs a place and not a census
std::string list(const std::vector<Index>& items) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t i = 0; i < items.size() && i < kMost; ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += number(items[i]);
  }
  return items.size() > kMost ? text + ", …" : text;
}

Error out_of_range(const Polygons& polygons, Index f, Index corner) {
  const Index v = polygons.corners[corner], count = polygons.vertex_count();
  std::string message = "corner " + number(corner - polygons.face_begin[f]) + " of face " +
                        number(f) + " is vertex " + number(v) + ", but ";
  message += count == 0 ? "there are no vertices" : "the vertices are 0 to " + number(count - 1);
  return fault(message, "vertices, faces and corners count from 0 here");
}

// face by face: enough corners, each a vertex, none twice
Fault check_faces(const Polygons& polygons) {
  const auto& begin = polygons.face_begin;
  if (begin.empty() || begin.front() != 0 ||
      static_cast<std::size_t>(begin.back()) != polygons.corners.size())
    return fault("the face offsets do not run from 0 to the number of corners",
                 "face_begin holds one offset more than there are faces");
  for (Index f = 0; f < polygons.face_count(); ++f)
    if (polygons.degree(f) < 3)  // also keeps every offset within `corners`
      return fault("face " + number(f) + " has " + number(polygons.degree(f)) +
                       " corners, but a face needs at least 3",
                   "remove the face; faces count from 0 here");
  std::vector<Index> seen_by = filled(polygons.vertex_count(), kNone);
  for (Index f = 0; f < polygons.face_count(); ++f) {
    for (Index c = begin[f]; c < begin[f + 1]; ++c) {
      const Index v = polygons.corners[c];
      if (v < 0 || v >= polygons.vertex_count()) return out_of_range(polygons, f, c);
      if (seen_by[v] == f)
        return fault("face " + number(f) + " meets vertex " + number(v) + " twice",
                     "remove the repeated corner, or cut the face in two there");
      seen_by[v] = f;
    }
  }
  return {};
}

class TwinMatcher {
 public:
  explicit TwinMatcher(const Polygons& polygons)
      : polygons_(polygons), origin_(polygons.corners), target_(origin_.size()) {
    parallel_for_each(polygons.face_count(), [&](Index f) {
      const Index first = polygons.face_begin[f], last = polygons.face_begin[f + 1];
      for (Index h = first; h < last; ++h) target_[h] = origin_[h + 1 < last ? h + 1 : first];
    });
    fill_buckets();
  }

  /// Twins of all half-edges, or why two faces do not fit.
  Fault match(std::vector<Index>& twin) const {
    const Index vertices = polygons_.vertex_count();
    std::vector<Index> first = filled(vertices, kNone), owner = filled(vertices, kNone);
    twin.assign(origin_.size(), kNone);
    for (Index v = 0; v < vertices; ++v) {
      for (Index slot = bucket_begin_[v]; slot < bucket_begin_[v + 1]; ++slot) {
        const Index h = bucket_[slot], w = std::max(origin_[h], target_[h]);
        if (owner[w] != v) {
          owner[w] = v;
          first[w] = h;
        } else if (const Index g = first[w]; twin[g] == kNone) {
          twin[h] = g;
          twin[g] = h;
        } else {
          return not_manifold(v, w);
        }
      }
    }
    for (Index h = 0; h < static_cast<Index>(twin.size()); ++h)
      if (twin[h] != kNone && origin_[h] == origin_[twin[h]]) return flipped(h, twin[h]);
    return {};
  }

 private:
  // half-edges sorted by the smaller end of their edge, by counting; within a bucket the larger
  // end picks a slot of an array, so no search, sort or hash map is needed
  void fill_buckets() {
    bucket_begin_ = filled(polygons_.vertex_count() + 1, 0);
    bucket_.resize(origin_.size());
    const Index count = static_cast<Index>(origin_.size());
    for (Index h = 0; h < count; ++h) ++bucket_begin_[lower(h)];
    Index sum = 0;
    for (Index& begin : bucket_begin_) begin = sum += begin;
    for (Index h = count; h-- > 0;) bucket_[--bucket_begin_[lower(h)]] = h;
  }

  [[nodiscard]] Index lower(Index h) const { return std::min(origin_[h], target_[h]); }

  [[nodiscard]] Index face(Index h) const {  // for messages only
    const auto& begin = polygons_.face_begin;
    return static_cast<Index>(std::upper_bound(begin.begin(), begin.end(), h) - begin.begin()) - 1;
  }

  [[nodiscard]] Error not_manifold(Index v, Index w) const {
    std::vector<Index> faces;
    for (Index slot = bucket_begin_[v]; slot < bucket_begin_[v + 1]; ++slot) {
      const Index h = bucket_[slot];
      if (std::max(origin_[h], target_[h]) == w) faces.push_back(face(h));
    }
    return fault("the edge between vertices " + number(v) + " and " + number(w) + " lies in " +
                     number(faces.size()) + " faces (" + list(faces) +
                     "), but on a surface it lies in at most 2",
                 "remove the extra faces, or give each sheet its own copies of the two vertices; "
                 "vertices and faces count from 0 here");
  }

  [[nodiscard]] Error flipped(Index h, Index g) const {
    return fault("faces " + number(face(h)) + " and " + number(face(g)) + " both run from vertex " +
                     number(origin_[h]) + " to vertex " + number(target_[h]) +
                     ": one of them is flipped",
                 "reverse the corners of one of the two (and of its side of the mesh); a "
                 "one-sided surface must be cut open; vertices and faces count from 0 here");
  }

  const Polygons& polygons_;
  const std::vector<Index>& origin_;
  std::vector<Index> target_;
  std::vector<Index> bucket_begin_, bucket_;
};

// edges numbered by their lower half-edge
Index number_edges(const std::vector<Index>& twin, std::vector<Index>& edge) {
  Index count = 0;
  edge.resize(twin.size());
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h)
    edge[h] = twin[h] == kNone || twin[h] > h ? count++ : edge[twin[h]];
  return count;
}

// the faces that one turn about v from its half-edge meets
std::vector<Index> fan(const Mesh& mesh, Index v) {
  std::vector<Index> faces;
  Index h = mesh.halfedge_of_vertex(v);
  do {
    faces.push_back(mesh.face(h));
    h = mesh.rotate(h);
  } while (h != kNone && h != mesh.halfedge_of_vertex(v));
  return faces;
}

Error bow_tie(const Mesh& mesh, Index v) {
  std::vector<Index> one = fan(mesh, v), other;
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    if (mesh.origin(h) == v && std::find(one.begin(), one.end(), mesh.face(h)) == one.end())
      other.push_back(mesh.face(h));
  return fault("the faces round vertex " + number(v) + " form more than one fan (faces " +
                   list(one) + " apart from " + list(other) + "): the surface only touches " +
                   "itself there",
               "give each fan its own copy of the vertex; vertices and faces count from 0 here");
}

Fault check_fans(const Mesh& mesh) {
  std::vector<Index> corners = filled(mesh.vertex_count(), 0);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) ++corners[mesh.origin(h)];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_isolated(v)) continue;
    const Index fan_size = mesh.valence(v) - (mesh.is_boundary_vertex(v) ? 1 : 0);
    if (fan_size != corners[v]) return bow_tie(mesh, v);
  }
  return {};
}

void warn_of_isolated(const Mesh& mesh, Warnings& warnings) {
  std::vector<Index> isolated;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) isolated.push_back(v);
  if (isolated.empty()) return;
  const bool one = isolated.size() == 1;
  warnings.push_back(
      fault(one ? "vertex " + list(isolated) + " belongs to no face"
                : number(isolated.size()) + " vertices belong to no face (" + list(isolated) + ")",
            one ? "it is kept and stays where it is; vertices count from 0 here"
                : "they are kept and stay where they are; vertices count from 0 "
                  "here"));
}

}  // namespace

Result<Mesh> Mesh::build(const Polygons& polygons, Warnings* warnings) {
  if (Fault bad = check_faces(polygons)) return *std::move(bad);
  Arrays arrays;
  if (Fault bad = TwinMatcher(polygons).match(arrays.twin)) return *std::move(bad);
  arrays.vertex_count = polygons.vertex_count();
  arrays.edge_count = number_edges(arrays.twin, arrays.edge);
  arrays.face_begin = polygons.face_begin;
  arrays.origin = polygons.corners;
  Mesh mesh = from_arrays(std::move(arrays));
  if (Fault bad = check_fans(mesh)) return *std::move(bad);
  if (warnings != nullptr) warn_of_isolated(mesh, *warnings);
  return mesh;
}

}  // namespace limn
