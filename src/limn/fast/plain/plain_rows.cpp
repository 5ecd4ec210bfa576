#include "limn/fast/plain/plain_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>

#include "limn/base/parallel.h"
#include "limn/fast/kernel/quad.h"

namespace limn::fast {
namespace {

constexpr std::size_t kUsualTerms = 10, kMostTerms = 64;  // as a rule

/// Writes rows down.
class RowWriter {
 public:
  RowWriter(const std::vector<Index>& places, Index faces_at, std::vector<Index>& sources,
            WeightLists& lists)
      : places_(places), faces_at_(faces_at), sources_(sources), lists_(lists) {}

  void operator()(refine::Source source, double weight) {
    if (source.is_face) {
      const Index i = faces_at_ + source.index;
      face_sources_.push_back(places_.empty() ? i : places_[i]);
      face_weights_.push_back(weight);
      return;
    }
    // Most of what comes more than once is found here; the rest stays apart, which does no harm.
    Seen& seen = seen_[static_cast<std::size_t>(source.index) % seen_.size()];
    if (seen.source == source.index && seen.row == row_) {
      weights_[seen.at] += weight;
      return;
    }
    if (terms_ == weights_.size()) grow();
    seen = {source.index, row_, terms_};
    row_sources_[terms_] = source.index;
    weights_[terms_++] = weight;
  }

  /// The number of the row's weights.
  Index end_row() {
    const std::size_t olds = terms_;
    for (std::size_t i = 0; i < face_sources_.size(); ++i) {
      if (terms_ == weights_.size()) grow();
      row_sources_[terms_] = face_sources_[i];
      weights_[terms_++] = face_weights_[i];
    }
    const auto end = row_sources_.begin() + static_cast<std::ptrdiff_t>(terms_);
    sources_.insert(sources_.end(), row_sources_.begin(), end);
    const Index list = lists_.number_of({weights_.data(), terms_}, static_cast<Index>(olds));
    face_sources_.clear();
    face_weights_.clear();
    terms_ = 0;
    ++row_;
    return list;
  }

  [[nodiscard]] std::size_t bytes() const {
    return (sources_.size() + static_cast<std::size_t>(row_)) * sizeof(Index) + lists_.bytes();
  }

 private:
  struct Seen {
    Index source = kNone, row = kNone;
    std::size_t at = 0;
  };

  void grow() {
    row_sources_.resize(2 * weights_.size());
    weights_.resize(2 * weights_.size());
  }

