#include "limn/refine/fast/fast_refiner.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>

#include "limn/base/parallel.h"
#include "limn/refine/fast/patch_step.h"
#include "limn/refine/fast/plain_steps.h"
#include "limn/refine/fast/zone_step.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

constexpr Index kFaceChunk = 32768;  // refined faces that one call of a parallel loop writes

/// The most that the arrays of a result and the work on it take.
Status check_room(const fast::TriangleLayout& last, int levels) {
  const double vertices = last.vertex_count(), faces = last.face_count();
  constexpr double kPoint = 3 * sizeof(double);
  constexpr double kScratch = 0.25 * kPoint;
  const double bytes = vertices * (kPoint + kScratch) + faces * 3 * sizeof(Index);
  return check_memory({vertices, faces, bytes}, levels, available_memory());
}

}  // namespace

bool has_fast_layout(const Split& split) {
  // what triangle_layout.h numbers: triangles cut in four at the midpoints of their edges
  return split.lattice == Lattice::triangle && split.births_vertices && split.births_edges &&
         !split.births_faces && split.dilation.growth() == 4;
}

struct FastRefiner::State {
  Mesh control;
  int levels = 0;
  std::optional<fast::PlainSteps> plain;
  fast::StencilTables tables;
  std::vector<fast::ZoneGroup> groups;
  std::vector<Index> boundary;                        ///< half-edges
  std::vector<fast::TriangleLayout> layouts;          ///< of levels plain->count() … levels
  std::vector<std::vector<fast::ZoneNumbers>> zones;  ///< of the steps between them, by group

  Status prepare(const Scheme& scheme);
  void prepare_zones();

  template <class Real>
  void step(std::size_t i, const Real* in, Real* out) const {
    const fast::TriangleLayout& coarse = layouts[i];
    const fast::TriangleLayout& fine = layouts[i + 1];
    const fast::Reach& reach = tables.reach;
    const Index zone = std::max({reach.star_zone, reach.fan_zone, reach.corner_zone});
    fast::refine_patches(coarse, fine, tables, in, out);
    fast::refine_strips(tables, boundary, coarse, fine, in, out);
    fast::refine_zones(groups, zones[i], zone >= coarse.n(), in, out);
  }
};

Status FastRefiner::State::prepare(const Scheme& scheme) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  // before anything is made that could be too large for an index
  if (Status status = check_refinable(scheme, control, levels, sizeof(Point3), kUnlimited); !status)
    return status;
  int first = levels;
  // without faces the levels would not grow, as evaluate supposes
  const bool any = control.face_count() > 0;
  if (Result<fast::StencilTables> read = fast::read_stencils(scheme, control); any && read) {
    tables = std::move(*read);
    const Index grid = std::max(tables.reach.smallest_grid, tables.halo);
    first = 0;
    while (first < levels && (Index{1} << first) < grid) ++first;
  }
  if (Status status = first < levels ? check_room({control, Index{1} << levels}, levels)
                                     : check_refinable(scheme, control, levels, sizeof(Point3),
                                                       available_memory());
      !status)
    return status;
  Result<fast::PlainSteps> steps = fast::PlainSteps::make(scheme, control, first);
  if (!steps) return steps.error();
  plain.emplace(std::move(*steps));
  for (int level = first; level <= levels; ++level)
    layouts.emplace_back(control, Index{1} << level);
  if (first < levels) prepare_zones();
  return Done{};
}

void FastRefiner::State::prepare_zones() {
  groups = fast::group_vertices(tables, control);
  for (Index e = 0; e < control.edge_count(); ++e)
    if (control.is_boundary_edge(e)) boundary.push_back(control.halfedge_of_edge(e));
  zones.resize(layouts.size() - 1);
  for (const fast::ZoneGroup& group : groups) {
    const std::vector<Index> sectors = fast::sectors_of(group, control);
    for (std::size_t i = 0; i < zones.size(); ++i)
      zones[i].push_back(fast::number_zones(group, sectors, layouts[i], layouts[i + 1]));
  }
}

FastRefiner::FastRefiner(std::unique_ptr<State> state) : state_(std::move(state)) {}
FastRefiner::FastRefiner(FastRefiner&&) noexcept = default;
FastRefiner& FastRefiner::operator=(FastRefiner&&) noexcept = default;
FastRefiner::~FastRefiner() = default;

