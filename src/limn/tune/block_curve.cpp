#include "limn/tune/block_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

constexpr double kInterpolationError = 1e-13;  // allowed where it is checked, of entries of order 1

double largest_difference(const FrequencyBlocks& a, const FrequencyBlocks& b) {
  if (a.orbits.size() != b.orbits.size()) return HUGE_VAL;
  double largest = 0;
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    largest = std::max(largest, (a.blocks[i] - b.blocks[i]).cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace

BlockCurve::BlockCurve(FreedScheme& scheme, int n, Interval interval)
    : scheme_(&scheme), n_(n), interval_(interval) {
  if (!scheme.everywhere(n)) return;
  for (const int degree : {1, 2, 4, 8, 16})
    if (fit(degree)) return;
  nodes_.clear();
}

bool BlockCurve::fit(int degree) {
  nodes_.clear();
  weights_.clear();
  values_.clear();
  const double middle = (interval_.low + interval_.high) / 2;
  const double half = (interval_.high - interval_.low) / 2;
  for (int j = 0; j <= degree; ++j) {
    const double angle = (2 * j + 1) * std::numbers::pi / (2 * degree + 2);
    nodes_.push_back(middle + half * std::cos(angle));
    weights_.push_back((j % 2 == 0 ? 1 : -1) * std::sin(angle));
    Result<FrequencyBlocks> value = exact(nodes_.back());
    if (!value ||
        value->orbits.size() != (values_.empty() ? *value : values_.front()).orbits.size())
      return false;
    values_.push_back(std::move(*value));
  }
  double scale = 1;
  for (const FrequencyBlocks& value : values_)
    for (const Eigen::MatrixXcd& block : value.blocks)
      scale = std::max(scale, block.cwiseAbs().maxCoeff());
  for (const double place : {-0.937, -0.311, 0.143, 0.792}) {  // none is a Chebyshev point
    const double x = middle + half * place;
    const Result<FrequencyBlocks> value = exact(x);
    if (!value || !(largest_difference(*value, between(x)) < kInterpolationError * scale))
      return false;
  }
  return true;
}

/// The barycentric formula, which is stable at these points.
FrequencyBlocks BlockCurve::between(double x) const {
  std::vector<double> shares;
  double sum = 0;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    if (x == nodes_[j]) return values_[j];
    shares.push_back(weights_[j] / (x - nodes_[j]));
    sum += shares.back();
  }
  FrequencyBlocks result = values_.front();
  for (std::size_t i = 0; i < result.blocks.size(); ++i) {
    result.blocks[i] *= shares.front() / sum;
    for (std::size_t j = 1; j < nodes_.size(); ++j)
      result.blocks[i] += (shares[j] / sum) * values_[j].blocks[i];
  }
  return result;
}

Result<FrequencyBlocks> BlockCurve::operator()(double x) const {
  if (interpolated()) return between(x);
  return exact(x);
}

}  // namespace limn
