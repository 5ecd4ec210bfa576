#include "limn/mesh/pattern.h"

namespace limn::mesh {

Pattern::Pattern(const Mesh& shape, Index inner) : shape_(shape), inner_(inner) {
  std::vector<bool> met(static_cast<std::size_t>(shape.halfedge_count()), false);
  std::vector<Index> queue{0};
  met[0] = true;
  const auto meet = [&](Index h, Index from, bool across) {
    if (h == kNone || met[h]) return;
    met[h] = true;
    queue.push_back(h);
    steps_.push_back({h, from, across});
  };
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index h = queue[i];
    meet(shape.next(h), h, false);
    meet(shape.twin(h), h, true);
  }
}

bool Pattern::place(const Mesh& mesh, Index start, std::vector<Index>& partner) const {
  partner[0] = start;
  for (const Step& step : steps_) {
    const Index from = partner[step.from];
    const Index to = step.across ? mesh.twin(from) : mesh.next(from);
    if (to == kNone) return false;
    partner[step.halfedge] = to;
  }
  for (Index h = 0; h < shape_.halfedge_count(); ++h) {
    if (mesh.next(partner[h]) != partner[shape_.next(h)]) return false;
    const Index twin = shape_.twin(h);
    const bool inside = shape_.origin(h) < inner_ || shape_.target(h) < inner_;
    if (twin != kNone ? mesh.twin(partner[h]) != partner[twin]
                      : inside && mesh.twin(partner[h]) != kNone)
      return false;
  }
  return true;
}

bool Pattern::match(const Mesh& mesh, Index start, std::vector<Index>& vertices) const {
  std::vector<Index> partner(static_cast<std::size_t>(shape_.halfedge_count()));
  if (!place(mesh, start, partner)) return false;
  vertices.resize(static_cast<std::size_t>(shape_.vertex_count()));
  for (Index h = 0; h < shape_.halfedge_count(); ++h)
    vertices[shape_.origin(h)] = mesh.origin(partner[h]);
  // the pattern may wind more than once round a vertex of the mesh
  for (Index v = 0; v < inner_; ++v)
    if (mesh.valence(vertices[v]) != shape_.valence(v)) return false;
  return true;
}

}  // namespace limn::mesh
