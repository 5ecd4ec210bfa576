#pragma once
/// One refinement step of values of any type: the one place where rules meet a mesh.
/// Positions, scalars, complex numbers and linear forms all refine through this function.

#include <vector>

#include "limn/base/parallel.h"
#include "limn/refine/rule_tables.h"

namespace limn {

/// sum += weight · value. Overload it for a value type that has a quicker way.
template <class Number, class Value>
void add_scaled(Value& sum, const Number& weight, const Value& value) {
  sum += weight * value;
}
inline void add_scaled(Point3& sum, double weight, const Point3& value) {
  sum.x += weight * value.x;
  sum.y += weight * value.y;
  sum.z += weight * value.z;
}

namespace detail {

/// The values of one step: those of the old vertices, and the new ones in their blocks.
template <class Number, class Value>
class ValueStep {
 public:
  ValueStep(const Scheme& scheme, const Mesh& mesh, const Births& births,
            const RuleTables<Number>& tables, const std::vector<Value>& old)
      : split_(*scheme.split),
        ends_(scheme.rule(RuleKind::edge_end).has_value()),
        mesh_(mesh),
        births_(births),
        tables_(tables),
        old_(old),
        faces_at_(births.from_vertices + births.from_edges),
        corners_at_(faces_at_ + births.from_faces),
        isolated_at_(corners_at_ + births.from_corners),
        fresh_(static_cast<std::size_t>(isolated_at_) + births.isolated.size()) {}

  /// Only the new vertices of the list, in its order.
  std::vector<Value> run_at(const std::vector<Index>& wanted) {
    fill(faces_at_, births_.from_faces, [this](Index i) { return of_face(i); });
    std::vector<Value> values;
    values.reserve(wanted.size());
    for (const Index i : wanted) values.push_back(of_any(i));
    return values;
  }

  std::vector<Value> run() {
    find_end_rows();
    fill(faces_at_, births_.from_faces, [this](Index i) { return of_face(i); });
    fill(corners_at_, births_.from_corners, [this](Index i) { return of_corner(i); });
    fill(births_.from_vertices, births_.from_edges, [this](Index i) { return of_edge(i); });
    fill(0, births_.from_vertices, [this](Index i) { return of_vertex(i); });
    for (std::size_t i = 0; i < births_.isolated.size(); ++i)
      fresh_[static_cast<std::size_t>(isolated_at_) + i] = old_[births_.isolated[i]];
    return std::move(fresh_);
  }

 private:
  /// Before edges are asked for by the thousand: each vertex's row for the edges at it.
  void find_end_rows() {
    if (!ends_ || births_.from_edges == 0 || !births_.edge_ends.empty()) return;
    end_rows_.resize(static_cast<std::size_t>(mesh_.vertex_count()));
    parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (!mesh_.is_isolated(v)) end_rows_[static_cast<std::size_t>(v)] = end_row(v);
    });
  }

