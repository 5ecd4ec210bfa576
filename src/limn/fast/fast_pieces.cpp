#include "limn/fast/fast_pieces.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <thread>

#include "limn/base/budget.h"
#include "limn/base/large_vector.h"
#include "limn/base/memory.h"
#include "limn/base/parallel.h"
#include "limn/base/sparse_array.h"
#include "limn/fast/fast_refiner.h"
#include "limn/fast/kernel/piece_groups.h"
#include "limn/fast/range.h"
#include "limn/fast/refiner_state.h"

namespace limn::fast {
namespace {

constexpr double kPoint = 3 * sizeof(double);
constexpr Index kGroups = 8;  // at least so many, where a level is large

/// Vertices of three levels that follow one another, the last being the one that pieces are made
/// of: of it only what a group of them needs is in memory.
struct LevelSizes {
  double earlier = 0, before = 0, last = 0;
};

/// The most that is in memory at once; `faces` control faces carry `vertices` of the result.
double needed_bytes(double vertices, double faces, const LevelSizes& levels,
                    const FastPieces::Wanted& wanted) {
  constexpr double kPlan = 9;        // a vertex; see FastRefiner
  constexpr double kLimitPlan = 36;  // likewise
  constexpr double kRound = 16;      // patches that a patch reads from, and itself
  constexpr double kInHand = 150;    // a vertex that a thread works on: it, its faces, their text
  const double share = levels.last * kPoint <= wanted.whole_bytes
                           ? 1
                           : std::min(1.0, std::max(1.5 / kGroups, kRound / faces));
  const int limit = thread_limit();
  const double threads = limit > 0 ? limit : std::max(1U, std::thread::hardware_concurrency());
  const double in_hand = threads * kInHand * std::max<double>(wanted.most, vertices / faces);
  const double plan = wanted.limit || wanted.normals ? kPlan + kLimitPlan : kPlan;
  return (levels.earlier + levels.before + share * levels.last) * kPoint + vertices * plan +
         in_hand;
}

}  // namespace

struct FastPieces::State {
  FastRefiner refiner;
  Wanted wanted;
  std::optional<FastRefiner::Limit> limit = {};
  base::HugeArray<double> whole = {};  // points of the last level that is in memory as a whole, and
                                       // a number of padding
  std::optional<fast::StepPieces> before = {};  // the next level, of which groups need parts
  base::SparseArray level = {};                 // these parts
  std::optional<fast::StepPieces> pieces = {};
  std::vector<fast::PieceGroup> groups = {};
  Index blocks_each = 1;  // blocks of faces in a piece

  void cut(const double* positions);
  /// The points that the pieces are made of.
  [[nodiscard]] const double* points() const { return before ? level.data() : whole.data(); }

