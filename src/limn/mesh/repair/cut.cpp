// Sheets that meet are taken apart: copies of vertices, so that the corners of each fan have their
// own.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "limn/mesh/edge_sides.h"
#include "limn/mesh/joined_sets.h"
#include "limn/mesh/repair/steps.h"

namespace limn::mesh::detail {
namespace {

class SheetCutter {
 public:
  /// `apart`: edges of two faces that are cut, too.
  SheetCutter(RepairWork& work, const std::vector<char>& out,
              const std::unordered_set<std::uint64_t>& apart)
      : work_(work),
        mesh_(work.polygons),
        out_(out),
        sides_(sorted_sides(mesh_, out)),
        fans_(static_cast<Index>(mesh_.corners.size())),
        edges_(mesh_.positions.size(), 0),
        cut_(edges_),
        open_(edges_),
        faces_(edges_) {
    for_each_edge(sides_, [&](std::size_t k, std::size_t last) {
      const std::uint64_t edge = sides_[k].edge;
      const bool is_cut = last - k > 2 || apart.count(edge) > 0;
      if (last - k == 2 && !is_cut) join_fans(mesh_, sides_[k], sides_[k + 1], fans_);
      if (last - k > 2) crowded_.push_back(edge);
      for (const Index v : {low_end(edge), high_end(edge)}) {
        ++edges_[v];
        cut_[v] += is_cut ? 1 : 0;
        open_[v] += last - k == 1 ? 1 : 0;
      }
    });
    for_each_corner([&](Index c) { ++faces_[mesh_.corners[c]]; });
  }

  /// Of vertices that were in several fans; the number of copies. In the order of their vertices,
  /// and of the first faces of the fans: it does not matter where a face begins or which way it
  /// runs.
  Index give_copies() {
    std::vector<Index> first(mesh_.positions.size(), kNone);  // fan that keeps the vertex
    std::vector<Index> copy_of(mesh_.corners.size(), kNone);  // of each other fan
    std::vector<std::pair<Index, Index>> others;              // vertices, and their other fans
    for_each_corner([&](Index c) {
      const Index v = mesh_.corners[c], fan = fans_.root(c);
      if (first[v] == kNone) first[v] = fan;
      if (first[v] == fan || copy_of[fan] != kNone) return;
      copy_of[fan] = 0;
      others.emplace_back(v, fan);
    });
    std::stable_sort(others.begin(), others.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [v, fan] : others) {
      copy_of[fan] = mesh_.vertex_count();
      mesh_.positions.push_back(Point3(mesh_.positions[v]));
      work_.vertex_of.push_back(Index(work_.vertex_of[v]));
      original_.push_back(v);
    }
    for_each_corner([&](Index c) {
      if (const Index copy = copy_of[fans_.root(c)]; copy != kNone) mesh_.corners[c] = copy;
    });
    return static_cast<Index>(others.size());
  }

  /// After `give_copies`: what OpenSubdiv holds sharp where sheets met.
  void note_sharp() {
    const auto cut_vertices = static_cast<Index>(edges_.size());
    std::vector<char> sharp(edges_.size(), 0);
    for (const Index v : original_) sharp[v] = 1;
    for (Index v = 0; v < cut_vertices; ++v) {
      if (cut_[v] > 0) sharp[v] = 1;
      if (cut_[v] == 2 && open_[v] == 0 && faces_[v] > edges_[v]) sharp[v] = 0;
    }
    for (const Index v : work_.sharp_vertices) sharp[v] = 1;
    work_.sharp_vertices.clear();
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (sharp[v < cut_vertices ? v : original_[v - cut_vertices]] != 0)
        work_.sharp_vertices.push_back(v);
    if (crowded_.empty()) return;
    const auto original = [&](Index v) {
      return v < cut_vertices ? v : original_[v - cut_vertices];
    };
    sides_ = sorted_sides(mesh_, out_);
    for_each_edge(sides_, [&](std::size_t k, std::size_t last) {
      const Index v = low_end(sides_[k].edge), w = high_end(sides_[k].edge);
      if (last - k == 2 && std::binary_search(crowded_.begin(), crowded_.end(),
                                              edge_between(original(v), original(w))))
        work_.sharp_edges.push_back({v, w});
    });
  }

  [[nodiscard]] Index crowded_edges() const { return static_cast<Index>(crowded_.size()); }
  /// How many vertices the copies are of.
  [[nodiscard]] Index cut_vertices() const {
    std::vector<Index> vertices = original_;
    std::sort(vertices.begin(), vertices.end());
    return static_cast<Index>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  }

 private:
  template <class Use>
  void for_each_corner(const Use& use) const {
    for (Index f = 0; f < mesh_.face_count(); ++f)
      for (Index c = mesh_.face_begin[f]; out_[f] == 0 && c < mesh_.face_begin[f + 1]; ++c) use(c);
  }

  RepairWork& work_;
  Polygons& mesh_;
  const std::vector<char>& out_;
  std::vector<EdgeSide> sides_;
  JoinedSets fans_;
  std::vector<Index> edges_, cut_, open_, faces_;  // of each vertex; open_: edges of one face
  std::vector<std::uint64_t> crowded_;             // in order
  std::vector<Index> original_;                    // of each copy
};

}  // namespace

void cut_sheets(RepairWork& work) {
  const std::vector<char> out =
      faulty_faces(find_mesh_faults(work.polygons), work.polygons.face_count(), false);
  SheetCutter cutter(work, out, {});
  cutter.give_copies();
  cutter.note_sharp();
  note(work, "edges_cut", cutter.crowded_edges(), "edge of more than two faces",
       "edges of more than two faces", " cut");
  note(work, "vertices_cut", cutter.cut_vertices(), "vertex", "vertices",
       " where sheets meet given copies, one for each sheet");
}

void cut_one_sided(RepairWork& work) {
  const MeshFaults faults = find_mesh_faults(work.polygons);
  std::unordered_set<std::uint64_t> apart;
  for (const MeshFault& fault : faults.list)
    if (fault.kind == MeshFault::Kind::flipped_edge && fault.one_sided)
      apart.insert(edge_between(fault.vertices[0], fault.vertices[1]));
  if (apart.empty()) return;
  const std::vector<char> out = faulty_faces(faults, work.polygons.face_count(), false);
  SheetCutter cutter(work, out, apart);
  const Index copies = cutter.give_copies();
  cutter.note_sharp();
  note(work, "one_sided_edges_cut", static_cast<Index>(apart.size()), "edge", "edges",
       " of one-sided surfaces cut open, with " + std::to_string(copies) + " copies of vertices");
}

}  // namespace limn::mesh::detail