Result<FastRefiner> FastRefiner::make(const Scheme& scheme, Mesh control, int levels) {
  assert(has_fast_layout(*scheme.split));
  auto state = std::make_unique<State>();
  state->control = std::move(control);
  state->levels = levels;
  if (Status status = state->prepare(scheme); !status) return status.error();
  return FastRefiner(std::move(state));
}

Index FastRefiner::vertex_count() const { return state_->layouts.back().vertex_count(); }
Index FastRefiner::face_count() const { return state_->layouts.back().face_count(); }
int FastRefiner::plain_steps() const { return state_->plain->count(); }

template <class Real>
void FastRefiner::evaluate(std::span<const Real> control, std::span<Real> fine,
                           Scratch<Real>& scratch) const {
  const State& state = *state_;
  const std::size_t steps = state.layouts.size() - 1;
  assert(control.size() == 3 * static_cast<std::size_t>(state.control.vertex_count()));
  assert(fine.size() == 3 * static_cast<std::size_t>(vertex_count()));
  if (steps > 0) {
    // a point is read with the number after it
    const auto before = static_cast<std::size_t>(state.layouts[steps - 1].vertex_count());
    if (scratch.numbers.size() < 3 * before + 1) scratch.numbers = HugeArray<Real>(3 * before + 1);
  }
  // the levels take turns, so that the last one is made in `fine`
  std::array<Real*, 2> places{fine.data(), scratch.numbers.data()};
  if (steps % 2 == 1) std::swap(places[0], places[1]);
  state.plain->evaluate(control.data(), places[0]);
  for (std::size_t i = 0; i < steps; ++i) {
    places[i % 2][3 * static_cast<std::size_t>(state.layouts[i].vertex_count())] = 0;
    state.step(i, places[i % 2], places[(i + 1) % 2]);
  }
}

void FastRefiner::write_faces(std::span<Index> corners) const {
  const fast::TriangleLayout& layout = state_->layouts.back();
  assert(corners.size() == 3 * static_cast<std::size_t>(layout.face_count()));
  const std::ptrdiff_t patch = std::ptrdiff_t{3} * layout.n() * layout.n();
  parallel_for(
      Index{0}, layout.control().face_count(),
      [&](Index first, Index last) {
        layout.write_faces(first, last, corners.data() + first * patch);
      },
      std::max<std::ptrdiff_t>(1, 3 * kFaceChunk / patch));
}

std::size_t FastRefiner::bytes() const {
  const State& state = *state_;
  const Mesh& mesh = state.control;
  std::size_t indices = 3 * static_cast<std::size_t>(mesh.halfedge_count()) +
                        static_cast<std::size_t>(mesh.edge_count() + 2 * mesh.vertex_count()) +
                        state.boundary.size();
  for (const std::vector<fast::ZoneNumbers>& step : state.zones)
    for (const fast::ZoneNumbers& zone : step) indices += zone.sources.size() + zone.targets.size();
  return indices * sizeof(Index) + state.plain->bytes();
}

template void FastRefiner::evaluate<float>(std::span<const float>, std::span<float>,
                                           Scratch<float>&) const;
template void FastRefiner::evaluate<double>(std::span<const double>, std::span<double>,
                                            Scratch<double>&) const;

Result<Polygons> fast_refine(const Scheme& scheme, Mesh control,
                             const std::vector<Point3>& positions, int levels) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  Result<FastRefiner> refiner = FastRefiner::make(scheme, std::move(control), levels);
  if (!refiner) return refiner.error();
  Polygons polygons;
  polygons.positions.resize(static_cast<std::size_t>(refiner->vertex_count()));
  if (!positions.empty())
    refiner->evaluate<double>({&positions.front().x, 3 * positions.size()},
                              {&polygons.positions.front().x, 3 * polygons.positions.size()});
  polygons.corners.resize(3 * static_cast<std::size_t>(refiner->face_count()));
  refiner->write_faces(polygons.corners);
  polygons.face_begin.resize(static_cast<std::size_t>(refiner->face_count()) + 1);
  parallel_for(0, refiner->face_count() + 1, [&](Index first, Index last) {
    for (Index f = first; f < last; ++f) polygons.face_begin[static_cast<std::size_t>(f)] = 3 * f;
  });
  return polygons;
}

}  // namespace limn
