#pragma once
/// Values at the vertices of a mesh, and sums of them that references of several schemes need.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::test {

class OldValues {
 protected:
  OldValues(const Mesh& mesh, const std::vector<double>& old) : mesh_(mesh), old_(old) {}

  [[nodiscard]] double at(Index v) const { return old_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] Index apex(Index h) const { return mesh_.target(mesh_.next(h)); }

  [[nodiscard]] double mean(Index f) const {
    double sum = 0;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      sum += at(mesh_.origin(h));
    return sum / mesh_.degree(f);
  }

  /// Sum over the edges at an interior vertex v of the value at their other ends.
  [[nodiscard]] double neighbours(Index v) const {
    double sum = 0;
    const Index first = mesh_.halfedge_of_vertex(v);
    Index h = first;
    do {
      sum += at(mesh_.target(h));
      h = mesh_.rotate(h);
    } while (h != first);
    return sum;
  }

  /// The other boundary edge's far end, where boundary half-edge h meets its origin or target.
  [[nodiscard]] Index beyond(Index h, bool at_target) const {
    if (at_target) {
      Index out = mesh_.next(h);
      while (mesh_.twin(out) != kNone) out = mesh_.next(mesh_.twin(out));
      return mesh_.target(out);
    }
    Index in = mesh_.prev(h);
    while (mesh_.twin(in) != kNone) in = mesh_.prev(mesh_.twin(in));
    return mesh_.origin(in);
  }

  [[nodiscard]] double boundary_neighbours(Index v) const {
    const Index out = mesh_.halfedge_of_vertex(v);
    return at(mesh_.target(out)) + at(beyond(out, false));
  }

  /// The third vertex of the triangle beyond side h; past the boundary the parallelogram's corner.
  [[nodiscard]] double across(Index h) const {
    const Index out = mesh_.twin(h);
    return out != kNone ? at(apex(out)) : at(mesh_.origin(h)) + at(mesh_.target(h)) - at(apex(h));
  }

  /// The vertex three faces on, turning round h's target on h's left: straight beyond it if the
  /// target is regular. Where the mesh ends before: the edge prolonged.
  [[nodiscard]] double straight_on_left(Index h) const {
    Index spoke = mesh_.next(h);  // out of the target; faces crossed: one
    for (int i = 0; i < 2; ++i) {
      if (mesh_.twin(spoke) == kNone) return 2 * at(mesh_.target(h)) - at(mesh_.origin(h));
      spoke = mesh_.next(mesh_.twin(spoke));
    }
    return at(mesh_.target(spoke));
  }

  [[nodiscard]] double straight_on_right(Index h) const {
    Index spoke = mesh_.prev(mesh_.twin(h));  // into the target
    for (int i = 0; i < 2; ++i) {
      if (mesh_.twin(spoke) == kNone) return 2 * at(mesh_.target(h)) - at(mesh_.origin(h));
      spoke = mesh_.prev(mesh_.twin(spoke));
    }
    return at(mesh_.origin(spoke));
  }

  const Mesh& mesh_;
  const std::vector<double>& old_;
};

}  // namespace limn::test
