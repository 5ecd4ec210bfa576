#include "limn/refine/refine_columns.h"

#include <numeric>
#include <utility>

#include "limn/mesh/index.h"
#include "limn/mesh/split/heritage.h"

namespace limn::refine {
namespace {

using mesh::at;

Point3 mix(Point3 a, Point3 b, double part) { return (1 - part) * a + part * b; }

/// The linear values of one step.
class LinearStep {
 public:
  LinearStep(const Split& split, const Mesh& mesh, const Births& births, const Column& old)
      : mesh_(mesh), births_(births), old_(old), to_middle_(split.is_dual() ? 1.0 / 2 : 2.0 / 3) {}

  [[nodiscard]] Index count() const {
    return births_.from_vertices + births_.from_edges + births_.from_faces + births_.from_corners +
           static_cast<Index>(births_.isolated.size());
  }
  [[nodiscard]] Point3 value(Index i) const {
    if (i < births_.from_vertices) return old_[at(i)];
    i -= births_.from_vertices;
    if (i < births_.from_edges) return on_edge(edge_child(mesh_, births_, i));
    i -= births_.from_edges;
    if (i < births_.from_faces) return middle(births_.faces.empty() ? i : births_.faces[at(i)]);
    i -= births_.from_faces;
    if (i < births_.from_corners)
      return mix(old_[at(mesh_.origin(i))], middle(mesh_.face(i)), to_middle_);
    return old_[at(births_.isolated[at(i - births_.from_corners)])];
  }

 private:
  [[nodiscard]] Point3 on_edge(const EdgeChild& child) const {
    const Point3 a = old_[at(mesh_.origin(child.halfedge))];
    const Point3 b = old_[at(mesh_.target(child.halfedge))];
    if (!child.third) return mix(a, b, 1.0 / 2);
    return child.at_target ? mix(b, a, 1.0 / 3) : mix(a, b, 1.0 / 3);
  }
  [[nodiscard]] Point3 middle(Index f) const {
    Point3 sum;
    for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
      sum = sum + old_[at(mesh_.origin(h))];
    return (1.0 / mesh_.degree(f)) * sum;
  }

  const Mesh& mesh_;
  const Births& births_;
  const Column& old_;
  double to_middle_;  // of a vertex that is born from a corner, how far it lies on the way
};

/// Gives the new vertices on the boundary what lies there linearly.
void straighten(const Split& split, const Mesh& mesh, const Births& births, const Column& old,
                Column& fine) {
  const LinearStep linear(split, mesh, births, old);
  for (Index v = 0; v < births.from_vertices; ++v)
    if (mesh.is_boundary_vertex(v)) fine[at(v)] = old[at(v)];
  for (Index i = 0; i < births.from_edges; ++i)
    if (mesh.twin(edge_child(mesh, births, i).halfedge) == kNone)
      fine[at(births.from_vertices + i)] = linear.value(births.from_vertices + i);
}

/// One step: what has been refined, and what makes it finer.
class ColumnStep {
 public:
  ColumnStep(const Scheme& scheme, RefinedColumns& state, const ColumnOptions& options)
      : scheme_(scheme), state_(state), options_(options) {}

  Status run(int step, RuleTables<double>& tables) {
    std::vector<Column>& smooth = state_.columns.smooth;
    return make_step(scheme_, state_.mesh, state_.sharpness, step,
                     smooth.empty() ? nullptr : &tables,
                     [&](SplitResult& fine, Sharpness& left, const auto& values_of) {
                       for (Column& column : smooth)
                         replace(column, fine.births, values_of(column));
                       finish(std::move(fine), std::move(left));
                     });
  }

 private:
  void replace(Column& column, const Births& births, Column fine) const {
    if (options_.straight_boundary) straighten(*scheme_.split, state_.mesh, births, column, fine);
    column = std::move(fine);
  }

  /// What does not depend on rules, and the step from the old mesh to the new one.
  void finish(SplitResult fine, Sharpness left) {
    for (Column& column : state_.columns.linear)
      column = linear_step(*scheme_.split, state_.mesh, fine.births, column);
    if (options_.parents) {
      std::vector<Index> parents = mesh::parent_faces(*scheme_.split, state_.mesh, fine);
      for (Index& parent : parents)
        if (parent != kNone) parent = state_.face_of[at(parent)];
      state_.face_of = std::move(parents);
    }
    state_.mesh = std::move(fine.mesh);
    state_.sharpness = std::move(left);
  }

  const Scheme& scheme_;
  RefinedColumns& state_;
  const ColumnOptions& options_;
};

}  // namespace

Column linear_step(const Split& split, const Mesh& mesh, const Births& births, const Column& old) {
  const LinearStep step(split, mesh, births, old);
  Column fine(at(step.count()));
  base::parallel_for(Index{0}, step.count(), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) fine[at(i)] = step.value(i);
  });
  return fine;
}

Result<RefinedColumns> refine_columns(const Scheme& scheme, Mesh mesh, Columns columns,
                                      Sharpness sharpness, int levels,
                                      const ColumnOptions& options) {
  if (Status takes = check_takes_sharpness(scheme, sharpness); !takes) return takes.error();
  const std::size_t bytes = sizeof(Point3) * (columns.smooth.size() + columns.linear.size());
  if (Status refinable = check_refinable(scheme, mesh, levels, bytes, base::available_memory());
      !refinable)
    return refinable.error();
  RuleTables<double> tables(scheme);
  RefinedColumns state{std::move(mesh), std::move(columns), std::move(sharpness), {}};
  if (options.parents) {
    state.face_of.resize(at(state.mesh.face_count()));
    std::iota(state.face_of.begin(), state.face_of.end(), 0);
  }
  for (int step = 0; step < levels; ++step) {
    if (Status status = ColumnStep(scheme, state, options).run(step, tables); !status)
      return status.error();
    if (options.progress) options.progress(step + 1, levels, state.mesh);
  }
  return state;
}

}  // namespace limn::refine
