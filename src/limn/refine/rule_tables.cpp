#include "limn/refine/rule_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "limn/mesh/rings.h"
#include "limn/refine/weight_form.h"
#include "limn/scheme/scope.h"

namespace limn::refine {
namespace {

constexpr double kSumTolerance = 1e-9;

/// Needed at the vertex or the face `example`.
Error at_element(Error error, RuleKind kind, Index example) {
  const bool of_face = kind == RuleKind::face || kind == RuleKind::corner;
  if (rule_has_valence(kind))
    error.message += fmt::format(", needed at {} {}", of_face ? "face" : "vertex", example);
  return error;
}

/// A flag as a half-edge some hops away from where it began.
struct HopFlag {
  std::vector<Hop> hops;
  bool at_target = false;
};

/// How the anchor's flag number `flag` is reached from the half-edge that names the anchor; the
/// same order as anchor_flags. Nothing for flags that are not a fixed number of hops away.
std::optional<HopFlag> flag_hops(RuleKind kind, int flag) {
  switch (kind) {
    case RuleKind::vertex:
    case RuleKind::face_end:
    case RuleKind::corner:
      if (flag == 0) return HopFlag{{}, false};
      return HopFlag{{Hop::prev}, true};
    case RuleKind::face:
    case RuleKind::boundary_edge: return HopFlag{{}, flag == 1};
    case RuleKind::edge:
    case RuleKind::edge_side:
      if (flag < 2) return HopFlag{{}, flag == 1};
      return HopFlag{{Hop::twin}, flag == 3};
    case RuleKind::edge_end:
    case RuleKind::edge_third:
      if (flag == 0) return HopFlag{{}, false};
      return HopFlag{{Hop::twin}, true};
    case RuleKind::boundary_vertex:
    case RuleKind::boundary_edge_end:
    case RuleKind::boundary_spoke: break;
  }
  return std::nullopt;
}

void append_hop(std::vector<Hop>& hops, Hop hop) {
  const bool undone = !hops.empty() && ((hop == Hop::next && hops.back() == Hop::prev) ||
                                        (hop == Hop::prev && hops.back() == Hop::next));
  if (undone)
    hops.pop_back();
  else
    hops.push_back(hop);
}

/// Adds the hops of these moves; false where they are not a fixed number.
bool append_moves(const Moves& moves, HopFlag& flag) {
  for (const Move move : moves) {
    if (move == Move::boundary) return false;
    if (move == Move::edge) append_hop(flag.hops, flag.at_target ? Hop::next : Hop::prev);
    if (move == Move::face) flag.hops.push_back(Hop::twin);
    flag.at_target = !flag.at_target;
  }
  return true;
}

/// Goes to where the flag's vertex is the half-edge's origin.
void end_at_origin(HopFlag& flag) {
  if (flag.at_target) append_hop(flag.hops, Hop::next);
  flag.at_target = false;
}

/// False where the hops are too many.
bool store(const std::vector<Hop>& hops, Way& way) {
  if (hops.size() > way.hops.size()) return false;
  std::copy(hops.begin(), hops.end(), way.hops.begin());
  way.count = static_cast<std::uint8_t>(hops.size());
  return true;
}

/// Fills in the step's hops, where its walk is one of hops alone.
void make_direct(Step& step, RuleKind kind) {
  using Turning = Step::Turning;
  std::optional<HopFlag> start = flag_hops(kind, step.flag);
  if (!start || step.walk.reads_face || !append_moves(step.walk.before, *start)) return;
  if (!step.walk.repeated) {
    end_at_origin(*start);
    step.direct = store(start->hops, step.way);
    return;
  }
  HopFlag turn{{}, start->at_target}, out = turn;
  if (!append_moves(step.walk.step, turn) || !append_moves(step.walk.after, out)) return;
  end_at_origin(out);
  step.direct = turn.at_target == start->at_target && store(start->hops, step.way) &&
                store(turn.hops, step.turn) && store(out.hops, step.out);
  if (!step.direct || start->at_target) return;
  if (turn.hops == std::vector{Hop::prev, Hop::twin}) step.turning = Turning::counterclockwise;
  if (turn.hops == std::vector{Hop::twin, Hop::next}) step.turning = Turning::clockwise;
}

/// Steps go on from where earlier ones ended, as far as these lead the same way.
void share_hops(Program& program) {
  std::vector<std::vector<Hop>> ways;  // of the ends that are kept
  for (Step& step : program) {
    if (!step.direct || step.per_sector || step.walk.repeated) continue;
    const std::vector<Hop> way(step.way.hops.begin(), step.way.hops.begin() + step.way.count);
    std::size_t shared = 0;
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (ways[i].size() > shared && ways[i].size() <= way.size() &&
          std::equal(ways[i].begin(), ways[i].end(), way.begin())) {
        shared = ways[i].size();
        step.after = static_cast<int>(i);
      }
    (void)store({way.begin() + static_cast<std::ptrdiff_t>(shared), way.end()}, step.way);
    if (ways.size() == kSharedSteps) continue;
    step.kept = static_cast<int>(ways.size());
    ways.push_back(way);
  }
}

}  // namespace

Program compile(const RuleCase& rule_case, RuleKind kind, Lattice lattice) {
  Program program;
  for (const Weight& weight : rule_case.weights) {
    // the reader has refused roles that cannot be placed
    const scheme::Placement placement = scheme::place(kind, lattice, weight.walk).value();
    for (const scheme::Start& start : placement.starts) {
      Step step;
      step.walk = weight.walk;
      step.flag = start.flag;
      step.per_sector = placement.per_sector;
      step.extension = start.extension;
      step.share = start.share;
      step.weight = &weight;
      make_direct(step, kind);
      program.push_back(std::move(step));
    }
  }
  share_hops(program);
  return program;
}

namespace {

/// Those that were not decided when the file was read.
Status check_late(const Scheme& scheme, RuleKind kind, int n, std::optional<int> quads = {}) {
  const bool checked_on_reading =
      n >= scheme::kSmallestValence && n <= scheme::kLargestCheckedValence;
  if (checked_on_reading || n > kLargestExactValence) return Done{};
  return scheme::check_rule(scheme, kind, n, quads);
}

/// A row of a scheme of stages.
template <class Number>
Result<Row<Number>> stage_row(const Scheme& scheme, RuleKind kind, int n,
                              std::optional<int> quads) {
  Row<Number> row;
  scheme::Scope<Number> scope(scheme, n, std::nullopt);
  if (quads)
    scope.give(std::string(scheme::kQuads), number::Arithmetic<Number>::from(Rational(*quads)));
  if (kind == RuleKind::face) {
    Result<Number> value = scope(scheme.stages->corner.value);
    if (!value) return value.error();
    row.weights.push_back(std::move(*value));
  }
  if (kind != RuleKind::vertex) return row;  // it has no others
  const Result<const RuleCase*> pair = scheme::applicable_case(scheme, kind, n, quads);
  if (!pair) return pair.error();
  if (*pair == nullptr) return scheme::missing_rule(scheme, kind, n, quads);
  if (Status status = check_late(scheme, kind, n, quads); !status) return status.error();
  row.weights.assign(kPairRoles.size(), Number(0));
  for (const Weight& weight : (*pair)->weights) {
    Result<Number> value = scope(weight.value);
    if (!value) return value.error();
    row.weights[static_cast<std::size_t>(pair_role(weight))] = std::move(*value);
  }
  return row;
}

}  // namespace

template <class Number>
Result<Row<Number>> tabulate_row(const Scheme& scheme, RuleKind kind, int n,
                                 std::optional<int> quads) {
  if (scheme.stages) return stage_row<Number>(scheme, kind, n, quads);
  const Result<const RuleCase*> rule_case = scheme::applicable_case(scheme, kind, n);
  if (!rule_case) return rule_case.error();
  Row<Number> row;
  if (*rule_case == nullptr) {
    if (stands_in_for(kind, *scheme.split)) return row;
    return scheme::missing_rule(scheme, kind, n);
  }
  if (Status status = check_late(scheme, kind, n); !status) return status.error();
  auto program = std::make_shared<Program>(compile(**rule_case, kind, scheme.split->lattice));
  std::optional<long long> valence;
  if (rule_has_valence(kind)) valence = n;
  double sum = 0;
  for (const Step& step : *program) {
    const int repeats = step.walk.repeated ? n : 1;
    for (int k = 0; k < repeats; ++k) {
      scheme::Scope<Number> scope(scheme, valence,
                                  step.walk.repeated ? std::optional<long long>(k) : std::nullopt);
      Result<Number> value = scope(step.weight->value);
      if (!value) return value.error();
      row.weights.push_back(number::Arithmetic<Number>::from(step.share) * *value);
      sum += number::Arithmetic<Number>::approx(row.weights.back()) * (step.per_sector ? n : 1);
    }
  }
  if (!(std::abs(sum - 1) < kSumTolerance))
    return Error{fmt::format("the {} rule has weights that sum to about {} at n = {}",
                             rule_name(kind), sum, n),
                 {},
                 scheme.file,
                 0,
                 0};
  row.program = std::move(program);
  return row;
}

template <class Number>
Status RuleTables<Number>::add(RuleKind kind, Index n, Index example) {
  if (boundary_ == Boundary::left_out && kind >= RuleKind::boundary_vertex) return Done{};
  const auto i = static_cast<std::size_t>(kind);
  const auto at = static_cast<std::size_t>(rule_has_valence(kind) ? n : 0);
  if (known_[i].size() <= at) {
    known_[i].resize(at + 1);
    rows_[i].resize(at + 1);
  }
  if (known_[i][at]) return Done{};
  Result<Row<Number>> row = make_row_(kind, n, std::nullopt);
  if (!row) return at_element(row.error(), kind, example);
  rows_[i][at] = std::move(*row);
  known_[i][at] = true;
  return Done{};
}

template <class Number>
Status RuleTables<Number>::prepare_vertices(const Mesh& mesh, bool boundary_refined) {
  const std::vector<Index> counted = mesh::valences(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_isolated(v)) continue;
    const bool boundary = mesh.is_boundary_vertex(v);
    if (boundary && !boundary_refined) continue;
    const Index n = counted[v];
    const RuleKind kind = boundary ? RuleKind::boundary_vertex : RuleKind::vertex;
    if (Status status = add(kind, n, v); !status) return status;
    if (Status status = add_seen_from(boundary, n, v); !status) return status;
  }
  return Done{};
}

