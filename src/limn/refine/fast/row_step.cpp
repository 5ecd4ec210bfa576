#include "limn/refine/fast/row_step.h"

#include <algorithm>
#include <cstring>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

constexpr std::ptrdiff_t kPlaceGrain = 1024;

/// Four numbers at once: a point and what comes after it.
template <class Real>
struct Quad {
  typedef Real Type __attribute__((vector_size(4 * sizeof(Real))));
};

/// Sums the rows of one table.
template <class Real>
class RowWorker {
 public:
  using Four = typename Quad<Real>::Type;

  RowWorker(const RowTable& table, const std::vector<Real>& weights)
      : table_(table), weights_(weights), points_(static_cast<std::size_t>(table.sources)) {}

  void run(const Index* sources, const Index* targets, const Real* in, Real* out) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      std::memcpy(&points_[i], in + 3 * static_cast<std::ptrdiff_t>(sources[i]), sizeof(Four));
    const int rows = table_.targets();
    for (int row = 0; row < rows; ++row) {
      Four sum{};
      for (int t = table_.row_begin[row]; t < table_.row_begin[row + 1]; ++t)
        sum += weights_[t] * points_[table_.terms[t].source];
      Real* to = out + 3 * static_cast<std::ptrdiff_t>(targets[row]);
      for (int i = 0; i < 3; ++i) to[i] = sum[i];
    }
  }

 private:
  const RowTable& table_;
  const std::vector<Real>& weights_;
  std::vector<Four> points_;
};

}  // namespace

template <class Real>
void make_rows(const RowPlan& plan, const Real* in, Real* out) {
  std::vector<Real> weights;
  weights.reserve(plan.table.terms.size());
  for (const RowTable::Term& term : plan.table.terms)
    weights.push_back(static_cast<Real>(term.weight));
  const std::ptrdiff_t targets = plan.table.targets();
  if (targets == 0) return;
  const std::ptrdiff_t places = static_cast<std::ptrdiff_t>(plan.targets.size()) / targets;
  parallel_for(
      std::ptrdiff_t{0}, places,
      [&](std::ptrdiff_t first, std::ptrdiff_t last) {
        RowWorker<Real> worker(plan.table, weights);
        for (std::ptrdiff_t i = first; i < last; ++i)
          worker.run(plan.sources.data() + i * plan.table.sources,
                     plan.targets.data() + i * targets, in, out);
      },
      plan.overlap ? places : kPlaceGrain);
}

template void make_rows<float>(const RowPlan&, const float*, float*);
template void make_rows<double>(const RowPlan&, const double*, double*);

}  // namespace limn::fast
