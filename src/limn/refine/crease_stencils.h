#pragma once
/// The sums of a step of a mesh with sharpness: those of its views (crease_step.h), each with its
/// part. Like step_stencils.h, whatever is refined.

#include <deque>
#include <optional>

#include "limn/refine/crease_step.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/step_stencils.h"

namespace limn::refine {

/// Tabulates all rows that the step needs. Fails as RuleTables::prepare does.
template <class Number>
[[nodiscard]] Status prepare_tables(RuleTables<Number>& tables, const CreaseStep& step) {
  if (Status status = tables.prepare(step.now().cut.mesh, step.now().fine.births); !status)
    return status;
  for (const CreaseStep::View& view : step.afters())
    if (Status status = tables.prepare(view.cut.mesh, view.fine.births); !status) return status;
  if (step.has_darts()) return tables.prepare(step.mesh(), step.whole_births());
  return Done{};
}

template <class Number>
class CreaseStencils {
 public:
  /// All must outlive the stencils; `tables` has been prepared for the step.
  CreaseStencils(const Scheme& scheme, const CreaseStep& step, const RuleTables<Number>& tables)
      : step_(step),
        births_(step.fine().births),
        edges_at_(births_.from_vertices),
        faces_at_(edges_at_ + births_.from_edges),
        now_(scheme, step.now().cut.mesh, step.now().fine.births, tables) {
    now_.prepare_all();
    for (const CreaseStep::View& view : step.afters())
      afters_.emplace_back(scheme, view.cut.mesh, view.fine.births, tables).prepare_all();
    if (step.has_darts())
      whole_.emplace(scheme, step.mesh(), step.whole_births(), tables).prepare_all();
  }

  /// The number of new vertices.
  [[nodiscard]] Index count() const { return step_.fine().mesh.vertex_count(); }
  /// The new vertices of faces, [faces_at(), corners_at()), are what others may weigh.
  [[nodiscard]] Index faces_at() const { return faces_at_; }
  [[nodiscard]] Index corners_at() const { return faces_at_ + births_.from_faces; }

  /// As StepStencils::visit.
  template <class Sink>
  void visit(Index i, Sink&& sink) const {
    if (i < edges_at_) return visit_vertex(i, sink);
    if (i < faces_at_) return visit_edge(i, sink);
    visit_smooth(i, 1, sink);
  }

 private:
  using Rule = CreaseStep::Rule;

  [[nodiscard]] static Number number(double x) {
    if constexpr (std::is_same_v<Number, double>)
      return x;
    else
      return number::Arithmetic<Number>::from(Rational(x));
  }

  /// One new vertex of a view, times `part`.
  template <class Sink>
  static void visit_copy(const StepStencils<Number>& stencils, const CreaseStep::View& view,
                         Index copy, double part, Sink& sink) {
    const Number factor = number(part);
    stencils.visit(copy, [&](Source source, const Number& weight) {
      if (!source.is_face) source.index = view.cut.originals[source.index];
      sink(source, Number(factor * weight));
    });
  }

  /// The mean of all copies of new vertex i, times `part`.
  template <class Sink>
  static void visit_copies(const StepStencils<Number>& stencils, const CreaseStep::View& view,
                           Index i, double part, Sink& sink) {
    Index count = 0;
    for (Index copy = view.first[i]; copy != kNone; copy = view.next[copy]) ++count;
    for (Index copy = view.first[i]; copy != kNone; copy = view.next[copy])
      visit_copy(stencils, view, copy, part / count, sink);
  }

  template <class Sink>
  void visit_now(Index i, double part, Sink& sink) const {
    visit_copies(now_, step_.now(), i, part, sink);
  }
  template <class Sink>
  void visit_after(Index view, Index i, double part, Sink& sink) const {
    visit_copies(afters_[view], step_.afters()[view], i, part, sink);
  }

  template <class Sink>
  void visit_smooth(Index i, double part, Sink& sink) const {
    const double now = afters_.empty() ? 1 : step_.part_near(i);
    if (now > 0) visit_now(i, part * now, sink);
    if (now < 1) visit_after(0, i, part * (1 - now), sink);
  }

  template <class Sink>
  void visit_vertex(Index v, Sink& sink) const {
    if (step_.now().first[v] == kNone) return sink(Source{v, false}, number(1));  // isolated
    const CreaseStep::VertexRules& rules = step_.rules_of_vertex(v);
    if (rules.now == Rule::smooth)
      visit_smooth(v, 1, sink);
    else if (!visit_resting(rules.now, v, rules.part, sink))
      visit_now(v, rules.part, sink);
    if (rules.part < 1 && !visit_resting(rules.after, v, 1 - rules.part, sink))
      visit_after(rules.view, v, 1 - rules.part, sink);
  }
  /// The rules that no cut is needed for; false of others.
  template <class Sink>
  bool visit_resting(Rule rule, Index v, double part, Sink& sink) const {
    const Number factor = number(part);
    if (rule == Rule::corner) {
      sink(Source{v, false}, factor);
      return true;
    }
    if (rule != Rule::dart) return false;
    whole_->visit(
        v, [&](Source source, const Number& weight) { sink(source, Number(factor * weight)); });
    return true;
  }

  template <class Sink>
  void visit_edge(Index i, Sink& sink) const {
    const CreaseStep::View& view = step_.now();
    const bool sides = view.next[view.first[i]] != kNone;
    if (!sides) return visit_smooth(i, 1, sink);
    const Index h = edge_child(step_.mesh(), births_, i - edges_at_).halfedge;
    const CreaseStep::EdgeRules rules = step_.rules_of_edge(step_.mesh().edge(h));
    visit_now(i, rules.part, sink);
    if (rules.part != 1) visit_after(rules.view, i, 1 - rules.part, sink);
  }

  const CreaseStep& step_;
  const Births& births_;
  Index edges_at_, faces_at_;
  StepStencils<Number> now_;
  std::deque<StepStencils<Number>> afters_;
  std::optional<StepStencils<Number>> whole_;
};

/// The values at the refined mesh's vertices, as `refine_values` gives them without sharpness.
template <class Number, class Value>
[[nodiscard]] std::vector<Value> refine_values(const CreaseStencils<Number>& stencils,
                                               const std::vector<Value>& old) {
  std::vector<Value> fresh(static_cast<std::size_t>(stencils.count()));
  const auto fill = [&](Index begin, Index end) {
    base::parallel_for(begin, end, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) {
        Value sum{};
        stencils.visit(i, [&](Source source, const Number& weight) {
          add_scaled(
              sum, weight,
              source.is_face ? fresh[stencils.faces_at() + source.index] : old[source.index]);
        });
        fresh[i] = sum;
      }
    });
  };
  fill(stencils.faces_at(), stencils.corners_at());
  fill(0, stencils.faces_at());
  fill(stencils.corners_at(), stencils.count());
  return fresh;
}

}  // namespace limn::refine
