#include "limn/mesh/mesh_faults.h"

#include <algorithm>

#include "limn/base/interrupt.h"
#include "limn/mesh/edge_sides.h"
#include "limn/mesh/joined_sets.h"

namespace limn::mesh {
namespace {

using Kind = MeshFault::Kind;
using detail::EdgeSide;
using detail::for_each_edge;
using detail::high_end;
using detail::is_flipped;
using detail::join_fans;
using detail::low_end;
using detail::next_corner;
using detail::sorted_sides;

bool has_offsets(const Polygons& polygons) {
  const auto& begin = polygons.face_begin;
  return !begin.empty() && begin.front() == 0 &&
         static_cast<std::size_t>(begin.back()) == polygons.corners.size() &&
         std::is_sorted(begin.begin(), begin.end());
}

class FaultFinder {
 public:
  explicit FaultFinder(const Polygons& polygons)
      : polygons_(polygons),
        begin_(polygons.face_begin),
        out_(static_cast<std::size_t>(polygons.face_count()), 0),
        unclear_(static_cast<std::size_t>(polygons.vertex_count()), 0),
        sides_(polygons.face_count()),
        fans_(static_cast<Index>(polygons.corners.size())) {}

  MeshFaults find() {
    check_faces();
    base::check_interrupt();
    find_copies();
    base::check_interrupt();
    find_edges();
    base::check_interrupt();
    check_fans();
    std::stable_sort(faults_.list.begin(), faults_.list.end(),
                     [](const MeshFault& a, const MeshFault& b) { return a.kind < b.kind; });
    return std::move(faults_);
  }

 private:
  MeshFault& add(Kind kind, std::vector<Index> faces, Index v = kNone, Index w = kNone) {
    MeshFault fault;
    fault.kind = kind;
    fault.faces = std::move(faces);
    fault.vertices = {v, w};
    faults_.list.push_back(std::move(fault));
    return faults_.list.back();
  }

  [[nodiscard]] Index next(Index f, Index c) const {
    return mesh::detail::next_corner(polygons_, f, c);
  }
  [[nodiscard]] Index vertex(Index corner) const { return polygons_.corners[corner]; }

  void check_faces() {
    std::vector<Index> seen_by(static_cast<std::size_t>(polygons_.vertex_count()), kNone);
    for (Index f = 0; f < polygons_.face_count(); ++f) {
      const std::size_t before = faults_.list.size();
      if (polygons_.degree(f) < 3) add(Kind::few_corners, {f});
      for (Index c = begin_[f]; c < begin_[f + 1]; ++c) {
        const Index v = vertex(c);
        if (v < 0 || v >= polygons_.vertex_count()) {
          add(Kind::out_of_range, {f}, v).corner = c - begin_[f];
        } else if (seen_by[v] == f) {
          add(Kind::repeated_corner, {f}, v);
        } else {
          seen_by[v] = f;
        }
      }
      if (faults_.list.size() > before) leave_out(f);
    }
  }

  /// A face with a fault of its own.
  void leave_out(Index f) {
    out_[f] = 1;
    for (Index c = begin_[f]; c < begin_[f + 1]; ++c)
      if (vertex(c) >= 0 && vertex(c) < polygons_.vertex_count()) unclear_[vertex(c)] = 1;
  }