  const std::vector<Index>& places_;
  Index faces_at_;
  std::vector<Index>& sources_;
  WeightLists& lists_;
  Index row_ = 0;
  std::array<Seen, 64> seen_;
  // the row so far, in arrays that are longer; faces' part stands apart until its end
  std::size_t terms_ = 0;
  std::vector<Index> row_sources_ = std::vector<Index>(kMostTerms);
  std::vector<double> weights_ = std::vector<double>(kMostTerms);
  std::vector<Index> face_sources_;
  std::vector<double> face_weights_;
};

/// The chunks of new vertices [begin, end) come after these.
void add_chunks(Index begin, Index end, std::vector<PlainRows::Chunk>& chunks) {
  for (Index first = begin; first < end;) {
    const Index rows = std::min(static_cast<Index>(base::kDefaultGrain), end - first);
    chunks.emplace_back().first = first;
    chunks.back().lists.resize(static_cast<std::size_t>(rows));
    first += rows;
  }
}

template <class Do>
void for_chunks(std::size_t begin, std::size_t end, Do do_chunk) {
  base::parallel_for(
      begin, end, [&](std::size_t first, std::size_t) { do_chunk(first); }, 1);
}

}  // namespace

template <class Stencils>
std::optional<PlainRows> PlainRows::record_any(const Stencils& stencils, std::vector<Index> places,
                                               std::size_t limit) {
  PlainRows rows;
  rows.vertex_count_ = stencils.count();
  rows.places_ = std::move(places);
  add_chunks(stencils.faces_at(), stencils.corners_at(), rows.chunks_);
  rows.of_faces_ = rows.chunks_.size();
  add_chunks(0, stencils.faces_at(), rows.chunks_);
  add_chunks(stencils.corners_at(), stencils.count(), rows.chunks_);
  std::vector<WeightLists> lists(rows.chunks_.size());
  std::atomic<std::size_t> bytes = 0;
  for_chunks(0, rows.chunks_.size(), [&](std::size_t c) {
    Chunk& chunk = rows.chunks_[c];
    RowWriter writer(rows.places_, stencils.faces_at(), chunk.sources, lists[c]);
    chunk.sources.reserve(kUsualTerms * chunk.lists.size());
    Index i = chunk.first;
    for (Index& list : chunk.lists) {
      if (bytes + writer.bytes() > limit) break;
      stencils.visit(i++, writer);
      list = writer.end_row();
    }
    bytes += writer.bytes();
    chunk.sources.shrink_to_fit();
  });
  if (bytes > limit) return std::nullopt;
  // from here on, one table of lists
  std::vector<std::vector<Index>> numbers(lists.size());
  for (std::size_t c = 0; c < lists.size(); ++c)
    for (std::size_t k = 0; k < lists[c].lists().size(); ++k)
      numbers[c].push_back(rows.lists_.number_of(lists[c].weights_of(static_cast<Index>(k)),
                                                 lists[c].lists()[k].olds));
  for_chunks(0, lists.size(), [&](std::size_t c) {
    for (Index& list : rows.chunks_[c].lists) list = numbers[c][static_cast<std::size_t>(list)];
  });
  return rows;
}

template <class Real>
void PlainRows::make(const Chunk& chunk, const std::vector<Real>& weights, const Real* old,
                     Real* fresh) const {
  using Four = typename Quad<Real>::Type;
  const Index* source = chunk.sources.data();
  Index i = chunk.first;
  for (const Index number : chunk.lists) {
    const WeightLists::List& list = lists_.lists()[static_cast<std::size_t>(number)];
    const Real* weight = weights.data() + list.begin;
    Four sum{};
    for (const Index* end = source + list.olds; source != end; ++source) {
      Four point;
      std::memcpy(&point, old + 3 * static_cast<std::ptrdiff_t>(*source), sizeof point);
      sum += *weight++ * point;
    }
    for (const Index* end = source + list.faces; source != end; ++source) {
      const Real* point = fresh + 3 * static_cast<std::ptrdiff_t>(*source);
      sum += *weight++ * Four{point[0], point[1], point[2], 0};  // nothing comes after the last
    }
    const Index place = places_.empty() ? i : places_[static_cast<std::size_t>(i)];
    std::memcpy(fresh + 3 * static_cast<std::ptrdiff_t>(place), &sum, 3 * sizeof(Real));
    ++i;
  }
}

template <class Real>
void PlainRows::evaluate(const Real* old, Real* fresh) const {
  const std::vector<Real> weights(lists_.weights().begin(), lists_.weights().end());
  const auto make_chunk = [&](std::size_t c) { make(chunks_[c], weights, old, fresh); };
  for_chunks(0, of_faces_, make_chunk);
  for_chunks(of_faces_, chunks_.size(), make_chunk);
}

std::size_t PlainRows::bytes() const {
  std::size_t indices = places_.size();
  for (const Chunk& chunk : chunks_) indices += chunk.lists.size() + chunk.sources.size();
  return indices * sizeof(Index) + lists_.bytes();
}

template std::optional<PlainRows> PlainRows::record_any(const refine::StepStencils<double>&,
                                                        std::vector<Index>, std::size_t);
template std::optional<PlainRows> PlainRows::record_any(const refine::CreaseStencils<double>&,
                                                        std::vector<Index>, std::size_t);
template void PlainRows::evaluate<float>(const float*, float*) const;
template void PlainRows::evaluate<double>(const double*, double*) const;

}  // namespace limn::fast
