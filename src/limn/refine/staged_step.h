#pragma once
/// One step of a scheme of stages (Scheme::stages), executed one after the other
/// [ZorinSchroeder2001]. They cannot be expanded to rules in n and k: a second averaging may see
/// two extraordinary vertices.
///
/// Two averagings are made as one, from vertices to vertices (Stages::pair), on the mesh that was
/// cut (staged_mesh.h). Along the boundary that is (1, 2, 1)/4, as if edges there were faces of two
/// corners: the mesh goes on beyond its boundary, reflected through it, and where values end at
/// vertices the boundary is the uniform B-spline curve of its own polygon.

#include <vector>

#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"
#include "limn/number/arithmetic.h"
#include "limn/refine/add_scaled.h"
#include "limn/refine/rule_tables.h"
#include "limn/refine/staged_mesh.h"

namespace limn::refine::detail {

template <class Number, class Value>
class StagedStep {
 public:
  /// All must outlive the step; `tables` has been prepared for `mesh` and `births`.
  StagedStep(const Scheme& scheme, const Mesh& mesh, const Births& births,
             const RuleTables<Number>& tables, const std::vector<Value>& old)
      : averagings_(scheme.stages->count),
        mesh_(mesh),
        births_(births),
        tables_(tables),
        old_(old),
        cut_(*scheme.stages, mesh, births),
        vertex_count_(cut_.vertex_count()),
        half_(number::Arithmetic<Number>::from(Rational(1, 2))),
        quarter_(number::Arithmetic<Number>::from(Rational(1, 4))),
        one_(number::Arithmetic<Number>::from(Rational(1))) {}

  /// The values at the new vertices, in the order of the births. Cost O(averagings · mesh).
  std::vector<Value> run() {
    average_all({});
    std::vector<Value> values = std::move(ends_at_faces() ? faces_ : vertices_);
    for (const Index v : births_.isolated) values.push_back(old_[at(v)]);
    return values;
  }

  /// Only the new vertices of the list, in its order. Cost: a mark for each element of the mesh and
  /// each averaging, and the sums of what the list depends on.
  std::vector<Value> run_at(const std::vector<Index>& wanted) {
    const Index isolated_at = ends_at_faces() ? mesh_.halfedge_count() : vertex_count_;
    std::vector<char> marks(at(isolated_at), 0);
    for (const Index i : wanted)
      if (i < isolated_at) marks[at(i)] = 1;
    average_all(dependence(std::move(marks)));
    std::vector<Value> values;
    values.reserve(wanted.size());
    for (const Index i : wanted)
      values.push_back(i >= isolated_at  ? old_[at(births_.isolated[at(i - isolated_at)])]
                       : ends_at_faces() ? faces_[at(i)]
                                         : vertices_[at(i)]);
    return values;
  }

 private:
  /// Of the cut, of each pair of averagings, and of a last one, a mark for each element that is
  /// needed; empty: all are.
  using Marks = std::vector<std::vector<char>>;

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool ends_at_faces() const { return averagings_ % 2 != 0; }
  [[nodiscard]] std::size_t pairs() const { return static_cast<std::size_t>(averagings_) / 2; }

