#include "limn/refine/crease_step.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <fmt/core.h>

#include "limn/mesh/index.h"

namespace limn::refine {
namespace {

using mesh::at;

std::array<Index, 2> ends_of(const Mesh& mesh, Index e) {
  const Index h = mesh.halfedge_of_edge(e);
  return {mesh.origin(h), mesh.target(h)};
}

}  // namespace

Status check_takes_sharpness(const Scheme& scheme, const Sharpness& sharpness) {
  const Split& split = *scheme.split;
  const bool sharp = sharpness.any();
  if (!sharp && !sharpness.has_holes()) return Done{};
  const std::string what = sharp ? "sharp edges or vertices" : "holes";
  if (!split.births.vertices)
    return Error{fmt::format("{} takes no {}: its split, {}, has no boundary that stays in place",
                             scheme.name, what, split.name),
                 "leave the tags out, or take a scheme that keeps old vertices"};
  if (split.births.thirds)
    return Error{fmt::format("{} takes no {}: its split, {}, cuts edges in three", scheme.name,
                             what, split.name),
                 "leave the tags out, or take a scheme with a dyadic split"};
  if (split.boundary_rests() && sharpness.fades())
    return Error{fmt::format("{} takes infinite sharpness only, {} or more: its split, {}, divides "
                             "a crease in every second step",
                             scheme.name, kInfinitelySharp, split.name),
                 "make what is sharp infinitely sharp, or take a scheme with a dyadic split"};
  if (split.boundary_rests() && sharpness.has_holes())
    return Error{fmt::format("{} takes no holes: the faces of its split, {}, lie across old edges",
                             scheme.name, split.name),
                 "leave the tags out, or take a scheme with a dyadic split"};
  if (!sharp) return Done{};
  if (scheme.stages)
    return Error{fmt::format("{} takes no {}: its step is a sequence of averagings, which go on "
                             "across creases",
                             scheme.name, what),
                 "leave the tags out, or take a scheme of rules, as catmull-clark"};
  std::vector<RuleKind> needed{RuleKind::boundary_vertex};
  if (split.odd_step_cut == 3)
    needed.push_back(RuleKind::boundary_edge_end);
  else
    needed.push_back(RuleKind::boundary_edge);
  for (const RuleKind kind : needed)
    if (!scheme.rule(kind))
      return Error{fmt::format("{} takes no sharp edges or vertices: it has no {} rule",
                               scheme.name, rule_name(kind)),
                   "leave the tags out, or give the scheme that rule", scheme.file, 0, 0};
  return Done{};
}

/// Makes a step.
class CreaseStep::Maker {
 public:
  Maker(const Split& split, const Mesh& mesh, const Sharpness& sharpness, int step)
      : split_(split), mesh_(mesh), sharpness_(sharpness), number_(step) {}

  Result<CreaseStep> run() {
    step_.mesh_ = &mesh_;
    step_.children_ = child_sharpness(mesh_, sharpness_);
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      step_.sharpness_.push_back(sharpness_of_edge(mesh_, sharpness_, e));
    classify();
    find_ending();
    if (Status status = make_now(); !status) return status.error();
    request_afters();
    while (!pending_vertices_.empty() || !pending_edges_.empty()) make_after();
    return std::move(step_);
  }

 private:
  [[nodiscard]] bool is_inside(Index e) const { return !mesh_.is_boundary_edge(e); }
  [[nodiscard]] double sharp(Index e) const { return step_.sharpness_[at(e)]; }
  [[nodiscard]] double child(Index e, std::size_t end) const {
    return step_.children_.edge_ends[2 * at(e) + end];
  }
  /// Whether just one of the edge's children is sharp.
  [[nodiscard]] bool is_mixed(Index e) const { return (child(e, 0) > 0) != (child(e, 1) > 0); }