  template <class Of>
  void fill(Index first, Index count, Of of) {
    parallel_for(Index{0}, count, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i) fresh_[first + i] = of(i);
    });
  }

  [[nodiscard]] Value of_any(Index i) const {
    if (i >= isolated_at_) return old_[births_.isolated[i - isolated_at_]];
    if (i >= corners_at_) return of_corner(i - corners_at_);
    if (i >= faces_at_) return fresh_[i];
    return i >= births_.from_vertices ? of_edge(i - births_.from_vertices) : of_vertex(i);
  }

  [[nodiscard]] Value apply_row(RuleKind kind, Index h, bool at_target,
                                const Row<Number>& row) const {
    Value sum{};
    if (!row.program) return sum;
    visit_stencil(mesh_, kind, h, at_target, row, [&](Source source, const Number& weight) {
      add_scaled(sum, weight,
                 source.is_face ? fresh_[faces_at_ + source.index] : old_[source.index]);
    });
    return sum;
  }

  [[nodiscard]] Value of_face(Index i) const {
    const Index f = births_.faces.empty() ? i : births_.faces[i];
    return apply_row(RuleKind::face, mesh_.face_begin(f), false,
                     tables_.row(RuleKind::face, mesh_.degree(f)));
  }

  [[nodiscard]] Value of_corner(Index h) const {
    return apply_row(RuleKind::corner, h, false,
                     tables_.row(RuleKind::corner, mesh_.degree(mesh_.face(h))));
  }

  [[nodiscard]] Value of_vertex(Index v) const {
    const Index h = mesh_.halfedge_of_vertex(v);
    if (h == kNone) return old_[v];
    const bool boundary = mesh_.is_boundary_vertex(v);
    if (boundary && split_.trisects_boundary && births_.edge_ends.empty()) return old_[v];
    const RuleKind kind = boundary ? RuleKind::boundary_vertex : RuleKind::vertex;
    return apply_row(kind, h, false, tables_.row(kind, mesh_.valence(v)));
  }

  /// The row for the edge seen from an end, where the end is interior and has a case for it.
  [[nodiscard]] const Row<Number>* end_row(Index v) const {
    if (mesh_.is_boundary_vertex(v)) return nullptr;
    const Row<Number>& row = tables_.row(RuleKind::edge_end, mesh_.valence(v));
    return row.program ? &row : nullptr;
  }

  [[nodiscard]] Value of_edge(Index i) const {
    if (!births_.edge_ends.empty()) {
      const Index end = births_.edge_ends[i];
      return apply_row(RuleKind::boundary_edge_end, end / 2, end % 2 != 0,
                       tables_.row(RuleKind::boundary_edge_end, 0));
    }
    const Index h = mesh_.halfedge_of_edge(i);
    if (mesh_.twin(h) == kNone)
      return apply_row(RuleKind::boundary_edge, h, false, tables_.row(RuleKind::boundary_edge, 0));
    if (ends_) {
      const bool found = !end_rows_.empty();
      const Row<Number>* from = found ? end_rows_[mesh_.origin(h)] : end_row(mesh_.origin(h));
      const Row<Number>* to = found ? end_rows_[mesh_.target(h)] : end_row(mesh_.target(h));
      if (from != nullptr && to != nullptr) {  // both ends claim it: the mean
        Value sum{};
        const Number half = Arithmetic<Number>::from(Rational(1, 2));
        add_scaled(sum, half, apply_row(RuleKind::edge_end, h, false, *from));
        add_scaled(sum, half, apply_row(RuleKind::edge_end, mesh_.twin(h), false, *to));
        return sum;
      }
      if (from != nullptr) return apply_row(RuleKind::edge_end, h, false, *from);
      if (to != nullptr) return apply_row(RuleKind::edge_end, mesh_.twin(h), false, *to);
    }
    return apply_row(RuleKind::edge, h, false, tables_.row(RuleKind::edge, 0));
  }

  const Split& split_;
  bool ends_;
  const Mesh& mesh_;
  const Births& births_;
  const RuleTables<Number>& tables_;
  const std::vector<Value>& old_;
  Index faces_at_, corners_at_, isolated_at_;
  std::vector<Value> fresh_;
  std::vector<const Row<Number>*> end_rows_;  // of each old vertex, or empty
};

}  // namespace detail

/// The values at the refined mesh's vertices, in the order of `births`. `old` has one value per
/// vertex of `mesh`; `tables` has been prepared for `mesh` and `births`. Every value is
/// summed by one thread in a fixed order, so one thread and many give the same bits.
/// Value needs a default (zero) and `add_scaled`. Cost O(size of the refined mesh).
template <class Number, class Value>
[[nodiscard]] std::vector<Value> refine_values(const Scheme& scheme, const Mesh& mesh,
                                               const Births& births,
                                               const RuleTables<Number>& tables,
                                               const std::vector<Value>& old) {
  return detail::ValueStep<Number, Value>(scheme, mesh, births, tables, old).run();
}

/// The same at the new vertices of a list alone, on this thread. Cost O(length of the list), and of
/// all faces where these have rules.
template <class Number, class Value>
[[nodiscard]] std::vector<Value> refine_values_at(const Scheme& scheme, const Mesh& mesh,
                                                  const Births& births,
                                                  const RuleTables<Number>& tables,
                                                  const std::vector<Value>& old,
                                                  const std::vector<Index>& wanted) {
  return detail::ValueStep<Number, Value>(scheme, mesh, births, tables, old).run_at(wanted);
}

}  // namespace limn