  /// Calls visit(i) for what is needed of a stage, on all threads.
  template <class Visit>
  void for_needed(const Marks& marks, std::size_t stage, Index count, Visit&& visit) const {
    base::parallel_for(Index{0}, count, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i)
        if (marks.empty() || marks[stage][at(i)] != 0) visit(i);
    });
  }

  void average_all(const Marks& marks) {
    vertices_.resize(at(vertex_count_));
    for_needed(marks, 0, vertex_count_, [&](Index i) { vertices_[at(i)] = bilinear(i); });
    for (std::size_t pair = 1; pair <= pairs(); ++pair) {
      std::vector<Value> fresh = base::large_vector<Value>(at(vertex_count_));
      for_needed(marks, pair, vertex_count_, [&](Index i) {
        visit_pair(i, [&](Index v, const Number& weight) {
          add_scaled(fresh[at(i)], weight, vertices_[at(v)]);
        });
      });
      vertices_ = std::move(fresh);
    }
    if (!ends_at_faces()) return;
    faces_.resize(at(mesh_.halfedge_count()));
    for_needed(marks, pairs() + 1, mesh_.halfedge_count(), [&](Index h) {
      for (const Index v : cut_.corners(h)) add_scaled(faces_[at(h)], quarter_, vertices_[at(v)]);
    });
  }

  /// What each stage needs of the one before, from the marks of the last.
  [[nodiscard]] Marks dependence(std::vector<char> last) const {
    Marks marks(pairs() + 1, std::vector<char>(at(vertex_count_), 0));
    if (ends_at_faces()) {
      for (Index h = 0; h < mesh_.halfedge_count(); ++h)
        if (last[at(h)] != 0)
          for (const Index v : cut_.corners(h)) marks.back()[at(v)] = 1;
      marks.push_back(std::move(last));
    } else {
      marks.back() = std::move(last);
    }
    for (std::size_t pair = pairs(); pair > 0; --pair)
      for (Index i = 0; i < vertex_count_; ++i)
        if (marks[pair][at(i)] != 0)
          visit_pair(i, [&](Index v, const Number&) { marks[pair - 1][at(v)] = 1; });
    return marks;
  }

  /// The vertex of the stages' mesh, where the cut puts it.
  [[nodiscard]] Value bilinear(Index i) const {
    if (i < mesh_.vertex_count()) return old_[at(i)];
    Value sum{};
    if (i < cut_.faces_at()) {
      const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count());
      for (const Index v : {mesh_.origin(h), mesh_.target(h)}) add_scaled(sum, half_, old_[at(v)]);
      return sum;
    }
    const Index f = cut_.face_of(i);
    const Number& weight = tables_.row(RuleKind::face, mesh_.degree(f)).weights.front();
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      add_scaled(sum, weight, old_[at(mesh_.origin(h))]);
    return sum;
  }

  /// The weights of a pair of averagings at a vertex.
  struct Pair {
    Pair(const RuleTables<Number>& tables, StagedMesh::Star star)
        : weights(tables.pair(star.edges, star.quads).weights) {}
    [[nodiscard]] const Number& of(PairRole role) const {
      return weights[static_cast<std::size_t>(role)];
    }
    const std::vector<Number>& weights;
  };

  /// Calls visit(v, weight) for the vertices of the stages' mesh that a pair of averagings weighs
  /// at vertex i.
  template <class Visit>
  void visit_pair(Index i, Visit&& visit) const {
    if (i >= cut_.faces_at()) return visit_center(i, visit);
    if (i >= mesh_.vertex_count()) return visit_middle(i, visit);
    if (mesh_.is_isolated(i)) return visit(i, one_);
    if (mesh_.is_boundary_vertex(i)) return visit_boundary(i, visit);
    const Pair pair(tables_, cut_.star(i));
    visit(i, pair.of(PairRole::self));
    const Index first = mesh_.halfedge_of_vertex(i);
    Index h = first;
    do {
      visit(cut_.middle(h), pair.of(PairRole::ring));
      if (const Index center = cut_.center(h); center != kNone)
        visit(center, pair.of(PairRole::diagonal));
      h = mesh_.rotate(h);
    } while (h != first);
  }

  template <class Visit>
  void visit_middle(Index i, Visit& visit) const {
    const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count()), t = mesh_.twin(h);
    if (t == kNone) {
      visit(i, half_);
      visit(mesh_.origin(h), quarter_);
      return visit(mesh_.target(h), quarter_);
    }
    const Pair pair(tables_, cut_.star(i));
    visit(i, pair.of(PairRole::self));
    for (const Index side : {h, t}) {
      visit(mesh_.origin(side), pair.of(PairRole::ring));
      const Index center = cut_.center(side);
      if (center != kNone) visit(center, pair.of(PairRole::ring));
      // beside quads the middles of the next edges are opposite corners, in a triangle neighbours
      const Number& beside = pair.of(center != kNone ? PairRole::diagonal : PairRole::ring);
      visit(cut_.middle(mesh_.prev(side)), beside);
      visit(cut_.middle(mesh_.next(side)), beside);
    }
  }

  template <class Visit>
  void visit_center(Index i, Visit& visit) const {
    const Index f = cut_.face_of(i);
    const Pair pair(tables_, cut_.star(i));
    visit(i, pair.of(PairRole::self));
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) {
      visit(cut_.middle(h), pair.of(PairRole::ring));
      visit(mesh_.origin(h), pair.of(PairRole::diagonal));
    }
  }

  template <class Visit>
  void visit_boundary(Index v, Visit& visit) const {
    visit(v, half_);
    Index last = mesh_.halfedge_of_vertex(v);
    visit(cut_.middle(last), quarter_);
    for (Index h = mesh_.rotate(last); h != kNone; h = mesh_.rotate(h)) last = h;
    visit(cut_.middle(mesh_.prev(last)), quarter_);
  }

  int averagings_;
  const Mesh& mesh_;
  const Births& births_;
  const RuleTables<Number>& tables_;
  const std::vector<Value>& old_;
  StagedMesh cut_;
  Index vertex_count_;  // of the mesh that was cut
  Number half_, quarter_, one_;
  std::vector<Value> vertices_, faces_;
};

}  // namespace limn::refine::detail
