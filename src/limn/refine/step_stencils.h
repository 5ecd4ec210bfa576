#pragma once
/// The sums of one refinement step: which rule makes each new vertex, and what it weighs there. The
/// one place where rules meet a mesh, whatever is refined (refine_values.h) or only written down
/// (fast/plain/plain_rows.h).

#include <algorithm>
#include <array>
#include <cassert>
#include <type_traits>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/number/arithmetic.h"
#include "limn/refine/big_rings.h"
#include "limn/refine/rule_tables.h"

namespace limn::refine {

template <class Number>
class StepStencils {
 public:
  /// All must outlive the stencils; `tables` has been prepared for `mesh` and `births`. Not for a
  /// scheme of stages, which has no rules: staged_step.h has its step.
  StepStencils(const Scheme& scheme, const Mesh& mesh, const Births& births,
               const RuleTables<Number>& tables)
      : split_(*scheme.split),
        spokes_(stands_in(scheme, RuleKind::edge_end) ||
                stands_in(scheme, RuleKind::boundary_spoke)),
        boundary_ends_(stands_in(scheme, RuleKind::boundary_edge_end)),
        face_ends_(stands_in(scheme, RuleKind::face_end)),
        edge_sides_(stands_in(scheme, RuleKind::edge_side)),
        mesh_(mesh),
        births_(births),
        tables_(tables),
        one_(number::Arithmetic<Number>::from(Rational(1))),
        faces_at_(births.from_vertices + births.from_edges),
        corners_at_(faces_at_ + births.from_faces),
        isolated_at_(corners_at_ + births.from_corners) {
    assert(!scheme.stages);
    for (std::size_t count = 1; count < shares_.size(); ++count)
      shares_[count] = number::Arithmetic<Number>::from(Rational(1, static_cast<int>(count)));
  }

  /// The number of new vertices.
  [[nodiscard]] Index count() const {
    return isolated_at_ + static_cast<Index>(births_.isolated.size());
  }
  /// The new vertices of faces, [faces_at(), corners_at()), are what others may weigh.
  [[nodiscard]] Index faces_at() const { return faces_at_; }
  [[nodiscard]] Index corners_at() const { return corners_at_; }

