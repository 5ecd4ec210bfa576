#include "limn/limit/mesh_part.h"

#include <numeric>
#include <utility>

#include "limn/mesh/index.h"

namespace limn::limit {
namespace {

using mesh::at;

}  // namespace

MeshPart PartCutter::run(const std::vector<Index>& centres, int rings) {
  find_faces(centres, rings);
  arrays_.face_begin.push_back(0);
  for (const Index f : faces_) {
    first_[f] = arrays_.face_begin.back();
    arrays_.face_begin.push_back(arrays_.face_begin.back() + mesh_.degree(f));
  }
  vertex_.assign(at(arrays_.face_begin.back()), kNone);
  for (const Index centre : centres) name_fan(mesh_.halfedge_of_vertex(centre));
  for (const Index f : faces_)
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) add(h);
  part_.mesh = Mesh::from_arrays(std::move(arrays_));
  part_.sharpness.method = sharpness_.method;
  return std::move(part_);
}

void PartCutter::find_faces(const std::vector<Index>& centres, int rings) {
  std::vector<Index> reached = centres, next;
  std::unordered_map<Index, bool> seen;
  for (const Index centre : centres) seen.emplace(centre, true);
  for (int ring = 0; ring < rings; ++ring) {
    for (const Index v : reached) visit_fan(v, seen, next);
    reached = std::exchange(next, {});
  }
}

void PartCutter::visit_fan(Index v, std::unordered_map<Index, bool>& seen,
                           std::vector<Index>& next) {
  const Index first = mesh_.halfedge_of_vertex(v);
  Index h = first;
  do {
    const Index f = mesh_.face(h);
    if (first_.try_emplace(f, kNone).second) {
      faces_.push_back(f);
      for (Index g = mesh_.face_begin(f); g < mesh_.face_begin(f + 1); ++g)
        if (seen.try_emplace(mesh_.origin(g), true).second) next.push_back(mesh_.origin(g));
    }
    h = mesh_.rotate(h);
  } while (h != kNone && h != first);
}

/// The other side, where that is in the part.
Index PartCutter::twin(Index h) const {
  const Index t = mesh_.twin(h);
  return t != kNone && first_.count(mesh_.face(t)) != 0 ? t : kNone;
}

/// A vertex for all corners of the fan that h is in.
void PartCutter::name_fan(Index h) {
  const Index v = mesh_.origin(h), name = arrays_.vertex_count++;
  part_.values.push_back(values_[at(v)]);
  if (!sharpness_.vertices.empty()) part_.sharpness.vertices.push_back(sharpness_.vertices[at(v)]);
  const Index start = h;
  do {  // counterclockwise, and clockwise from the beginning where that ends
    vertex_[at(number(h))] = name;
    h = twin(mesh_.prev(h));
  } while (h != kNone && h != start);
  if (h != kNone) return;
  for (Index t = twin(start); t != kNone; t = twin(h)) {
    h = mesh_.next(t);
    vertex_[at(number(h))] = name;
  }
}

void PartCutter::add(Index h) {
  if (vertex_[at(number(h))] == kNone) name_fan(h);
  arrays_.origin.push_back(vertex_[at(number(h))]);
  const Index t = twin(h);
  arrays_.twin.push_back(t == kNone ? kNone : number(t));
  const bool second = t != kNone && number(t) < number(h);
  arrays_.edge.push_back(second ? arrays_.edge[at(number(t))] : arrays_.edge_count++);
  if (!second && !sharpness_.edges.empty())
    part_.sharpness.edges.push_back(sharpness_.edges[at(mesh_.edge(h))]);
}

MeshPart cut_out(const MeshPart& part, Index centres, int rings) {
  std::vector<Index> all(at(centres));
  std::iota(all.begin(), all.end(), 0);
  return PartCutter(part.mesh, part.values, part.sharpness).run(all, rings);
}

}  // namespace limn::limit
