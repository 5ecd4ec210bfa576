#include "limn/mesh/sharpness/cuts.h"

#include <algorithm>

#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/edges_between.h"
#include "limn/mesh/sharpness/resting_with.h"

namespace limn::mesh {
namespace {

void make_sharp(std::vector<double>& values, Index i, Index count, double sharpness) {
  values.resize(at(count), 0);
  values[at(i)] = std::max(values[at(i)], sharpness);
}

/// Sharp edges that end at copies of cut vertices, but for those that repair made sharp.
class EndsAtCuts {
 public:
  EndsAtCuts(const Mesh& mesh, const Cuts& cuts, Sharpness& sharpness, std::vector<bool> held)
      : mesh_(mesh), cuts_(cuts), sharpness_(sharpness), held_(std::move(held)) {
    std::vector<Index> copies(at(cuts.vertices), 0);
    for (const Index v : cuts.vertex_of) ++copies[at(v)];
    for (Index v = 0; v < static_cast<Index>(cuts.vertex_of.size()); ++v)
      if (copies[at(cuts.vertex_of[at(v)])] > 1) copies_.push_back(v);
  }

  /// Copies rest with the edges that end at others.
  void hold() {
    for (Index e = 0; e < static_cast<Index>(sharpness_.edges.size()); ++e) {
      if (mesh_.is_boundary_edge(e) || held_[at(e)] || sharpness_.edges[at(e)] <= 0) continue;
      const Index h = mesh_.halfedge_of_edge(e);
      for (const Index v : {mesh_.origin(h), mesh_.target(h)})
        if (std::binary_search(copies_.begin(), copies_.end(), v))
          ends_.push_back({cuts_.vertex_of[at(v)], v, sharpness_.edges[at(e)]});
    }
    if (ends_.empty()) return;
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) { return a.cut < b.cut; });
    for (const Index v : copies_) hold(v);
  }

 private:
  struct End {
    Index cut, copy;
    double sharpness;
  };

  void hold(Index v) {
    const auto [first, last] =
        std::equal_range(ends_.begin(), ends_.end(), End{cuts_.vertex_of[at(v)], v, 0},
                         [](const End& a, const End& b) { return a.cut < b.cut; });
    if (std::none_of(first, last, [&](const End& end) { return end.copy != v; })) return;
    std::vector<double> edges;
    for (auto end = first; end != last; ++end) edges.push_back(end->sharpness);
    make_sharp(sharpness_.vertices, v, mesh_.vertex_count(), resting_with(edges));
  }

  const Mesh& mesh_;
  const Cuts& cuts_;
  Sharpness& sharpness_;
  std::vector<bool> held_;     // of each edge
  std::vector<Index> copies_;  // of cut vertices, in order
  std::vector<End> ends_;
};

}  // namespace

Cuts cuts_of(const Repaired& repaired) {
  std::vector<Index> originals = repaired.vertex_of;
  std::sort(originals.begin(), originals.end());
  if (std::adjacent_find(originals.begin(), originals.end()) == originals.end()) return {};
  return {static_cast<Index>(repaired.joined_with.size()), repaired.vertex_of,
          repaired.sharp_vertices, repaired.sharp_edges};
}

void hold_cuts(const Mesh& mesh, const Cuts& cuts, Sharpness& sharpness) {
  if (cuts.empty()) return;
  std::vector<bool> held(at(mesh.edge_count()), false);
  for (const auto& [a, b] : cuts.sharp_edges)
    for (const Index e : edges_between(mesh, a, b)) {
      make_sharp(sharpness.edges, e, mesh.edge_count(), kInfinitelySharp);
      held[at(e)] = true;
    }
  EndsAtCuts(mesh, cuts, sharpness, std::move(held)).hold();
  for (const Index v : cuts.sharp_vertices)
    make_sharp(sharpness.vertices, v, mesh.vertex_count(), kInfinitelySharp);
}

}  // namespace limn::mesh
