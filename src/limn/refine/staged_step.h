#pragma once
/// One step of a scheme of stages (Scheme::stages), executed one after the other
/// [ZorinSchroeder2001]. They cannot be expanded to rules in n and k: a second averaging may see
/// two extraordinary vertices.
///
/// The mesh that stages live on is the control mesh cut by quad-dyadic. It is not made: it has a
/// vertex for each old vertex, edge and face, and its face h lies at the corner h of the control
/// mesh, so the averagings are index arithmetic on the control mesh. At the boundary of that mesh
/// an edge counts as a face of two corners, and a boundary vertex is the mean of its two boundary
/// edges alone: two averagings together are (1, 2, 1)/4 along the boundary. So it is as if the
/// mesh went on beyond its boundary, reflected through it, and where values end at vertices the
/// boundary is the uniform B-spline curve of its own polygon.

#include <cassert>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/number/arithmetic.h"
#include "limn/refine/add_scaled.h"
#include "limn/refine/rule_tables.h"

namespace limn::detail {

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
        faces_at_(mesh.vertex_count() + mesh.edge_count()),
        vertex_count_(faces_at_ + mesh.face_count()),
        half_(Arithmetic<Number>::from(Rational(1, 2))),
        quarter_(Arithmetic<Number>::from(Rational(1, 4))) {}

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
  /// Of each stage, the bilinear first, a mark for each element that is needed; empty: all are.
  using Marks = std::vector<std::vector<char>>;

  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool ends_at_faces() const { return averagings_ % 2 != 0; }
  [[nodiscard]] const Number& mean_of(Index n) const {
    return tables_.row(RuleKind::face, n).weights.front();
  }

