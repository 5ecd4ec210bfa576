#include "limn/tune/running_components.h"

#include <algorithm>

namespace limn::tune {
namespace {

constexpr int kLabelled = 3;  // frequencies that components have: 0, 1, 2
/// Bounds are of exact eigenvalues: rounding may split a defective one by so much.
constexpr double kSlack = 1e-6;

bool same(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

double largest(const BlockSpectrum& spectrum) {
  return spectrum.eigenvalues.empty() ? 0 : spectrum.eigenvalues.front().modulus();
}

}  // namespace

RunningComponents::RunningComponents(const Requirement& requirement, const BlockCurve& curve,
                                     Interval interval)
    : curve_(curve), order_(curve, interval), all_(!requirement.left) {}

Status RunningComponents::begin(double x) {
  Result<FrequencyBlocks> blocks = curve_(x);
  if (!blocks) return blocks.error();
  first_ = false;
  largest_constant_ = 0;
  reader_.reset();
  blocks_ = std::move(*blocks);
  reader_.emplace(blocks_);
  found_.valence = blocks_.valence;
  found_.rings = blocks_.rings;
  const std::size_t count = blocks_.blocks.size();
  known_.assign(count, {});
  found_.spectra.assign(count, {});
  for (std::size_t i = 0; i < count; ++i) found_.spectra[i].frequency = static_cast<int>(i);
  const std::vector<int>& varying = curve_.varying();
  const int last = all_ ? static_cast<int>(count) : std::min(static_cast<int>(count), kLabelled);
  for (int omega = 0; omega < last; ++omega) {
    if (std::binary_search(varying.begin(), varying.end(), omega)) continue;
    solve(omega);
    if (omega >= kLabelled)
      largest_constant_ =
          std::max(largest_constant_, largest(found_.spectra[static_cast<std::size_t>(omega)]));
  }
  return Done{};
}

void RunningComponents::solve(int omega) {
  const auto i = static_cast<std::size_t>(omega);
  if (same(known_[i], blocks_.blocks[i])) return;
  found_.spectra[i] = reader_->approx_spectrum(omega);
  known_[i] = blocks_.blocks[i];
  ++solved_;
}

void RunningComponents::label() {
  const std::array<std::optional<double>*, kComponents.size()> values{
      &found_.position, &found_.cup, &found_.tangent, &found_.saddle};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Component& component = kComponents[i]; component.exists_at(found_.valence))
      *values[i] =
          labelled(component, found_.spectra[static_cast<std::size_t>(component.frequency)]);
}

Result<const Eigencomponents*> RunningComponents::at(double x, Blocks which) {
  if (first_)
    if (Status status = begin(x); !status) return status.error();
  const bool interpolated = curve_.interpolated() && which == Blocks::quick;
  if (!interpolated && !curve_.put_exact(x, blocks_)) {
    // where the rings are others, all begins anew
    if (Status status = begin(x); !status) return status.error();
  }
  const auto refresh = [&](int omega) {
    if (interpolated) curve_.put(x, omega, blocks_);
    solve(omega);
  };
  for (const int omega : curve_.varying())
    if (omega < kLabelled) refresh(omega);
  if (all_) {
    double most = largest_constant_;
    if (found_.spectra.size() >= kLabelled) most = std::max(most, largest(found_.spectra[2]));
    for (const auto& [omega, bound] : order_.at(x)) {
      const auto i = static_cast<std::size_t>(omega);
      if (bound + kSlack < most) {
        found_.spectra[i].eigenvalues.clear();
        known_[i].resize(0, 0);
        continue;
      }
      refresh(omega);
      most = std::max(most, largest(found_.spectra[i]));
    }
  }
  label();
  return &found_;
}

}  // namespace limn::tune
