#pragma once
/// Frequency blocks at one valence as functions of x, quick enough to be sampled. Private to tune/.

#include <vector>

#include "limn/tune/freed_scheme.h"

namespace limn {

/// Where x changes the star's regular part, each x costs a refined star; but weights are as a rule
/// polynomials in x, so then the blocks are interpolated from a few values (by polynomials of
/// degree 16 at most; where that fails, of rational weights, say, they are computed each time).
class BlockCurve {
 public:
  /// `scheme` must outlive the curve.
  BlockCurve(FreedScheme& scheme, int n, Interval interval);

  /// For x in the interval; interpolated ones are exact to about 1e-14.
  [[nodiscard]] Result<FrequencyBlocks> operator()(double x) const;
  [[nodiscard]] Result<FrequencyBlocks> exact(double x) const { return scheme_->blocks(n_, x); }
  [[nodiscard]] bool interpolated() const { return !nodes_.empty(); }
  /// Whether a value costs little: interpolated, or no star to refine.
  [[nodiscard]] bool quick() const { return interpolated() || !scheme_->everywhere(n_); }

 private:
  bool fit(int degree);
  [[nodiscard]] FrequencyBlocks between(double x) const;

  FreedScheme* scheme_;
  int n_;
  Interval interval_;
  std::vector<double> nodes_, weights_;  // Chebyshev points and their barycentric weights
  std::vector<FrequencyBlocks> values_;
};

}  // namespace limn
