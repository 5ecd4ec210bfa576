#include "limn/fast/fast_pieces.h"

#include <algorithm>
#include <cassert>
#include <thread>

#include "limn/base/memory.h"
#include "limn/base/thread_limit.h"
#include "limn/fast/fast_limit.h"
#include "limn/fast/refiner_state.h"

namespace limn {
namespace {

/// The most that is in memory at once: `before`, `earlier` vertices of the last two levels but one,
/// `whole` of the last if it is there, patches of `patch` vertices.
double needed_bytes(double vertices, double before, double earlier, double patch,
                    const FastPieces::Wanted& wanted) {
  constexpr double kPoint = 3 * sizeof(double);
  constexpr double kPlan = 9;        // a vertex; see FastRefiner
  constexpr double kLimitPlan = 36;  // likewise
  constexpr double kInHand = 150;    // a vertex that a thread works on: it, its faces, their text
  const int limit = thread_limit();
  const double threads = limit > 0 ? limit : std::max(1U, std::thread::hardware_concurrency());
  const double in_hand = threads * kInHand * std::max<double>(wanted.most, patch);
  const double last = wanted.limit || wanted.normals ? vertices * (kPoint + kLimitPlan) : 0;
  return (before + earlier) * kPoint + vertices * kPlan + last + in_hand;
}

}  // namespace

struct FastPieces::State {
  FastRefiner refiner;
  std::optional<FastRefiner::Limit> limit;
  Wanted wanted;
  HugeArray<double> level;  // the points that the pieces are made of, and one number of padding
  std::optional<fast::StepPieces> pieces;
  Index blocks_each = 1;  // blocks of faces in a piece
};

RefineEstimate FastPieces::estimate(const Split& split, const Mesh& control, int levels,
                                    const Wanted& wanted) {
  const auto vertices = [&](int level) {
    return estimate_refinement(split, control, std::max(level, 0), sizeof(Point3)).vertices;
  };
  RefineEstimate estimate = estimate_refinement(split, control, levels, sizeof(Point3));
  const double patches = std::max<double>(1, control.face_count());
  estimate.peak_bytes = needed_bytes(estimate.vertices, vertices(levels - 1), vertices(levels - 2),
                                     estimate.vertices / patches, wanted);
  return estimate;
}

Result<std::optional<FastPieces>> FastPieces::make(const Scheme& scheme, Mesh control,
                                                   std::span<const double> positions, int levels,
                                                   const Wanted& wanted) {
  assert(has_fast_layout(*scheme.split));
  auto prepared = std::make_unique<FastRefiner::State>(std::move(control), levels);
  if (Status status = prepared->choose(scheme); !status) return status.error();
  if (prepared->is_plain()) return std::optional<FastPieces>();
  const RefineEstimate needed = estimate(*scheme.split, prepared->control, levels, wanted);
  if (Status status = check_memory(needed, levels, available_memory()); !status)
    return status.error();
  if (Status status = prepared->work_out(scheme); !status) return status.error();
  auto state = std::make_unique<State>(State{FastRefiner(std::move(prepared)), {}, wanted, {}, {}});
  const FastRefiner::State& steps = *state->refiner.state_;
  std::size_t made = steps.steps.size() - 1;
  const fast::ReadyStep* last = &steps.steps.back();
  if (wanted.limit || wanted.normals) {
    Result<std::optional<FastRefiner::Limit>> limit = approx_fast_limit(scheme, state->refiner);
    if (!limit) return limit.error();
    if (!*limit) return std::optional<FastPieces>();
    state->limit = std::move(*limit);
    last = &state->limit->plan_->step;
    ++made;
  }
  const std::size_t numbers = 3 * static_cast<std::size_t>(steps.vertices[made]);
  state->level = HugeArray<double>(numbers + 1);
  FastRefiner::Scratch<double> scratch;
  steps.evaluate(positions.data(), made, state->level.data(), scratch);
  state->level[numbers] = 0;
  state->pieces.emplace(last->plan, last->program, steps.size.vertices, wanted.most);
  const Index blocks = std::max<Index>(1, steps.family->face_blocks(levels));
  const Index block = std::max<Index>(1, steps.size.faces / blocks);
  state->blocks_each = std::clamp<Index>(2 * wanted.most / block, 1, blocks);
  return std::optional<FastPieces>(FastPieces(std::move(state)));
}

FastPieces::FastPieces(std::unique_ptr<const State> state) : state_(std::move(state)) {}
FastPieces::FastPieces(FastPieces&&) noexcept = default;
FastPieces& FastPieces::operator=(FastPieces&&) noexcept = default;
FastPieces::~FastPieces() = default;

Index FastPieces::vertex_count() const { return state_->refiner.vertex_count(); }
Index FastPieces::face_count() const { return state_->refiner.face_count(); }
Index FastPieces::corner_count() const { return state_->refiner.corner_count(); }
Index FastPieces::corners_per_face() const { return state_->refiner.corners_per_face(); }
Index FastPieces::vertex_pieces() const { return state_->pieces->count(); }

void FastPieces::make_vertices(Index piece, fast::StepPiece& out) const {
  const State& state = *state_;
  if (!state.limit) return state.pieces->make(piece, state.level.data(), out);
  state.pieces->make_limit(piece, state.level.data(), out);
  if (state.wanted.limit) return;
  double* to = out.positions.data();
  for (const fast::Extent& extent : out.extents)
    to = std::copy_n(state.level.data() + 3 * static_cast<std::ptrdiff_t>(extent.first),
                     3 * static_cast<std::ptrdiff_t>(extent.count), to);
}

Index FastPieces::face_pieces() const {
  const FastRefiner::State& steps = *state_->refiner.state_;
  const Index blocks = steps.family->face_blocks(steps.levels);
  return (blocks - 1) / state_->blocks_each + 1;
}

void FastPieces::make_faces(Index piece, FacePiece& out) const {
  const FastRefiner::State& steps = *state_->refiner.state_;
  const Index blocks = steps.family->face_blocks(steps.levels);
  const Index each = corners_per_face();
  if (blocks == 1) {
    out.first = 0;
    out.count = face_count();
    out.corners.resize(static_cast<std::size_t>(corner_count()));
    state_->refiner.write_faces(out.corners);
    out.begin.resize(each == 0 ? static_cast<std::size_t>(out.count) + 1 : 0);
    if (each == 0) state_->refiner.write_face_begin(out.begin);
    return;
  }
  assert(each > 0);
  const Index first = piece * state_->blocks_each;
  const Index last = std::min(blocks - first, state_->blocks_each) + first;
  const Index faces = face_count() / blocks;
  out.first = first * faces;
  out.count = (last - first) * faces;
  out.corners.resize(static_cast<std::size_t>(out.count) * static_cast<std::size_t>(each));
  out.begin.clear();
  steps.family->write_face_blocks(steps.levels, first, last, out.corners.data());
}

}  // namespace limn