  /// The rules of all vertices.
  void classify() {
    struct Count {
      Index now = 0, after = 0, ending = 0;
      double sum = 0;  // of what ends
    };
    std::vector<Count> counts(at(mesh_.vertex_count()));
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!(sharp(e) > 0)) continue;
      for (std::size_t end = 0; end < 2; ++end) {
        Count& count = counts[at(ends_of(mesh_, e)[end])];
        ++count.now;
        if (child(e, end) > 0) {
          ++count.after;
        } else {
          ++count.ending;
          count.sum += sharp(e);
        }
      }
    }
    step_.vertices_.resize(counts.size());
    for (std::size_t v = 0; v < counts.size(); ++v) {
      Count& count = counts[v];
      const double own = sharpness_.vertices.empty() ? 0 : sharpness_.vertices[v];
      const double own_child = step_.children_.vertices[v];
      if (own > 0 && !(own_child > 0)) {
        ++count.ending;
        count.sum += own;
      }
      VertexRules& rules = step_.vertices_[v];
      rules.now = rule_of(own, count.now);
      rules.after = rule_of(own_child, count.after);
      if (rules.now > Rule::dart && rules.now != rules.after)
        rules.part = std::min(1.0, count.sum / count.ending);
      step_.darts_ =
          step_.darts_ || rules.now == Rule::dart || (rules.part < 1 && rules.after == Rule::dart);
    }
  }

  /// What smooth rules near edges that end weigh.
  void find_ending() {
    step_.ending_sums_.assign(at(mesh_.vertex_count()), 0);
    step_.ending_counts_.assign(at(mesh_.vertex_count()), 0);
    double sum = 0;
    Index count = 0;
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!(sharp(e) > 0) || child(e, 0) > 0 || child(e, 1) > 0) continue;
      const double part = std::min(1.0, sharp(e));
      sum += part;
      ++count;
      for (const Index v : ends_of(mesh_, e)) {
        step_.ending_sums_[at(v)] += part;
        ++step_.ending_counts_[at(v)];
      }
    }
    if (count > 0) step_.mean_ending_ = sum / count;
  }

  /// A split with a boundary that rests makes of a cut mesh another one than of the whole. Under
  /// all others births tell what it makes.
  [[nodiscard]] View view_of(const std::vector<bool>& along) const {
    View view;
    view.cut = mesh::cut_along(mesh_, along);
    if (split_.boundary_rests()) {
      view.fine = split_.apply(view.cut.mesh, number_);
      return view;
    }
    Births& births = view.fine.births = step_.fine_.births;
    assert(births.edges.empty() && births.faces.empty() && births.isolated.empty());
    births.from_vertices = view.cut.mesh.vertex_count();
    if (births.from_edges > 0) births.from_edges = view.cut.mesh.edge_count();
    return view;
  }

  /// Notes copies of new vertices as they are met.
  class Copies {
   public:
    Copies(View& view, Index vertices, Index copies) : view_(view), seen_(at(copies), false) {
      view.first.assign(at(vertices), kNone);
      view.next.assign(at(copies), kNone);
    }
    void see(Index vertex, Index copy) {
      if (seen_[at(copy)]) return;
      seen_[at(copy)] = true;
      view_.next[at(copy)] = std::exchange(view_.first[at(vertex)], copy);
    }

   private:
    View& view_;
    std::vector<bool> seen_;
  };

  /// Finds the copies of each new vertex: half-edges have the same numbers, cut or not.
  void find_copies(View& view) const {
    const Mesh& whole = step_.fine_.mesh;
    if (!split_.boundary_rests()) return find_births(view);
    Copies copies(view, whole.vertex_count(), view.fine.mesh.vertex_count());
    for (Index g = 0; g < whole.halfedge_count(); ++g)
      copies.see(whole.origin(g), view.fine.mesh.origin(g));
    view.fine.mesh = Mesh();  // it has served
  }
  void find_births(View& view) const {
    const Mesh& cut = view.cut.mesh;
    const Births &whole = step_.fine_.births, &births = view.fine.births;
    const Index faces = whole.from_vertices + whole.from_edges;
    const Index cut_faces = births.from_vertices + births.from_edges;
    const Index more = births.from_faces + births.from_corners;
    Copies copies(view, faces + more, cut_faces + more);
    for (Index h = 0; h < cut.halfedge_count(); ++h) copies.see(mesh_.origin(h), cut.origin(h));
    for (Index h = 0; births.from_edges > 0 && h < cut.halfedge_count(); ++h)
      copies.see(whole.from_vertices + mesh_.edge(h), births.from_vertices + cut.edge(h));
    for (Index i = 0; i < more; ++i) copies.see(faces + i, cut_faces + i);
  }

  Status make_now() {
    std::vector<bool> along(at(mesh_.edge_count()));
    for (Index e = 0; e < mesh_.edge_count(); ++e) along[at(e)] = sharp(e) > 0;
    if (!split_.boundary_rests()) {
      step_.fine_ = split_.apply(mesh_, number_);
      step_.now_ = view_of(along);
      step_.whole_births_ = step_.fine_.births;
      step_.fine_sharpness_ = inherit(mesh_, sharpness_, step_.children_, step_.fine_);
    } else {
      step_.now_ = view_of(along);
      if (step_.darts_) step_.whole_births_ = split_.apply(mesh_, number_).births;
      Result<mesh::JoinedMesh> joined = mesh::join_again(mesh_, step_.now_.cut, step_.now_.fine);
      if (!joined) return joined.error();
      step_.fine_ = std::move(joined->fine);
      step_.fine_sharpness_ = infinite_along(joined->seams);
    }
    find_copies(step_.now_);
    return Done{};
  }

  [[nodiscard]] Sharpness infinite_along(const std::vector<bool>& seams) const {
    Sharpness result;
    result.method = sharpness_.method;
    for (const bool seam : seams) result.edges.push_back(seam ? kInfinitelySharp : 0);
    if (sharpness_.vertices.empty()) return result;
    result.vertices = sharpness_.vertices;
    result.vertices.resize(at(step_.fine_.mesh.vertex_count()), 0);
    return result;
  }

  /// Which rules need a view of the children's sharpness.
  void request_afters() {
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const VertexRules& rules = step_.vertices_[at(v)];
      if (rules.part < 1 && (rules.after == Rule::smooth || rules.after == Rule::crease))
        pending_vertices_.push_back(v);
    }
    if (sharpness_.method == CreaseMethod::chaikin) mixed_at_.resize(at(mesh_.vertex_count()));
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!is_inside(e)) continue;
      if (is_mixed(e)) {
        any_mixed_ = true;
        for (const Index v : ends_of(mesh_, e)) mixed_at_[at(v)].push_back(e);
      }
      if (sharp(e) > 0 && step_.rules_of_edge(e).part != 1) pending_edges_.push_back(e);
    }
    if (any_mixed_) step_.edge_views_.assign(at(mesh_.edge_count()), 0);
  }

  /// One more view, for as many of those that wait for one as agree about its mixed edges. A vertex
  /// wants those cut whose child is sharp at its end, an edge wants itself whole.
  void make_after() {
    enum : std::int8_t { open = -1, whole = 0, cut = 1 };
    std::vector<std::int8_t> wanted(any_mixed_ ? at(mesh_.edge_count()) : 0, open);
    const auto view = static_cast<Index>(step_.afters_.size());
    const auto serve_vertex = [&](Index v) {
      const auto wish = [&](Index e) {
        return child(e, ends_of(mesh_, e)[0] == v ? 0 : 1) > 0 ? cut : whole;
      };
      step_.vertices_[at(v)].view = view;
      if (!any_mixed_) return true;
      const std::vector<Index>& mixed = mixed_at_[at(v)];
      const auto agrees = [&](Index e) {
        return wanted[at(e)] == open || wanted[at(e)] == wish(e);
      };
      if (!std::all_of(mixed.begin(), mixed.end(), agrees)) return false;
      for (const Index e : mixed) wanted[at(e)] = wish(e);
      return true;
    };
    const auto serve_edge = [&](Index e) {
      if (!any_mixed_) return true;
      if (is_mixed(e) && wanted[at(e)] == cut) return false;
      if (is_mixed(e)) wanted[at(e)] = whole;
      step_.edge_views_[at(e)] = view;
      return true;
    };
    std::erase_if(pending_vertices_, serve_vertex);
    std::erase_if(pending_edges_, serve_edge);
    std::vector<bool> along(at(mesh_.edge_count()));
    for (Index e = 0; e < mesh_.edge_count(); ++e)
      along[at(e)] = is_mixed(e) ? wanted[at(e)] == cut : child(e, 0) > 0;
    View made = view_of(along);
    find_copies(made);
    step_.afters_.push_back(std::move(made));
  }

  const Split& split_;
  const Mesh& mesh_;
  const Sharpness& sharpness_;
  int number_;
  CreaseStep step_;
  std::vector<Index> pending_vertices_, pending_edges_;
  std::vector<std::vector<Index>> mixed_at_;  // the mixed edges at each vertex
  bool any_mixed_ = false;
};

