#include "limn/fast/kernel/step_pieces.h"

#include <algorithm>
#include <cassert>

namespace limn::fast {
namespace {

/// Appends vertices to ascending extents that they follow.
void append(std::vector<Extent>& extents, std::size_t begin, Extent next) {
  if (extents.size() > begin && extents.back().first + extents.back().count == next.first)
    extents.back().count += next.count;
  else
    extents.push_back(next);
}

/// Where vertices lie in the memory of a piece.
class Places {
 public:
  explicit Places(const std::vector<Extent>& extents) : extents_(extents) {
    begin_.reserve(extents.size());
    Index begin = 0;
    for (const Extent& extent : extents) {
      begin_.push_back(begin);
      begin += extent.count;
    }
  }

  /// kNone where the piece does not make the vertex.
  [[nodiscard]] Index operator()(Index vertex) const {
    const auto after =
        std::upper_bound(extents_.begin(), extents_.end(), vertex,
                         [](Index v, const Extent& extent) { return v < extent.first; });
    if (after == extents_.begin()) return kNone;
    const auto found = static_cast<std::size_t>(after - extents_.begin()) - 1;
    const Index step = vertex - extents_[found].first;
    return step < extents_[found].count ? begin_[found] + step : kNone;
  }

 private:
  const std::vector<Extent>& extents_;
  std::vector<Index> begin_;
};

}  // namespace

Index StepPiece::vertex_count() const {
  Index count = 0;
  for (const Extent& extent : extents) count += extent.count;
  return count;
}

StepPieces::StepPieces(const StepPlan& plan, const PatchProgram& program, Index vertices,
                       Index piece_vertices)
    : plan_(&plan), patches_(plan.patches, program), begin_{0} {
  rows_.reserve(plan.rows.size());
  for (const RowPlan& rows : plan.rows) rows_.emplace_back(rows);
  cut_patches(piece_vertices);
  cut_the_rest(vertices, piece_vertices);
  finder_ = PieceFinder(extents_, begin_, vertices);
  find_touches();
}

std::vector<Index> StepPieces::run_sizes() const {
  std::vector<Index> sizes;
  sizes.reserve(plan_->patches.shape.runs.size());
  for (const std::vector<FinePoint>& run : plan_->patches.shape.runs)
    sizes.push_back(static_cast<Index>(run.size()));
  return sizes;
}

void StepPieces::cut_patches(Index piece_vertices) {
  const PatchPlan& plan = plan_->patches;
  const std::vector<Index> sizes = run_sizes();
  Index each = 0;
  for (const Index size : sizes) each += size;
  if (each == 0 || plan.patches == 0) return;
  patches_each_ = std::max<Index>(1, piece_vertices / each);
  patch_pieces_ = (plan.patches - 1) / patches_each_ + 1;
  std::vector<Extent> runs;
  for (Index piece = 0; piece < patch_pieces_; ++piece) {
    runs.clear();
    const Index first = piece * patches_each_;
    const Index last = std::min(plan.patches - first, patches_each_) + first;
    const Index* begin = plan.runs.data() + static_cast<std::size_t>(first) * sizes.size();
    for (Index patch = first; patch < last; ++patch)
      for (const Index size : sizes)
        if (const Index number = *begin++; number != kNone) runs.push_back({number, size});
    std::sort(runs.begin(), runs.end(),
              [](const Extent& a, const Extent& b) { return a.first < b.first; });
    const std::size_t old = extents_.size();
    for (const Extent& run : runs) append(extents_, old, run);
    begin_.push_back(static_cast<Index>(extents_.size()));
  }
}

/// What no patch makes.
void StepPieces::cut_the_rest(Index vertices, Index piece_vertices) {
  std::vector<Extent> made = extents_;
  std::sort(made.begin(), made.end(),
            [](const Extent& a, const Extent& b) { return a.first < b.first; });
  made.push_back({vertices, 0});
  // what lies round them lies anywhere: small pieces, so that none reads far more than it makes
  const Index most = std::max<Index>(1, piece_vertices / 32);
  Index next = 0;
  for (const Extent& extent : made) {
    assert(extent.first >= next);  // no vertex is made twice
    while (next < extent.first) {
      const Index count = std::min(extent.first - next, most);
      extents_.push_back({next, count});
      begin_.push_back(static_cast<Index>(extents_.size()));
      next += count;
    }
    next = extent.first + extent.count;
  }
}

void StepPieces::find_touches() {
  // each place once for each piece that it has targets in: counted first, then listed
  const auto for_each_touch = [&](const auto& use) {
    std::vector<std::size_t> seen(static_cast<std::size_t>(count()), 0);
    std::size_t stamp = 0;
    for (std::size_t p = 0; p < plan_->rows.size(); ++p) {
      const RowPlan& rows = plan_->rows[p];
      const std::size_t places = rows.places(), each = rows.targets_each();
      for (std::size_t place = 0; place < places; ++place) {
        ++stamp;
        for (std::size_t t = place * each; t < (place + 1) * each; ++t) {
          const auto piece = static_cast<std::size_t>(finder_.piece(rows.targets[t]));
          if (seen[piece] == stamp) continue;
          seen[piece] = stamp;
          use(piece, Touch{static_cast<Index>(p), static_cast<Index>(place)});
        }
      }
    }
  };
  std::vector<std::size_t> ends(static_cast<std::size_t>(count()), 0);
  for_each_touch([&](std::size_t piece, Touch) { ++ends[piece]; });
  touch_begin_.assign(ends.size() + 1, 0);
  for (std::size_t piece = 0; piece < ends.size(); ++piece) {
    touch_begin_[piece + 1] = touch_begin_[piece] + ends[piece];
    ends[piece] = touch_begin_[piece];
  }
  touches_.resize(touch_begin_.back());
  for_each_touch([&](std::size_t piece, Touch touch) { touches_[ends[piece]++] = touch; });
}

std::vector<Index> StepPieces::sources(Index piece, const StepPieces& before,
                                       bool own_vertices) const {
  std::vector<Index> found;
  const auto add = [&](Index first, Index count) {
    for (const Index end = first + count; first < end; first = before.finder_.extent_end(first))
      if (const Index made = before.finder_.piece(first); found.empty() || found.back() != made)
        found.push_back(made);
  };
  const PatchPlan& plan = plan_->patches;
  if (piece < patch_pieces_) {
    const Index first = piece * patches_each_;
    const Index patches = std::min(plan.patches - first, patches_each_);
    const std::size_t each = plan.shape.frame.size();
    const Index* frame = plan.frame.data() + static_cast<std::size_t>(first) * each;
    for (std::size_t i = 0; i < static_cast<std::size_t>(patches) * each; ++i) add(frame[i], 1);
    const auto inner = static_cast<Index>(plan.shape.inner.size());
    add(plan.inner_begin + first * inner, patches * inner);
  }
  const auto at = static_cast<std::size_t>(piece);
  for (std::size_t t = touch_begin_[at]; t < touch_begin_[at + 1]; ++t) {
    const RowPlan& rows = plan_->rows[static_cast<std::size_t>(touches_[t].plan)];
    const auto each = static_cast<std::size_t>(rows.table.sources);
    const Index* from = rows.sources.data() + static_cast<std::size_t>(touches_[t].place) * each;
    for (std::size_t i = 0; i < each; ++i) add(from[i], 1);
  }
  for (Index e = begin_[at]; own_vertices && e < begin_[at + 1]; ++e)
    add(extents_[static_cast<std::size_t>(e)].first, extents_[static_cast<std::size_t>(e)].count);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Index StepPieces::vertices_of(Index piece) const {
  const auto at = static_cast<std::size_t>(piece);
  Index count = 0;
  for (Index e = begin_[at]; e < begin_[at + 1]; ++e)
    count += extents_[static_cast<std::size_t>(e)].count;
  return count;
}

void StepPieces::lay_out(Index piece, StepPiece& out) const {
  const auto at = static_cast<std::size_t>(piece);
  out.extents.assign(extents_.begin() + begin_[at], extents_.begin() + begin_[at + 1]);
  const std::size_t numbers = 3 * static_cast<std::size_t>(out.vertex_count()) + 1;
  if (out.positions.size() < numbers) out.positions.resize(numbers);
}

PatchRange StepPieces::patches_of(Index piece, const StepPiece& out,
                                  std::vector<Index>& runs) const {
  const PatchPlan& plan = plan_->patches;
  const Index first = piece * patches_each_;
  const Index last = std::min(plan.patches - first, patches_each_) + first;
  const std::size_t each = plan.shape.runs.size();
  const Places place(out.extents);
  runs.assign(plan.runs.data() + static_cast<std::size_t>(first) * each,
              plan.runs.data() + static_cast<std::size_t>(last) * each);
  for (Index& begin : runs)
    if (begin != kNone) begin = place(begin);
  return {first, last, runs.data()};
}

template <class Use>
void StepPieces::for_rows(Index piece, const StepPiece& out, const Use& use) const {
  const Places place(out.extents);
  std::vector<Index> list, targets;
  std::size_t t = touch_begin_[static_cast<std::size_t>(piece)];
  const std::size_t end = touch_begin_[static_cast<std::size_t>(piece) + 1];
  while (t < end) {
    const auto plan = static_cast<std::size_t>(touches_[t].plan);
    const RowPlan& rows = plan_->rows[plan];
    const std::size_t each = rows.targets_each();
    list.clear();
    targets.clear();
    for (; t < end && static_cast<std::size_t>(touches_[t].plan) == plan; ++t) {
      list.push_back(touches_[t].place);
      const Index* const from =
          rows.targets.data() + static_cast<std::size_t>(touches_[t].place) * each;
      for (std::size_t i = 0; i < each; ++i) targets.push_back(place(from[i]));
    }
    use(rows_[plan], RowPlaces{list.data(), 0, list.size(), targets.data()});
  }
}

void StepPieces::make(Index piece, const double* in, StepPiece& out) const {
  lay_out(piece, out);
  std::vector<Index> runs;
  double* const to = out.positions.data();
  if (piece < patch_pieces_) patches_.make(patches_of(piece, out, runs), in, to);
  for_rows(piece, out, [&](const RowStep<double>& rows, const RowPlaces& places) {
    rows.make(places, in, to);
  });
}

void StepPieces::make_limit(Index piece, const double* in, StepPiece& out) const {
  lay_out(piece, out);
  out.normals.resize(out.positions.size());
  std::vector<Index> runs;
  double *const positions = out.positions.data(), *const normals = out.normals.data();
  if (piece < patch_pieces_)
    patches_.make_limit(patches_of(piece, out, runs), in, positions, normals);
  for_rows(piece, out, [&](const RowStep<double>& rows, const RowPlaces& places) {
    rows.make_limit(places, in, positions, normals);
  });
}

std::size_t StepPieces::bytes() const {
  return begin_.size() * sizeof(Index) + extents_.size() * sizeof(Extent) +
         touch_begin_.size() * sizeof(std::size_t) + touches_.size() * sizeof(Touch);
}

}  // namespace limn::fast