template <class Number>
Status RuleTables<Number>::add_seen_from(bool boundary, Index n, Index example) {
  constexpr std::array inside{RuleKind::edge_end, RuleKind::face_end};
  constexpr std::array outside{RuleKind::boundary_spoke, RuleKind::boundary_edge_end};
  for (const RuleKind kind : boundary ? outside : inside) {
    if (!scheme_->rule(kind) || !stands_in_for(kind, *scheme_->split)) continue;
    if (kind == RuleKind::boundary_spoke && n < scheme::kSmallestValence)
      continue;  // it has no spoke
    if (Status status = add(kind, n, example); !status) return status;
  }
  return Done{};
}

template <class Number>
Status RuleTables<Number>::prepare_faces(const Mesh& mesh, RuleKind kind) {
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (Status status = add(kind, mesh.degree(f), f); !status) return status;
  return Done{};
}

template <class Number>
Status RuleTables<Number>::prepare_edges(const Mesh& mesh, const Births& births) {
  if (births.from_edges == 0) return Done{};
  const auto add_thirds = [&](Index v) {
    return add(RuleKind::boundary_edge_end, mesh.valence(v), v);
  };
  if (!births.edge_ends.empty()) {
    for (const Index end : births.edge_ends)
      if (Status status = add_thirds(end % 2 == 0 ? mesh.origin(end / 2) : mesh.target(end / 2));
          !status)
        return status;
    return Done{};
  }
  if (!scheme_->split->births.edges) return add(RuleKind::boundary_edge, 0, 0);
  bool interior = false;
  bool boundary = false;
  for (Index e = 0; e < mesh.edge_count() && !(interior && boundary); ++e)
    (mesh.is_boundary_edge(e) ? boundary : interior) = true;
  if (interior)
    if (Status status = add(births.thirds ? RuleKind::edge_third : RuleKind::edge, 0, 0); !status)
      return status;
  if (interior && scheme_->rule(RuleKind::edge_side))
    if (Status status = prepare_faces(mesh, RuleKind::edge_side); !status) return status;
  if (!boundary) return Done{};
  if (!births.thirds) return add(RuleKind::boundary_edge, 0, 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v))
      if (Status status = add_thirds(v); !status) return status;
  return Done{};
}