  /// Corner i of a face counted from its smallest, forwards or in the direction of the smaller
  /// neighbour: equal for faces with the same corners in the same order, or the opposite.
  struct Walk {
    Index face, start;
    bool forward;
  };
  [[nodiscard]] Walk walk(Index f) const {
    Index start = begin_[f];
    for (Index c = begin_[f]; c < begin_[f + 1]; ++c)
      if (vertex(c) < vertex(start)) start = c;
    const Index before = start == begin_[f] ? begin_[f + 1] - 1 : start - 1;
    return {f, start, vertex(next(f, start)) < vertex(before)};
  }
  [[nodiscard]] Index along(const Walk& w, Index i) const {
    const Index degree = polygons_.degree(w.face), first = begin_[w.face];
    const Index at = w.start - first;
    return vertex(first + (w.forward ? (i < degree - at ? at + i : at + i - degree)
                                     : (i <= at ? at - i : at - i + degree)));
  }
  [[nodiscard]] int compare(const Walk& a, const Walk& b) const {
    const Index degree = polygons_.degree(a.face);
    if (degree != polygons_.degree(b.face)) return degree < polygons_.degree(b.face) ? -1 : 1;
    for (Index i = 0; i < degree; ++i) {
      const Index v = along(a, i), w = along(b, i);
      if (v != w) return v < w ? -1 : 1;
    }
    return 0;
  }

  void find_copies() {
    std::vector<Walk> walks;
    for (Index f = 0; f < polygons_.face_count(); ++f)
      if (out_[f] == 0) walks.push_back(walk(f));
    std::sort(walks.begin(), walks.end(), [this](const Walk& a, const Walk& b) {
      const int order = compare(a, b);
      return order != 0 ? order < 0 : a.face < b.face;
    });
    std::vector<MeshFault> copies;
    for (std::size_t k = 0, last = 0; k < walks.size(); k = last) {
      const Walk* other = nullptr;  // the first in the opposite order
      for (last = k + 1; last < walks.size() && compare(walks[k], walks[last]) == 0; ++last) {
        const bool same = walks[last].forward == walks[k].forward;
        if (same || other != nullptr)
          add_copy(copies, same ? walks[k].face : other->face, walks[last].face);
        else
          other = &walks[last];
      }
      if (other != nullptr) turned_over_.push_back({walks[k].face, other->face});
    }
    std::sort(copies.begin(), copies.end(),
              [](const MeshFault& a, const MeshFault& b) { return a.faces[1] < b.faces[1]; });
    std::move(copies.begin(), copies.end(), std::back_inserter(faults_.list));
  }

  void add_copy(std::vector<MeshFault>& copies, Index first, Index copy) {
    MeshFault fault;
    fault.kind = Kind::repeated_face;
    fault.faces = {first, copy};
    copies.push_back(std::move(fault));
    out_[copy] = 1;
  }

  void find_edges() {
    std::vector<mesh::detail::EdgeSide> sides = mesh::detail::sorted_sides(polygons_, out_);
    if (drop_crowding_copies(sides)) sides = mesh::detail::sorted_sides(polygons_, out_);
    mesh::detail::for_each_edge(sides, [&](std::size_t k, std::size_t last) {
      if (last - k == 2) return join(sides[k], sides[k + 1]);
      if (last - k < 3) return;
      std::vector<Index> faces;
      for (std::size_t i = k; i < last; ++i) faces.push_back(sides[i].face);
      const Index v = mesh::detail::low_end(sides[k].edge),
                  w = mesh::detail::high_end(sides[k].edge);
      unclear_[v] = unclear_[w] = 1;
      add(Kind::crowded_edge, std::move(faces), v, w);
    });
    orient();
  }

  /// A face and the same one turned over are a closed surface by themselves; on a larger one the
  /// later is a copy.
  bool drop_crowding_copies(const std::vector<mesh::detail::EdgeSide>& sides) {
    if (turned_over_.empty()) return false;
    std::vector<char> crowded(out_.size(), 0);
    mesh::detail::for_each_edge(sides, [&](std::size_t k, std::size_t last) {
      for (std::size_t i = k; last - k > 2 && i < last; ++i) crowded[sides[i].face] = 1;
    });
    bool dropped = false;
    for (const auto& [first, copy] : turned_over_) {
      if (crowded[copy] == 0) continue;
      MeshFault& fault = add(Kind::repeated_face, {first, copy});
      fault.turned_over = true;
      out_[copy] = 1;
      dropped = true;
    }
    return dropped;
  }

