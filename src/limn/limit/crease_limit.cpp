#include "limn/limit/crease_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "limn/base/parallel.h"
#include "limn/mesh/sharpness/cut_mesh.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

constexpr int kMostSteps = 160;
constexpr int kRestingSteps = 4;  // so many in which a point does not move by more than rounding

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// A part of a mesh: the surroundings of one vertex, its number 0.
struct Part {
  Mesh mesh;
  std::vector<Point3> values;
  Sharpness sharpness;
};

/// Cuts out the faces within some rings of vertex `centre`. Where they meet in a vertex only, each
/// fan gets a copy of it. Cost O(size of the part).
class Cutter {
 public:
  Cutter(const Mesh& mesh, const std::vector<Point3>& values, const Sharpness& sharpness)
      : mesh_(mesh), values_(values), sharpness_(sharpness) {}

  Part run(Index centre, int rings) {
    find_faces(centre, rings);
    arrays_.face_begin.push_back(0);
    for (const Index f : faces_) {
      first_[f] = arrays_.face_begin.back();
      arrays_.face_begin.push_back(arrays_.face_begin.back() + mesh_.degree(f));
    }
    vertex_.assign(at(arrays_.face_begin.back()), kNone);
    name_fan(mesh_.halfedge_of_vertex(centre));  // so that it is number 0
    for (const Index f : faces_)
      for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h) add(h);
    part_.mesh = Mesh::from_arrays(std::move(arrays_));
    return std::move(part_);
  }

 private:
  void find_faces(Index centre, int rings) {
    std::vector<Index> reached{centre}, next;
    std::unordered_map<Index, bool> seen{{centre, true}};
    for (int ring = 0; ring < rings; ++ring) {
      for (const Index v : reached) visit_fan(v, seen, next);
      reached = std::exchange(next, {});
    }
  }
  void visit_fan(Index v, std::unordered_map<Index, bool>& seen, std::vector<Index>& next) {
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

  [[nodiscard]] Index number(Index h) const {
    const Index f = mesh_.face(h);
    return first_.at(f) + (h - mesh_.face_begin(f));
  }
  /// The other side, where that is in the part.
  [[nodiscard]] Index twin(Index h) const {
    const Index t = mesh_.twin(h);
    return t != kNone && first_.count(mesh_.face(t)) != 0 ? t : kNone;
  }

  /// A vertex for all corners of the fan that h is in.
  void name_fan(Index h) {
    const Index v = mesh_.origin(h), name = arrays_.vertex_count++;
    part_.values.push_back(values_[at(v)]);
    if (!sharpness_.vertices.empty())
      part_.sharpness.vertices.push_back(sharpness_.vertices[at(v)]);
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

  void add(Index h) {
    if (vertex_[at(number(h))] == kNone) name_fan(h);
    arrays_.origin.push_back(vertex_[at(number(h))]);
    const Index t = twin(h);
    arrays_.twin.push_back(t == kNone ? kNone : number(t));
    const bool second = t != kNone && number(t) < number(h);
    arrays_.edge.push_back(second ? arrays_.edge[at(number(t))] : arrays_.edge_count++);
    if (!second && !sharpness_.edges.empty())
      part_.sharpness.edges.push_back(sharpness_.edges[at(mesh_.edge(h))]);
  }

  const Mesh& mesh_;
  const std::vector<Point3>& values_;
  const Sharpness& sharpness_;
  std::vector<Index> faces_;
  std::unordered_map<Index, Index> first_;  // of each face of the part, its first half-edge there
  std::vector<Index> vertex_;               // of each half-edge of the part
  Mesh::Arrays arrays_;
  Part part_;
};

Part cut_out(const Part& part, Index centre, int rings) {
  return Cutter(part.mesh, part.values, part.sharpness).run(centre, rings);
}

double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// How far a scheme's rules read from their anchor, in edges, at most.
int reach_of(const Scheme& scheme) {
  std::ptrdiff_t reach = 1;
  for (const std::optional<Rule>& rule : scheme.rules) {
    if (!rule) continue;
    for (const RuleCase& one : *rule)
      for (const Weight& weight : one.weights) {
        const auto moves = [](const Moves& walk) {
          return std::count(walk.begin(), walk.end(), Move::vertex);
        };
        reach = std::max(reach, moves(weight.walk.before) + moves(weight.walk.after) +
                                    (weight.walk.reads_face ? 1 : 0));
      }
  }
  return static_cast<int>(reach);
}

/// Whether a smooth rule crosses edges but round its own vertex, so that the limit near a corner or
/// dart depends on the rule there.
bool goes_far(const Scheme& scheme) {
  for (const RuleKind kind : {RuleKind::vertex, RuleKind::edge, RuleKind::face}) {
    if (!scheme.rule(kind)) continue;
    for (const RuleCase& one : *scheme.rule(kind))
      for (const Weight& weight : one.weights)
        if (!weight.walk.repeated &&
            std::count(weight.walk.before.begin(), weight.walk.before.end(), Move::face) > 0)
          return true;
  }
  return false;
}

class CreaseLimit {
 public:
  CreaseLimit(const Scheme& scheme, const Mesh& mesh, const std::vector<Point3>& values,
              const Sharpness& sharpness, const LimitOptions& options)
      : scheme_(scheme),
        mesh_(mesh),
        values_(values),
        sharpness_(sharpness),
        options_(options),
        rings_(3 * reach_of(scheme) + 2) {}

  Result<LimitPoints> run() {
    classify();
    if (Status status = find_on_cut(); !status) return status.error();
    if (Status status = refine_round(local_); !status) return status.error();
    return std::move(result_);
  }

 private:
  using Kind = CreaseStep::Rule;

  void classify() {
    std::vector<Index> count(at(mesh_.vertex_count()), 0);
    along_.resize(at(mesh_.edge_count()));
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      along_[at(e)] = sharpness_of_edge(mesh_, sharpness_, e) > 0;
      if (!along_[at(e)]) continue;
      ++count[at(mesh_.origin(mesh_.halfedge_of_edge(e)))];
      ++count[at(mesh_.target(mesh_.halfedge_of_edge(e)))];
    }
    const bool far = goes_far(scheme_);
    std::vector<Index> near;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const double own = sharpness_.vertices.empty() ? 0 : sharpness_.vertices[at(v)];
      kinds_.push_back(CreaseStep::rule_of(own, count[at(v)]));
      if (kinds_.back() == Kind::dart || (far && kinds_.back() == Kind::corner)) near.push_back(v);
      if (kinds_.back() == Kind::dart) local_.push_back(v);
    }
    if (far) widen(near);
    for (const Kind kind : kinds_)
      has_normal_.push_back(kind == Kind::smooth || kind == Kind::crease);
    for (const Index v : local_) has_normal_[at(v)] = false;
  }

  /// All within so many rings of these, corners but for.
  void widen(std::vector<Index> near) {
    std::vector<bool> taken(at(mesh_.vertex_count()), false);
    for (const Index v : near) taken[at(v)] = true;
    for (int ring = 0; ring < rings_; ++ring) {
      std::vector<Index> next;
      for (const Index v : near) {
        const Index first = mesh_.halfedge_of_vertex(v);
        for (Index h = first; h != kNone;) {
          for (Index g = mesh_.next(h); g != h; g = mesh_.next(g)) {
            if (taken[at(mesh_.origin(g))]) continue;
            taken[at(mesh_.origin(g))] = true;
            next.push_back(mesh_.origin(g));
          }
          h = mesh_.rotate(h);
          if (h == first) break;
        }
      }
      near = std::move(next);
    }
    local_.clear();
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (taken[at(v)] && kinds_[at(v)] != Kind::corner) local_.push_back(v);
  }

  /// Smooth vertices and those on creases have the limits of the mesh that is cut there.
  Status find_on_cut() {
    const CutMesh cut = cut_along(mesh_, along_);
    std::vector<Point3> values;
    values.reserve(cut.originals.size());
    for (const Index v : cut.originals) values.push_back(values_[at(v)]);
    LimitOptions all = options_;  // copies have numbers of their own
    all.vertices.clear();
    Result<LimitPoints> found = approx_limit_points(scheme_, cut.mesh, values, all);
    if (!found) return found.error();
    std::vector<Index> copies(kinds_.size(), 0);
    for (const Index v : cut.originals) ++copies[at(v)];
    const bool curvatures = !found->curvatures.empty();
    result_.positions.resize(kinds_.size());
    result_.normals.resize(kinds_.size());
    if (curvatures) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      result_.curvatures.assign(kinds_.size(), {nan, nan});
      result_.no_curvature.assign(kinds_.size(), NoCurvature::no_normal);
    }
    for (std::size_t copy = 0; copy < cut.originals.size(); ++copy) {
      const std::size_t v = at(cut.originals[copy]);
      result_.positions[v] = result_.positions[v] + (1.0 / copies[v]) * found->positions[copy];
      if (copies[v] > 1 || !has_normal_[v]) continue;
      result_.normals[v] = found->normals[copy];
      if (!curvatures) continue;
      result_.curvatures[v] = found->curvatures[copy];
      result_.no_curvature[v] = found->no_curvature[copy];
    }
    for (std::size_t v = 0; v < kinds_.size(); ++v)
      if (kinds_[v] == Kind::corner) result_.positions[v] = values_[v];
    for (LimitPoints::Refused& gap : found->refused) {
      gap.vertex = cut.originals[at(gap.vertex)];
      const Kind kind = kinds_[at(gap.vertex)];
      const bool known = kind == Kind::dart || kind == Kind::corner;
      if (!known) result_.refused.push_back(std::move(gap));
    }
    using Refused = LimitPoints::Refused;
    const auto before = [](const Refused& a, const Refused& b) { return a.vertex < b.vertex; };
    const auto same = [](const Refused& a, const Refused& b) { return a.vertex == b.vertex; };
    std::stable_sort(result_.refused.begin(), result_.refused.end(), before);
    result_.refused.erase(std::unique(result_.refused.begin(), result_.refused.end(), same),
                          result_.refused.end());
    return Done{};
  }

  Status refine_round(const std::vector<Index>& vertices) {
    std::vector<Status> done(vertices.size(), Done{});
    const auto refine_some = [&](Index first, Index last) {
      for (Index i = first; i < last; ++i) done[at(i)] = refine_round(vertices[at(i)]);
    };
    parallel_for(Index{0}, static_cast<Index>(vertices.size()), refine_some, 1);
    for (Status& status : done)
      if (!status) return status;
    return Done{};
  }

  /// Until the point rests, or nearly: its steps shrink by a factor each.
  Status refine_round(Index v) {
    RuleTables<double> tables(scheme_);
    Part part = Cutter(mesh_, values_, sharpness_).run(v, rings_);
    double size = 0;
    for (const Point3& p : part.values) size = std::max(size, distance(p, {}));
    int resting = 0;
    for (int step = 0; step < kMostSteps && resting < kRestingSteps; ++step) {
      Result<Refined<Point3>> fine = refine_once(scheme_, part.mesh, part.values, part.sharpness,
                                                 options_.steps_made + step, tables);
      if (!fine) return fine.error();
      const bool rests = distance(fine->values[0], part.values[0]) <=
                         std::numeric_limits<double>::epsilon() * size;
      resting = rests ? resting + 1 : 0;
      part = cut_out({std::move(fine->mesh), std::move(fine->values), std::move(fine->sharpness)},
                     0, rings_);
    }
    result_.positions[at(v)] = part.values[0];
    if (resting < kRestingSteps) return Error{"the limit at a vertex is not reached"};
    return Done{};
  }

  const Scheme& scheme_;
  const Mesh& mesh_;
  const std::vector<Point3>& values_;
  const Sharpness& sharpness_;
  const LimitOptions& options_;
  int rings_;
  std::vector<bool> along_;  // the sharp edges
  std::vector<Kind> kinds_;
  std::vector<bool> has_normal_;
  std::vector<Index> local_;  // the vertices whose neighbourhoods are refined
  LimitPoints result_;
};

}  // namespace

Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Point3>& values,
                                        const Sharpness& sharpness, const LimitOptions& options) {
  if (!sharpness.any()) return approx_limit_points(scheme, mesh, values, options);
  return CreaseLimit(scheme, mesh, values, sharpness, options).run();
}

}  // namespace limn