/// `example` is a vertex of the stages' mesh.
template <class Number>
Status RuleTables<Number>::add_pair(detail::StagedMesh::Star star, const Mesh& mesh,
                                    Index example) {
  const auto n = static_cast<std::size_t>(star.edges), q = static_cast<std::size_t>(star.quads);
  if (pairs_.size() <= n) pairs_.resize(n + 1);
  if (pairs_[n].size() <= q) pairs_[n].resize(q + 1);
  PairRow& pair = pairs_[n][q];
  if (pair.known) return Done{};
  const std::optional<int> quads =
      scheme_->split->mixed ? std::optional<int>(star.quads) : std::nullopt;
  Result<Row<Number>> row = make_row_(RuleKind::vertex, star.edges, quads);
  if (!row)
    return example < mesh.vertex_count() ? at_element(row.error(), RuleKind::vertex, example)
                                         : row.error();
  pair = {std::move(*row), true};
  return Done{};
}

template <class Number>
Status RuleTables<Number>::prepare_stages(const Mesh& mesh, const Births& births) {
  if (Status status = prepare_faces(mesh, RuleKind::face); !status) return status;
  if (scheme_->stages->count < 2) return Done{};
  const detail::StagedMesh cut(*scheme_->stages, mesh, births);
  for (Index i = 0; i < cut.vertex_count(); ++i) {
    if (cut.is_isolated(i) || cut.is_on_boundary(i)) continue;
    if (Status status = add_pair(cut.star(i), mesh, i); !status) return status;
  }
  return Done{};
}

template <class Number>
Status RuleTables<Number>::prepare(const Mesh& mesh, const Births& births) {
  if (scheme_->stages) return prepare_stages(mesh, births);
  const Split& split = *scheme_->split;
  const bool boundary_refined = !split.boundary_rests() || births.from_edges > 0;
  if (split.births.vertices)
    if (Status status = prepare_vertices(mesh, boundary_refined); !status) return status;
  if (split.births.faces)
    if (Status status = prepare_faces(mesh, RuleKind::face); !status) return status;
  if (split.births.corners)
    if (Status status = prepare_faces(mesh, RuleKind::corner); !status) return status;
  return prepare_edges(mesh, births);
}

template Result<Row<double>> tabulate_row<double>(const Scheme&, RuleKind, int, std::optional<int>);
template Result<Row<number::Exact>> tabulate_row<number::Exact>(const Scheme&, RuleKind, int,
                                                                std::optional<int>);
template class RuleTables<double>;
template class RuleTables<number::Exact>;
template Status RuleTables<WeightForm>::prepare(const Mesh&, const Births&);

}  // namespace limn::refine
