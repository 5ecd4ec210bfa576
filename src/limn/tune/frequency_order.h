#pragma once
/// Which frequencies may have the largest eigenvalue at x, the likeliest first. Private to tune/.

#include <array>
#include <limits>
#include <vector>

#include "limn/tune/block_curve.h"

namespace limn::tune {

/// A frequency, and what no modulus of its eigenvalues exceeds near some x (up to rounding).
struct BoundedFrequency {
  int frequency = 0;
  double bound = std::numeric_limits<double>::infinity();
};

/// An upper bound of the spectral radius of every matrix whose entries have at most these moduli,
/// [Collatz 1942; Wielandt 1950]: max (Av)_i / v_i for a positive v, the best of a few.
[[nodiscard]] double radius_bound(const Eigen::MatrixXd& moduli);

/// Bounds of a curve's varying frequencies from 3 on, part by part of its interval.
class FrequencyOrder {
 public:
  /// `curve` must outlive it.
  FrequencyOrder(const BlockCurve& curve, Interval interval) : curve_(curve), interval_(interval) {}
  /// For x in the interval: the largest bound first. Cost: at the first x of a part, three small
  /// products of matrices for each frequency.
  [[nodiscard]] const std::vector<BoundedFrequency>& at(double x);

 private:
  static constexpr std::size_t kParts = 16;

  const BlockCurve& curve_;
  Interval interval_;
  std::array<std::vector<BoundedFrequency>, kParts> parts_;
  std::array<bool, kParts> known_{};
};

}  // namespace limn::tune
