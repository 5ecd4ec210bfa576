// Mesh::build: polygons to half-edges, or the reason why they are no oriented 2-manifold.

#include <algorithm>
#include <optional>

#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/mesh_limits.h"

namespace limn {
namespace {

std::vector<Index> filled(Index count, Index value) {
  return base::large_vector<Index>(static_cast<std::size_t>(count), value);
}

// Whether the faces are in order one by one: enough corners, each a vertex, none twice. Here and
// below a fault is only noticed; `find_mesh_faults` finds all of them.
bool faces_are_sound(const Polygons& polygons) {
  const auto& begin = polygons.face_begin;
  if (begin.empty() || begin.front() != 0 ||
      static_cast<std::size_t>(begin.back()) != polygons.corners.size())
    return false;
  for (Index f = 0; f < polygons.face_count(); ++f)
    if (begin[f + 1] < begin[f] || polygons.degree(f) < 3) return false;
  std::vector<Index> seen_by = filled(polygons.vertex_count(), kNone);
  for (Index f = 0; f < polygons.face_count(); ++f) {
    for (Index c = begin[f]; c < begin[f + 1]; ++c) {
      const Index v = polygons.corners[c];
      if (v < 0 || v >= polygons.vertex_count() || seen_by[v] == f) return false;
      seen_by[v] = f;
    }
  }
  return true;
}

class TwinMatcher {
 public:
  explicit TwinMatcher(const Polygons& polygons)
      : polygons_(polygons), origin_(polygons.corners), target_(origin_.size()) {
    base::parallel_for_each(polygons.face_count(), [&](Index f) {
      const Index first = polygons.face_begin[f], last = polygons.face_begin[f + 1];
      for (Index h = first; h < last; ++h) target_[h] = origin_[h + 1 < last ? h + 1 : first];
    });
    fill_buckets();
  }

  /// Twins of all half-edges; false where two faces do not fit.
  bool match(std::vector<Index>& twin) const {
    const Index vertices = polygons_.vertex_count();
    std::vector<Index> first = filled(vertices, kNone), owner = filled(vertices, kNone);
    twin = base::large_vector<Index>(origin_.size(), kNone);
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
          return false;  // in three faces
        }
      }
    }
    for (Index h = 0; h < static_cast<Index>(twin.size()); ++h)
      if (twin[h] != kNone && origin_[h] == origin_[twin[h]]) return false;  // flipped
    return true;
  }

 private:
  // half-edges sorted by the smaller end of their edge, by counting; within a bucket the larger
  // end picks a slot of an array, so no search, sort or hash map is needed
  void fill_buckets() {
    bucket_begin_ = filled(polygons_.vertex_count() + 1, 0);
    bucket_ = base::large_vector<Index>(origin_.size());
    const Index count = static_cast<Index>(origin_.size());
    for (Index h = 0; h < count; ++h) ++bucket_begin_[lower(h)];
    Index sum = 0;
    for (Index& begin : bucket_begin_) begin = sum += begin;
    for (Index h = count; h-- > 0;) bucket_[--bucket_begin_[lower(h)]] = h;
  }

  [[nodiscard]] Index lower(Index h) const { return std::min(origin_[h], target_[h]); }

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

// Whether the faces of each vertex are one fan.
bool fans_are_whole(const Mesh& mesh) {
  std::vector<Index> corners = filled(mesh.vertex_count(), 0);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) ++corners[mesh.origin(h)];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_isolated(v)) continue;
    const Index fan_size = mesh.valence(v) - (mesh.is_boundary_vertex(v) ? 1 : 0);
    if (fan_size != corners[v]) return false;
  }
  return true;
}

// "0, 2 and 5"; long lists are cut
std::string list(const std::vector<Index>& items, Index first_number) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t i = 0; i < items.size() && i < kMost; ++i) {
    if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
    text += std::to_string(items[i] + first_number);
  }
  return items.size() > kMost ? text + ", …" : text;
}

void warn_of_isolated(const Mesh& mesh, const MeshSource& source, Warnings& warnings) {
  std::vector<Index> isolated;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) isolated.push_back(source.file_vertex(v));
  if (isolated.empty()) return;
  const bool one = isolated.size() == 1;
  Error warning;
  warning.file = source.file;
  const auto first = static_cast<std::size_t>(isolated.front());
  if (first < source.vertex_lines.size()) warning.line = source.vertex_lines[first];
  const std::string vertices = list(isolated, source.first);
  warning.message =
      one ? "vertex " + vertices + " belongs to no face"
          : std::to_string(isolated.size()) + " vertices belong to no face (" + vertices + ")";
  warning.hint = one ? "it is kept and stays where it is" : "they are kept and stay where they are";
  warning.hint += "; vertices count from " + std::to_string(source.first) +
                  (source.file.empty() ? " here" : ", as in the file");
  warnings.push_back(std::move(warning));
}

// The connectivity, where no fault is noticed.
std::optional<Mesh> build_sound(const Polygons& polygons) {
  if (!faces_are_sound(polygons)) return std::nullopt;
  Mesh::Arrays arrays;
  if (!TwinMatcher(polygons).match(arrays.twin)) return std::nullopt;
  arrays.vertex_count = polygons.vertex_count();
  arrays.edge_count = number_edges(arrays.twin, arrays.edge);
  arrays.face_begin = polygons.face_begin;
  arrays.origin = polygons.corners;
  Mesh mesh = Mesh::from_arrays(std::move(arrays));
  if (!fans_are_whole(mesh)) return std::nullopt;
  return mesh;
}

}  // namespace

Result<Mesh> mesh::build_mesh(const Polygons& polygons, const MeshSource& source,
                              Warnings* warnings) {
  if (std::optional<Error> fault = mesh::too_many(
          polygons.positions.size(), polygons.face_begin.size(), polygons.corners.size())) {
    fault->file = source.file;
    return *std::move(fault);
  }
  std::optional<Mesh> mesh = build_sound(polygons);
  if (!mesh) return mesh::error_of(mesh::find_mesh_faults(polygons), polygons, source);
  if (warnings != nullptr) warn_of_isolated(*mesh, source, *warnings);
  return *std::move(mesh);
}

Result<Mesh> Mesh::build(const Polygons& polygons, Warnings* warnings) {
  return mesh::build_mesh(polygons, {}, warnings);
}

}  // namespace limn