  /// To be called before vertices are asked for by the thousand: what depends on a valence is found
  /// for all old vertices. Cost O(mesh).
  void prepare_all() {
    const bool from_ends = uses_ends(), from_corners = uses_corners();
    if (births_.from_vertices > 0 || from_ends || from_corners) valences_ = mesh::valences(mesh_);
    if (!from_ends && !from_corners) return;
    const auto count = static_cast<std::size_t>(mesh_.vertex_count());
    if (from_ends) end_rows_.resize(count);
    if (from_corners) corner_rows_.resize(count);
    base::parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (mesh_.is_isolated(v)) return;
      if (from_ends) end_rows_[v] = end_row(v);
      if (from_corners) corner_rows_[v] = corner_row(v);
    });
    turns_ = std::any_of(end_rows_.begin(), end_rows_.end(), turns) ||
             std::any_of(corner_rows_.begin(), corner_rows_.end(), turns);
    if (turns_) rings_ = mesh::rings(mesh_, valences_);
  }

  /// Round what has kBigRing anchors or more (big_rings.h), new vertices weigh from now on a sum
  /// that the caller makes: the old "vertex" past the last by the number of the ring's anchor,
  /// those of the first ring first. The first big_rings_of_faces() are for the new vertices of
  /// faces, and weigh none of these. Cost O(mesh). After prepare_all.
  [[nodiscard]] const std::vector<BigRing>& use_big_rings() {
    for (std::size_t v = 0; v < corner_rows_.size(); ++v)
      if (corner_rows_[v] != nullptr && valences_[v] >= kBigRing)
        add_big_ring(RuleKind::face_end, mesh_.halfedge_of_vertex(static_cast<Index>(v)),
                     *corner_rows_[v]);
    big_rings_of_faces_ = big_rings_.size();
    if (births_.from_corners > 0)
      for (Index f = 0; f < mesh_.face_count(); ++f)
        if (mesh_.degree(f) >= kBigRing)
          add_big_ring(RuleKind::corner, mesh_.face_begin(f),
                       tables_.row(RuleKind::corner, mesh_.degree(f)));
    for (std::size_t v = 0; v < end_rows_.size(); ++v)
      if (end_rows_[v] != nullptr && valences_[v] >= kBigRing &&
          !mesh_.is_boundary_vertex(static_cast<Index>(v)))
        add_big_ring(RuleKind::edge_end, mesh_.halfedge_of_vertex(static_cast<Index>(v)),
                     *end_rows_[v]);
    return big_rings_;
  }
  [[nodiscard]] std::size_t big_rings_of_faces() const { return big_rings_of_faces_; }

  /// Calls sink(source, weight) for all that new vertex i weighs, in a fixed order: an old vertex,
  /// or the new vertex faces_at() + source.index. One may come more than once: the weights add.
  /// Nothing where the boundary is left out. Cost: the moves of the rule's walks.
  template <class Sink>
  void visit(Index i, Sink&& sink) const {
    if (i < births_.from_vertices) return visit_vertex(i, sink);
    if (i < faces_at_) return visit_edge(i - births_.from_vertices, sink);
    if (i < corners_at_) return visit_face(i - faces_at_, sink);
    if (i < isolated_at_) return visit_corner(i - corners_at_, sink);
    sink(Source{births_.isolated[i - isolated_at_], false}, one_);
  }

 private:
  /// Where an anchor's sum is, and whose rule says what else it weighs.
  struct Slot {
    Index ring = kNone, sum = kNone;
  };

  void add_big_ring(RuleKind kind, Index h, const Row<double>& row) {
    if (!row.program) return;
    BigRing ring(mesh_, kind, h, row);
    if (!ring.turns()) return;
    std::vector<Slot>& slots = kind == RuleKind::face_end ? face_slots_ : slots_;
    slots.resize(static_cast<std::size_t>(mesh_.halfedge_count()));
    for (const Index anchor : ring.anchors())
      slots[anchor] = {static_cast<Index>(big_rings_.size()), next_sum_++};
    big_rings_.push_back(std::move(ring));
  }

  /// Whether the scheme has a rule that stands in for another.
  static bool stands_in(const Scheme& scheme, RuleKind kind) {
    return scheme.rule(kind) && stands_in_for(kind, *scheme.split);
  }
  [[nodiscard]] bool uses_ends() const {
    return spokes_ && births_.from_edges > 0 && births_.edge_ends.empty();
  }
  [[nodiscard]] bool uses_corners() const { return face_ends_ && births_.from_faces > 0; }
  /// Whether a vertex with this row is gone round for each of its edges.
  [[nodiscard]] static bool turns(const Row<Number>* row) {
    return row != nullptr &&
           std::any_of(row->program->begin(), row->program->end(),
                       [](const Step& step) { return step.turning != Step::Turning::none; });
  }
  [[nodiscard]] Index valence(Index v) const {
    return valences_.empty() ? mesh_.valence(v) : valences_[v];
  }

  template <class Sink>
  void visit_row(RuleKind kind, Index h, bool at_target, const Row<Number>& row, Sink& sink) const {
    if constexpr (std::is_same_v<Number, double>)
      if (const Slot slot = slot_of(kind, h); slot.ring != kNone) {
        sink(Source{mesh_.vertex_count() + slot.sum, false}, one_);
        return visit_stencil(mesh_, kind, h, at_target, big_rings_[slot.ring].singles(), sink);
      }
    if (row.program)
      visit_stencil(mesh_, kind, h, at_target, row, sink, turns_ ? &rings_ : nullptr);
  }

  [[nodiscard]] Slot slot_of(RuleKind kind, Index h) const {
    if (kind == RuleKind::face_end) return face_slots_.empty() ? Slot{} : face_slots_[h];
    const bool has_one = kind == RuleKind::edge_end || kind == RuleKind::corner;
    return slots_.empty() || !has_one ? Slot{} : slots_[h];
  }

  /// A rule that stands in for another, seen from an end or a corner; row nullptr: no case applies.
  struct Seen {
    RuleKind kind = RuleKind::edge_end;
    Index anchor = kNone;
    bool at_target = false;
    const Row<Number>* row = nullptr;
  };
  /// The mean of what `count` of them give. False where no case applies to any.
  template <class Sink>
  bool visit_mean(const Seen* seen, std::size_t count, Sink& sink) const {
    const auto applies = [](const Seen& one) { return one.row != nullptr; };
    const auto rows = static_cast<std::size_t>(std::count_if(seen, seen + count, applies));
    if (rows == 0) return false;
    const auto part = [&](Source source, const Number& weight) {
      sink(source, Number(shares_[rows] * weight));
    };
    for (const Seen* one = seen; one != seen + count; ++one) {
      if (!applies(*one)) continue;
      if (rows == 1)
        visit_row(one->kind, one->anchor, one->at_target, *one->row, sink);
      else
        visit_row(one->kind, one->anchor, one->at_target, *one->row, part);
    }
    return true;
  }

  /// A face seen from its corners, where it has as many as on the lattice.
  template <class Sink>
  bool visit_face_ends(Index f, Sink& sink) const {
    const std::size_t corners = split_.lattice == Lattice::triangle ? 3 : 4;
    if (static_cast<std::size_t>(mesh_.degree(f)) != corners) return false;
    std::array<Seen, kMostSeen> seen;
    Index h = mesh_.face_begin(f);
    for (std::size_t i = 0; i < corners; ++i, ++h) {
      const Index v = mesh_.origin(h);
      const Row<Number>* row = corner_rows_.empty() ? corner_row(v) : corner_rows_[v];
      seen[i] = {RuleKind::face_end, h, false, row};
    }
    return visit_mean(seen.data(), corners, sink);
  }

  template <class Sink>
  void visit_face(Index i, Sink& sink) const {
    const Index f = births_.faces.empty() ? i : births_.faces[i];
    if (face_ends_ && visit_face_ends(f, sink)) return;
    visit_row(RuleKind::face, mesh_.face_begin(f), false,
              tables_.row(RuleKind::face, mesh_.degree(f)), sink);
  }

  template <class Sink>
  void visit_corner(Index h, Sink& sink) const {
    visit_row(RuleKind::corner, h, false,
              tables_.row(RuleKind::corner, mesh_.degree(mesh_.face(h))), sink);
  }

  template <class Sink>
  void visit_vertex(Index v, Sink& sink) const {
    const Index h = mesh_.halfedge_of_vertex(v);
    const bool boundary = mesh_.is_boundary_vertex(v);
    if (h == kNone || (boundary && split_.boundary_rests() && births_.from_edges == 0))
      return sink(Source{v, false}, one_);
    const RuleKind kind = boundary ? RuleKind::boundary_vertex : RuleKind::vertex;
    visit_row(kind, h, false, tables_.row(kind, valence(v)), sink);
  }

  /// The row of a rule that stands in for another, where a case applies.
  [[nodiscard]] const Row<Number>* row_of(RuleKind kind, Index n) const {
    const Row<Number>* row = tables_.find_row(kind, n);
    return row != nullptr && row->program ? row : nullptr;
  }
  [[nodiscard]] RuleKind spoke_kind(Index v) const {
    return mesh_.is_boundary_vertex(v) ? RuleKind::boundary_spoke : RuleKind::edge_end;
  }
  /// Of an interior edge seen from this end.
  [[nodiscard]] const Row<Number>* end_row(Index v) const {
    return row_of(spoke_kind(v), valence(v));
  }
  /// Of a face seen from this corner.
  [[nodiscard]] const Row<Number>* corner_row(Index v) const {
    return mesh_.is_boundary_vertex(v) ? nullptr : row_of(RuleKind::face_end, valence(v));
  }

  /// A boundary edge, by its half-edge.
  template <class Sink>
  void visit_boundary_edge(Index h, Sink& sink) const {
    if (boundary_ends_) {
      std::array<Seen, 2> seen;
      for (const bool at_target : {false, true}) {
        const Index v = at_target ? mesh_.target(h) : mesh_.origin(h);
        const Row<Number>* row = row_of(RuleKind::boundary_edge_end, valence(v));
        seen[at_target ? 1 : 0] = {RuleKind::boundary_edge_end, h, at_target, row};
      }
      if (visit_mean(seen.data(), seen.size(), sink)) return;
    }
    visit_row(RuleKind::boundary_edge, h, false, tables_.row(RuleKind::boundary_edge, 0), sink);
  }

  template <class Sink>
  void visit_boundary_third(const EdgeChild& child, Sink& sink) const {
    const Index near =
        child.at_target ? mesh_.target(child.halfedge) : mesh_.origin(child.halfedge);
    visit_row(RuleKind::boundary_edge_end, child.halfedge, child.at_target,
              tables_.row(RuleKind::boundary_edge_end, valence(near)), sink);
  }

  /// One of the two new vertices of an edge that is cut in three.
  template <class Sink>
  void visit_third(const EdgeChild& child, Sink& sink) const {
    const Index twin = mesh_.twin(child.halfedge);
    if (twin == kNone) return visit_boundary_third(child, sink);
    const Index h = child.at_target ? twin : child.halfedge;  // out of the near end
    if (spokes_) {
      const Index near = mesh_.origin(h);
      const Row<Number>* row = end_rows_.empty() ? end_row(near) : end_rows_[near];
      if (row != nullptr) return visit_row(RuleKind::edge_end, h, false, *row, sink);
    }
    visit_row(RuleKind::edge_third, h, false, tables_.row(RuleKind::edge_third, 0), sink);
  }

  /// An interior edge seen from its faces; of two alike one tells all.
  template <class Sink>
  bool visit_edge_sides(Index h, Index twin, Sink& sink) const {
    std::array<Seen, 2> seen;
    const std::array<Index, 2> degrees{mesh_.degree(mesh_.face(h)), mesh_.degree(mesh_.face(twin))};
    for (std::size_t side = 0; side < 2; ++side)
      seen[side] = {RuleKind::edge_side, side == 0 ? h : twin, false,
                    row_of(RuleKind::edge_side, degrees[side])};
    return visit_mean(seen.data(), degrees[0] == degrees[1] ? 1 : 2, sink);
  }

  template <class Sink>
  void visit_edge(Index i, Sink& sink) const {
    const EdgeChild child = edge_child(mesh_, births_, i);
    if (child.third) return visit_third(child, sink);
    const Index h = child.halfedge;
    const Index twin = mesh_.twin(h);
    if (twin == kNone) return visit_boundary_edge(h, sink);
    if (edge_sides_ && visit_edge_sides(h, twin, sink)) return;
    if (spokes_) {
      std::array<Seen, 2> seen;
      for (const bool other : {false, true}) {
        const Index out = other ? twin : h, v = mesh_.origin(out);
        const Row<Number>* row = end_rows_.empty() ? end_row(v) : end_rows_[v];
        seen[other ? 1 : 0] = {spoke_kind(v), out, false, row};
      }
      if (visit_mean(seen.data(), seen.size(), sink)) return;
    }
    visit_row(RuleKind::edge, h, false, tables_.row(RuleKind::edge, 0), sink);
  }

  const Split& split_;
  bool spokes_;         // whether interior edges may be seen from their ends,
  bool boundary_ends_;  // boundary edges
  bool face_ends_;      // faces from their corners,
  bool edge_sides_;     // and interior edges from their faces
  const Mesh& mesh_;
  const Births& births_;
  const RuleTables<Number>& tables_;
  static constexpr std::size_t kMostSeen = 4;  // corners of a face
  const Number one_;
  std::array<Number, kMostSeen + 1> shares_;  // 1/i
  Index faces_at_, corners_at_, isolated_at_;
  // of each old vertex, or empty
  std::vector<Index> valences_;
  std::vector<const Row<Number>*> end_rows_, corner_rows_;
  bool turns_ = false;
  mesh::Rings rings_;  // where there is a use for them
  std::vector<BigRing> big_rings_;
  std::size_t big_rings_of_faces_ = 0;
  std::vector<Slot> slots_, face_slots_;  // of each half-edge, or empty
  Index next_sum_ = 0;
};

}  // namespace limn::refine