  /// The two faces of an edge: which way they run, and that their corners at its ends are of one
  /// fan each.
  void join(const mesh::detail::EdgeSide& a, const mesh::detail::EdgeSide& b) {
    const bool flipped = mesh::detail::is_flipped(polygons_, a, b);
    if (flipped)
      add(Kind::flipped_edge, {a.face, b.face}, vertex(a.corner), vertex(next(a.face, a.corner)));
    if (!sides_.join(a.face, b.face, flipped)) one_sided_.push_back(a.face);
    mesh::detail::join_fans(polygons_, a, b, fans_);
  }

  /// Which flipped edges are of one-sided surfaces, and which faces to reverse on the others: on
  /// each those of the side that has fewer.
  void orient() {
    const Index count = polygons_.face_count();
    std::vector<char> one_sided(static_cast<std::size_t>(count), 0), concerned(one_sided);
    for (const Index f : one_sided_) one_sided[sides_.root(f)] = 1;
    for (MeshFault& fault : faults_.list) {
      if (fault.kind != Kind::flipped_edge) continue;
      const Index root = sides_.root(fault.faces[0]);
      fault.one_sided = one_sided[root] != 0;
      concerned[root] = fault.one_sided ? 0 : 1;
    }
    std::vector<Index> balance(static_cast<std::size_t>(count), 0);
    for (Index f = 0; f < count; ++f) {
      const Index root = sides_.root(f);
      balance[root] += sides_.parity(f) ? 1 : -1;
    }
    for (Index f = 0; f < count; ++f) {
      const Index root = sides_.root(f);
      if (concerned[root] != 0 && sides_.parity(f) == (balance[root] <= 0))
        faults_.to_reverse.push_back(f);
    }
  }

  void check_fans() {
    // the first fan met at each vertex, and the corners of its others
    std::vector<Index> first(unclear_.size(), kNone);
    std::vector<Index> fault_of(unclear_.size(), kNone);
    std::vector<std::pair<Index, Index>> torn;  // vertex and corner
    for_each_corner([&](Index, Index c) {
      const Index v = vertex(c);
      if (unclear_[v] != 0) return;
      const Index fan = fans_.root(c);
      if (first[v] == kNone) first[v] = fan;
      if (first[v] != fan) fault_of[v] = 0;
    });
    for (Index v = 0; v < polygons_.vertex_count(); ++v) {
      if (fault_of[v] == kNone) continue;
      fault_of[v] = static_cast<Index>(faults_.list.size());
      add(Kind::several_fans, {}, v);
    }
    for_each_corner([&](Index f, Index c) {
      const Index v = vertex(c);
      if (fault_of[v] == kNone) return;
      MeshFault& fault = faults_.list[static_cast<std::size_t>(fault_of[v])];
      (fans_.root(c) == first[v] ? fault.faces : fault.others).push_back(f);
    });
  }

  template <class Use>
  void for_each_corner(const Use& use) const {
    for (Index f = 0; f < polygons_.face_count(); ++f)
      for (Index c = begin_[f]; out_[f] == 0 && c < begin_[f + 1]; ++c) use(f, c);
  }

  const Polygons& polygons_;
  const std::vector<Index>& begin_;
  std::vector<char> out_;      // faces that take no further part
  std::vector<char> unclear_;  // vertices whose fans are not looked at
  std::vector<std::pair<Index, Index>> turned_over_;
  std::vector<Index> one_sided_;
  JoinedSets sides_;  // faces, by which way they run
  JoinedSets fans_;   // corners, by their fan
  MeshFaults faults_;
};

}  // namespace

MeshFaults find_mesh_faults(const Polygons& polygons) {
  if (has_offsets(polygons)) return FaultFinder(polygons).find();
  MeshFaults faults;
  faults.list.emplace_back();
  return faults;
}

}  // namespace limn::mesh