 private:
  void find_groups(Index vertices);
};

refine::RefineEstimate FastPieces::estimate(const Split& split, const Mesh& control, int levels,
                                            const Wanted& wanted) {
  const int last = wanted.limit || wanted.normals ? levels : levels - 1;
  const auto vertices = [&](int level) {
    if (level < 0) return 0.0;
    return refine::estimate_refinement(split, control, level, sizeof(Point3)).vertices;
  };
  refine::RefineEstimate estimate =
      refine::estimate_refinement(split, control, levels, sizeof(Point3));
  estimate.peak_bytes =
      needed_bytes(estimate.vertices, std::max<double>(1, control.face_count()),
                   {vertices(last - 2), vertices(last - 1), vertices(last)}, wanted);
  return estimate;
}

Result<std::optional<FastPieces>> FastPieces::make(const Scheme& scheme, Mesh control,
                                                   std::span<const double> positions, int levels,
                                                   const Wanted& wanted) {
  assert(has_fast_layout(scheme));
  auto prepared = std::make_unique<FastRefiner::State>(std::move(control), levels);
  if (Status status = prepared->choose(scheme); !status) return status.error();
  if (prepared->is_plain() || needs_room(positions)) return std::optional<FastPieces>();
  const refine::RefineEstimate needed = estimate(*scheme.split, prepared->control, levels, wanted);
  if (Status status = refine::check_memory(needed, levels, base::available_memory()); !status)
    return status.error();
  if (Status status = prepared->work_out(scheme); !status) return status.error();
  auto state = std::make_unique<State>(State{FastRefiner(std::move(prepared)), wanted});
  if (wanted.limit || wanted.normals) {
    Result<std::optional<FastRefiner::Limit>> limit = approx_fast_limit(scheme, state->refiner);
    if (!limit) return limit.error();
    if (!*limit) return std::optional<FastPieces>();
    state->limit = std::move(*limit);
  }
  state->cut(positions.data());
  return std::optional<FastPieces>(FastPieces(std::move(state)));
}

/// Makes the levels that are in memory as a whole, and cuts the others into pieces.
void FastPieces::State::cut(const double* positions) {
  const FastRefiner::State& all = *refiner.state_;
  const fast::ReadyStep& last = limit ? limit->plan_->step : all.steps.back();
  const std::size_t made_of = limit ? all.steps.size() : all.steps.size() - 1;  // this level
  const std::size_t in_memory = made_of > 0 ? made_of - 1 : 0;
  const std::size_t numbers = 3 * static_cast<std::size_t>(all.vertices[in_memory]);
  whole = base::HugeArray<double>(numbers + 1);
  FastRefiner::Scratch<double> scratch;
  all.evaluate(positions, in_memory, whole.data(), scratch);
  whole[numbers] = 0;
  pieces.emplace(last.plan, last.program, all.size.vertices, wanted.most);
  if (in_memory < made_of) {
    const Index vertices = all.vertices[made_of];
    const fast::ReadyStep& step = all.steps[in_memory];
    before.emplace(step.plan, step.program, vertices, std::max<Index>(1, wanted.most / 16));
    find_groups(vertices);
    level = base::SparseArray(
        3 * static_cast<std::size_t>(vertices) + 1,
        groups.size() == 1 ? base::SparseArray::Pages::huge : base::SparseArray::Pages::small);
  } else {
    groups.push_back({0, pieces->count(), {}});
  }
  const Index blocks = std::max<Index>(1, all.family->face_blocks(all.levels));
  const Index block = std::max<Index>(1, all.size.faces / blocks);
  blocks_each = std::clamp<Index>(2 * wanted.most / block, 1, blocks);
}

/// One group of all pieces where the level is small, or where groups would have so much in common
/// that most of the time went into making it again, and there is memory for all.
void FastPieces::State::find_groups(Index vertices) {
  constexpr std::size_t kMostTimes = 6;
  const double bytes = kPoint * static_cast<double>(vertices);
  if (bytes > wanted.whole_bytes) {
    const Index most = std::max<Index>(4 * wanted.most, vertices / kGroups);
    groups = fast::group_pieces(*pieces, *before, most, limit.has_value() && !wanted.limit);
    std::size_t made = 0;
    for (const fast::PieceGroup& group : groups) made += group.sources.size();
    if (made <= kMostTimes * static_cast<std::size_t>(before->count()) || wanted.whole_bytes == 0 ||
        8 * bytes > base::available_memory())
      return;
  }
  std::vector<Index> all(static_cast<std::size_t>(before->count()));
  std::iota(all.begin(), all.end(), 0);
  groups.assign(1, {0, pieces->count(), std::move(all)});
}

FastPieces::FastPieces(std::unique_ptr<State> state) : state_(std::move(state)) {}
FastPieces::FastPieces(FastPieces&&) noexcept = default;
FastPieces& FastPieces::operator=(FastPieces&&) noexcept = default;
FastPieces::~FastPieces() = default;

Index FastPieces::vertex_count() const { return state_->refiner.vertex_count(); }
Index FastPieces::face_count() const { return state_->refiner.face_count(); }
Index FastPieces::corner_count() const { return state_->refiner.corner_count(); }
Index FastPieces::corners_per_face() const { return state_->refiner.corners_per_face(); }
Index FastPieces::groups() const { return static_cast<Index>(state_->groups.size()); }

FastPieces::Range FastPieces::enter(Index index) {
  State& state = *state_;
  const fast::PieceGroup& group = state.groups[static_cast<std::size_t>(index)];
  state.level.drop();
  double* const level = state.level.data();
  base::parallel_for(
      std::size_t{0}, group.sources.size(),
      [&](std::size_t first, std::size_t last) {
        fast::StepPiece piece;
        for (std::size_t i = first; i < last; ++i) {
          state.before->make(group.sources[i], state.whole.data(), piece);
          const double* from = piece.positions.data();
          for (const fast::Extent& extent : piece.extents) {
            const std::size_t begin = 3 * static_cast<std::size_t>(extent.first);
            const std::size_t count = 3 * static_cast<std::size_t>(extent.count);
            state.level.prepare(begin, count);
            std::copy_n(from, count, level + begin);
            from += count;
          }
        }
      },
      16);
  return {group.first, group.last};
}

void FastPieces::make_vertices(Index piece, fast::StepPiece& out) const {
  const State& state = *state_;
  if (!state.limit) return state.pieces->make(piece, state.points(), out);
  state.pieces->make_limit(piece, state.points(), out);
  if (state.wanted.limit) return;
  double* to = out.positions.data();
  for (const fast::Extent& extent : out.extents)
    to = std::copy_n(state.points() + 3 * static_cast<std::ptrdiff_t>(extent.first),
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
    out.corners = base::large_vector<Index>(static_cast<std::size_t>(corner_count()));
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

}  // namespace limn::fast