Result<CreaseStep> CreaseStep::make(const Split& split, const Mesh& mesh,
                                    const Sharpness& sharpness, int step) {
  return Maker(split, mesh, sharpness, step).run();
}

CreaseStep::EdgeRules CreaseStep::rules_of_edge(Index e) const {
  EdgeRules rules;
  const bool stays = children_.edge_ends[2 * at(e)] > 0 && children_.edge_ends[2 * at(e) + 1] > 0;
  if (!stays) rules.part = sharpness_[at(e)];
  rules.view = edge_views_.empty() ? 0 : edge_views_[at(e)];
  return rules;
}

double CreaseStep::part_near(Index fine_vertex) const {
  double sum = 0;
  Index count = 0;
  const auto add = [&](Index v) {
    sum += ending_sums_[at(v)];
    count += ending_counts_[at(v)];
  };
  const Births& births = fine_.births;
  const Index edge = fine_vertex - births.from_vertices, face = edge - births.from_edges;
  if (edge < 0) {
    const Index first = mesh_->halfedge_of_vertex(fine_vertex);
    Index h = first;
    do {
      add(mesh_->target(h));
      h = mesh_->rotate(h);
    } while (h != first && h != kNone);
  } else if (face < 0) {
    const Index h = edge_child(*mesh_, births, edge).halfedge;
    add(mesh_->origin(h));
    add(mesh_->target(h));
  } else {
    const Index corner = face - births.from_faces;
    const Index f = corner >= 0            ? mesh_->face(corner)
                    : births.faces.empty() ? face
                                           : births.faces[at(face)];
    for (Index h = mesh_->face_begin(f); h < mesh_->face_begin(f + 1); ++h) add(mesh_->origin(h));
  }
  return count > 0 ? sum / count : mean_ending_;
}

}  // namespace limn::refine
