#pragma once
/// The sums of one refinement step: which rule makes each new vertex, and what it weighs there. The
/// one place where rules meet a mesh, whatever is refined (refine_values.h) or only written down
/// (fast/plain/plain_rows.h).

#include <algorithm>
#include <type_traits>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/number/arithmetic.h"
#include "limn/refine/big_rings.h"
#include "limn/refine/rule_tables.h"

namespace limn {

template <class Number>
class StepStencils {
 public:
  /// All must outlive the stencils; `tables` has been prepared for `mesh` and `births`.
  StepStencils(const Scheme& scheme, const Mesh& mesh, const Births& births,
               const RuleTables<Number>& tables)
      : split_(*scheme.split),
        ends_(scheme.rule(RuleKind::edge_end).has_value()),
        mesh_(mesh),
        births_(births),
        tables_(tables),
        half_(Arithmetic<Number>::from(Rational(1, 2))),
        one_(Arithmetic<Number>::from(Rational(1))),
        faces_at_(births.from_vertices + births.from_edges),
        corners_at_(faces_at_ + births.from_faces),
        isolated_at_(corners_at_ + births.from_corners) {}

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
    if (births_.from_vertices > 0 || uses_ends()) valences_ = valences(mesh_);
    if (!uses_ends()) return;
    end_rows_.resize(static_cast<std::size_t>(mesh_.vertex_count()));
    parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (!mesh_.is_isolated(v)) end_rows_[v] = end_row(v);
    });
    turns_ = std::any_of(end_rows_.begin(), end_rows_.end(), turns);
    if (turns_) rings_ = rings(mesh_, valences_);
  }

  /// Round what has kBigRing anchors or more (big_rings.h), new vertices weigh from now on a sum
  /// that the caller makes: the old "vertex" past the last by the number of the ring's anchor,
  /// those of the first ring first. Cost O(mesh). After prepare_all.
  [[nodiscard]] const std::vector<BigRing>& use_big_rings() {
    if (births_.from_corners > 0)
      for (Index f = 0; f < mesh_.face_count(); ++f)
        if (mesh_.degree(f) >= kBigRing)
          add_big_ring(RuleKind::corner, mesh_.face_begin(f),
                       tables_.row(RuleKind::corner, mesh_.degree(f)));
    for (std::size_t v = 0; v < end_rows_.size(); ++v)
      if (end_rows_[v] != nullptr && valences_[v] >= kBigRing)
        add_big_ring(RuleKind::edge_end, mesh_.halfedge_of_vertex(static_cast<Index>(v)),
                     *end_rows_[v]);
    return big_rings_;
  }

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
    slots_.resize(static_cast<std::size_t>(mesh_.halfedge_count()));
    for (const Index anchor : ring.anchors())
      slots_[anchor] = {static_cast<Index>(big_rings_.size()), next_sum_++};
    big_rings_.push_back(std::move(ring));
  }

  [[nodiscard]] bool uses_ends() const {
    return ends_ && births_.from_edges > 0 && births_.edge_ends.empty();
  }
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
      if (!slots_.empty() && (kind == RuleKind::edge_end || kind == RuleKind::corner) &&
          slots_[h].ring != kNone) {
        sink(Source{mesh_.vertex_count() + slots_[h].sum, false}, one_);
        return visit_stencil(mesh_, kind, h, at_target, big_rings_[slots_[h].ring].singles(), sink);
      }
    if (row.program)
      visit_stencil(mesh_, kind, h, at_target, row, sink, turns_ ? &rings_ : nullptr);
  }

  template <class Sink>
  void visit_face(Index i, Sink& sink) const {
    const Index f = births_.faces.empty() ? i : births_.faces[i];
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

  /// The row for the edge seen from an end, where the end is interior and has a case for it.
  [[nodiscard]] const Row<Number>* end_row(Index v) const {
    if (mesh_.is_boundary_vertex(v)) return nullptr;
    const Row<Number>& row = tables_.row(RuleKind::edge_end, valence(v));
    return row.program ? &row : nullptr;
  }

  /// One of the two new vertices of an edge that is cut in three.
  template <class Sink>
  void visit_third(const EdgeChild& child, Sink& sink) const {
    const Index twin = mesh_.twin(child.halfedge);
    if (twin == kNone)
      return visit_row(RuleKind::boundary_edge_end, child.halfedge, child.at_target,
                       tables_.row(RuleKind::boundary_edge_end, 0), sink);
    const Index h = child.at_target ? twin : child.halfedge;  // out of the near end
    if (ends_) {
      const Index near = mesh_.origin(h);
      const Row<Number>* row = end_rows_.empty() ? end_row(near) : end_rows_[near];
      if (row != nullptr) return visit_row(RuleKind::edge_end, h, false, *row, sink);
    }
    visit_row(RuleKind::edge_third, h, false, tables_.row(RuleKind::edge_third, 0), sink);
  }

  template <class Sink>
  void visit_edge(Index i, Sink& sink) const {
    const EdgeChild child = edge_child(mesh_, births_, i);
    if (child.third) return visit_third(child, sink);
    const Index h = child.halfedge;
    const Index twin = mesh_.twin(h);
    if (twin == kNone)
      return visit_row(RuleKind::boundary_edge, h, false, tables_.row(RuleKind::boundary_edge, 0),
                       sink);
    if (ends_) {
      const bool found = !end_rows_.empty();
      const Index v = mesh_.origin(h), w = mesh_.origin(twin);
      const Row<Number>* from = found ? end_rows_[v] : end_row(v);
      const Row<Number>* to = found ? end_rows_[w] : end_row(w);
      if (from != nullptr && to != nullptr) {  // both ends claim it: the mean
        const auto half = [&](Source source, const Number& weight) {
          sink(source, Number(half_ * weight));
        };
        visit_row(RuleKind::edge_end, h, false, *from, half);
        return visit_row(RuleKind::edge_end, twin, false, *to, half);
      }
      if (from != nullptr) return visit_row(RuleKind::edge_end, h, false, *from, sink);
      if (to != nullptr) return visit_row(RuleKind::edge_end, twin, false, *to, sink);
    }
    visit_row(RuleKind::edge, h, false, tables_.row(RuleKind::edge, 0), sink);
  }

  const Split& split_;
  bool ends_;
  const Mesh& mesh_;
  const Births& births_;
  const RuleTables<Number>& tables_;
  const Number half_, one_;
  Index faces_at_, corners_at_, isolated_at_;
  std::vector<Index> valences_;               // of each old vertex, or empty
  std::vector<const Row<Number>*> end_rows_;  // of each old vertex, or empty
  bool turns_ = false;
  Rings rings_;  // where there is a use for them
  std::vector<BigRing> big_rings_;
  std::vector<Slot> slots_;  // of each half-edge, or empty
  Index next_sum_ = 0;
};

}  // namespace limn
