#include "limn/tune/block_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace limn::tune {
namespace {

constexpr double kInterpolationError = 1e-13;  // allowed where it is checked, of entries of order 1

const Eigen::MatrixXcd& block(const FrequencyBlocks& blocks, int omega) {
  return blocks.blocks[static_cast<std::size_t>(omega)];
}

double largest_difference(const FrequencyBlocks& a, const FrequencyBlocks& b) {
  if (a.orbits.size() != b.orbits.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    if (a.blocks[i].size() > 0)
      largest = std::max(largest, (a.blocks[i] - b.blocks[i]).cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

BlockCurve::BlockCurve(FreedScheme& scheme, int n, Interval interval, std::vector<int> frequencies)
    : scheme_(&scheme), n_(n), interval_(interval), wanted_(std::move(frequencies)) {
  const bool all = wanted_.empty();
  if (all) {
    wanted_.resize(static_cast<std::size_t>(n / 2 + 1));
    std::iota(wanted_.begin(), wanted_.end(), 0);
  }
  varying_ = wanted_;
  if (!all && !scheme.everywhere(n)) return;  // few blocks, and no star
  for (const int degree : {1, 2, 4, 8, 16})
    if (fit(degree)) return;
  nodes_.clear();
  varying_ = wanted_;
}

bool BlockCurve::fit(int degree) {
  nodes_.clear();
  weights_.clear();
  values_.clear();
  varying_.clear();
  const double middle = (interval_.low + interval_.high) / 2;
  const double half = (interval_.high - interval_.low) / 2;
  for (int j = 0; j <= degree; ++j) {
    const double angle = (2 * j + 1) * std::numbers::pi / (2 * degree + 2);
    nodes_.push_back(middle + half * std::cos(angle));
    weights_.push_back((j % 2 == 0 ? 1 : -1) * std::sin(angle));
    Result<FrequencyBlocks> value = wanted_at(nodes_.back());
    if (!value ||
        value->orbits.size() != (values_.empty() ? *value : values_.front()).orbits.size())
      return false;
    values_.push_back(std::move(*value));
    note_changes(values_.back());
  }
  double scale = 1;
  for (const FrequencyBlocks& value : values_)
    for (const int omega : wanted_)
      scale = std::max(scale, block(value, omega).cwiseAbs().maxCoeff());
  for (const double place : {-0.937, -0.311, 0.143, 0.792}) {  // none is a Chebyshev point
    const double x = middle + half * place;
    const Result<FrequencyBlocks> value = wanted_at(x);
    if (!value) return false;
    FrequencyBlocks between = values_.front();
    for (const int omega : wanted_) put(x, omega, between);
    if (!(largest_difference(*value, between) < kInterpolationError * scale)) return false;
    note_changes(*value);
  }
  return true;
}

void BlockCurve::note_changes(const FrequencyBlocks& value) {
  std::vector<int> all;
  for (const int omega : wanted_)
    if (std::binary_search(varying_.begin(), varying_.end(), omega) ||
        block(value, omega) != block(values_.front(), omega))
      all.push_back(omega);
  varying_ = std::move(all);
}

/// The barycentric formula, which is stable at these points.
std::vector<double> BlockCurve::shares(double x) const {
  std::vector<double> shares(nodes_.size());
  const auto same = std::find(nodes_.begin(), nodes_.end(), x);
  if (same != nodes_.end()) {
    shares[static_cast<std::size_t>(same - nodes_.begin())] = 1;
    return shares;
  }
  for (std::size_t j = 0; j < nodes_.size(); ++j) shares[j] = weights_[j] / (x - nodes_[j]);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= sum;
  return shares;
}

void BlockCurve::put(double x, int omega, FrequencyBlocks& blocks) const {
  const std::vector<double> share = shares(x);
  Eigen::MatrixXcd& result = blocks.blocks[static_cast<std::size_t>(omega)];
  result = share.front() * block(values_.front(), omega);
  for (std::size_t j = 1; j < share.size(); ++j) result += share[j] * block(values_[j], omega);
}

Status BlockCurve::put_exact(double x, FrequencyBlocks& blocks) const {
  Result<FrequencyBlocks> value = scheme_->blocks(n_, x, varying_);
  if (!value) return value.error();
  if (value->orbits.size() != blocks.orbits.size())
    return Error{"the rings that control the surface are others here"};
  for (const int omega : varying_)
    blocks.blocks[static_cast<std::size_t>(omega)] =
        std::move(value->blocks[static_cast<std::size_t>(omega)]);
  return Done{};
}

std::optional<Eigen::MatrixXd> BlockCurve::moduli_within(Interval part, int omega) const {
  if (nodes_.size() < 2 || nodes_.size() > 3) return std::nullopt;
  FrequencyBlocks ends = values_.front();
  put(part.low, omega, ends);
  Eigen::MatrixXd bound = block(ends, omega).cwiseAbs();
  put(part.high, omega, ends);
  bound = bound.cwiseMax(block(ends, omega).cwiseAbs());  // the modulus of a line is convex
  if (nodes_.size() == 2) return bound;
  // a parabola leaves its chord by at most |second derivative| · width² / 8
  const double width = part.high - part.low;
  const auto slope = [&](std::size_t j) -> Eigen::MatrixXcd {
    return (block(values_[j + 1], omega) - block(values_[j], omega)) / (nodes_[j + 1] - nodes_[j]);
  };
  return bound + ((slope(1) - slope(0)) / (nodes_[2] - nodes_[0])).cwiseAbs() * (width * width / 4);
}

Result<FrequencyBlocks> BlockCurve::operator()(double x) const {
  if (!interpolated()) return wanted_at(x);
  FrequencyBlocks result = values_.front();
  for (const int omega : varying_) put(x, omega, result);
  return result;
}

}  // namespace limn::tune