  /// Calls visit(i) for what is needed of a stage, on all threads.
  template <class Visit>
  void for_needed(const Marks& marks, int stage, Index count, Visit&& visit) const {
    parallel_for(Index{0}, count, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i)
        if (marks.empty() || marks[static_cast<std::size_t>(stage)][at(i)] != 0) visit(i);
    });
  }

  void average_all(const Marks& marks) {
    vertices_.resize(at(vertex_count_));
    for_needed(marks, 0, vertex_count_, [&](Index i) { vertices_[at(i)] = bilinear(i); });
    for (int stage = 1; stage <= averagings_; ++stage) {
      if (stage % 2 != 0) {
        std::vector<Value> fresh(at(mesh_.halfedge_count()));
        for_needed(marks, stage, mesh_.halfedge_count(), [&](Index h) {
          each_corner(h, [&](Index v) { add_scaled(fresh[at(h)], quarter_, vertices_[at(v)]); });
        });
        faces_ = std::move(fresh);
      } else {
        std::vector<Value> fresh(at(vertex_count_));
        for_needed(marks, stage, vertex_count_, [&](Index i) { average_at(i, fresh[at(i)]); });
        vertices_ = std::move(fresh);
      }
    }
  }

  /// What each stage needs of the one before, from the marks of the last.
  [[nodiscard]] Marks dependence(std::vector<char> last) const {
    Marks marks(static_cast<std::size_t>(averagings_) + 1);
    marks.back() = std::move(last);
    for (int stage = averagings_; stage > 0; --stage) {
      const std::vector<char>& needed = marks[static_cast<std::size_t>(stage)];
      std::vector<char>& before = marks[static_cast<std::size_t>(stage) - 1];
      if (before.empty())
        before.resize(at(stage % 2 != 0 ? vertex_count_ : mesh_.halfedge_count()), 0);
      for (Index i = 0; i < static_cast<Index>(needed.size()); ++i) {
        if (needed[at(i)] == 0) continue;
        if (stage % 2 != 0) {
          each_corner(i, [&](Index v) { before[at(v)] = 1; });
        } else if (is_boundary(i)) {  // weighs vertices of two stages before
          std::vector<char>& twice = marks[static_cast<std::size_t>(stage) - 2];
          if (twice.empty()) twice.resize(at(vertex_count_), 0);
          each_beside(i, [&](Index v, const Number&) { twice[at(v)] = 1; });
        } else {
          each_face(i, [&](Index h) { before[at(h)] = 1; });
        }
      }
    }
    return marks;
  }

  /// The vertex of the stages' mesh, where the cut puts it.
  [[nodiscard]] Value bilinear(Index i) const {
    if (i < mesh_.vertex_count()) return old_[at(i)];
    Value sum{};
    if (i < faces_at_) {
      const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count());
      for (const Index v : {mesh_.origin(h), mesh_.target(h)}) add_scaled(sum, half_, old_[at(v)]);
      return sum;
    }
    const Index f = i - faces_at_;
    const Number& weight = mean_of(mesh_.degree(f));
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      add_scaled(sum, weight, old_[at(mesh_.origin(h))]);
    return sum;
  }

  /// The mean of the faces at vertex i of the stages' mesh, or along its boundary.
  void average_at(Index i, Value& sum) const {
    if (i < mesh_.vertex_count() && mesh_.is_isolated(i)) {
      sum = old_[at(i)];
    } else if (is_boundary(i)) {
      each_beside(
          i, [&](Index v, const Number& weight) { add_scaled(sum, weight, vertices_[at(v)]); });
    } else {
      const Number& weight = i < mesh_.vertex_count() ? mean_of(mesh_.valence(i))
                             : i < faces_at_          ? quarter_
                                                      : mean_of(mesh_.degree(i - faces_at_));
      each_face(i, [&](Index h) { add_scaled(sum, weight, faces_[at(h)]); });
    }
  }

  [[nodiscard]] Index middle(Index h) const { return mesh_.vertex_count() + mesh_.edge(h); }

  /// The corners of face h of the stages' mesh.
  template <class Visit>
  void each_corner(Index h, Visit&& visit) const {
    visit(mesh_.origin(h));
    visit(middle(h));
    visit(faces_at_ + mesh_.face(h));
    visit(middle(mesh_.prev(h)));
  }

  /// The faces at an interior vertex of the stages' mesh.
  template <class Visit>
  void each_face(Index i, Visit&& visit) const {
    if (i < mesh_.vertex_count()) {
      const Index first = mesh_.halfedge_of_vertex(i);
      for (Index h = first; h != kNone;) {
        visit(h);
        h = mesh_.rotate(h);
        if (h == first) break;
      }
    } else if (i < faces_at_) {
      const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count()), t = mesh_.twin(h);
      for (const Index side : {h, t}) {
        visit(side);
        visit(mesh_.next(side));
      }
    } else {
      for (Index h = mesh_.face_begin(i - faces_at_); h < mesh_.face_begin(i - faces_at_ + 1); ++h)
        visit(h);
    }
  }

  [[nodiscard]] bool is_boundary(Index i) const {
    if (i < mesh_.vertex_count()) return !mesh_.is_isolated(i) && mesh_.is_boundary_vertex(i);
    return i < faces_at_ && mesh_.is_boundary_edge(i - mesh_.vertex_count());
  }

  /// What a boundary vertex of the stages' mesh weighs of two averagings before, with the weights.
  template <class Visit>
  void each_beside(Index i, Visit&& visit) const {
    visit(i, half_);
    if (i >= mesh_.vertex_count()) {
      const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count());
      visit(mesh_.origin(h), quarter_);
      visit(mesh_.target(h), quarter_);
      return;
    }
    Index last = mesh_.halfedge_of_vertex(i);
    visit(middle(last), quarter_);
    for (Index h = mesh_.rotate(last); h != kNone; h = mesh_.rotate(h)) last = h;
    visit(middle(mesh_.prev(last)), quarter_);
  }

  int averagings_;
  const Mesh& mesh_;
  const Births& births_;
  const RuleTables<Number>& tables_;
  const std::vector<Value>& old_;
  Index faces_at_, vertex_count_;  // of the stages' mesh
  Number half_, quarter_;
  std::vector<Value> vertices_, faces_;
};

}  // namespace limn::detail
