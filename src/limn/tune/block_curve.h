#pragma once
/// Frequency blocks at one valence as functions of x, quick enough to be sampled. Private to tune/.

#include <optional>
#include <vector>

#include "limn/tune/freed_scheme.h"

namespace limn::tune {

/// Each x costs the weights' expressions and the blocks of all frequencies, and a refined star
/// where x changes the star's regular part. But weights are as a rule polynomials in x, so the
/// blocks are interpolated from a few values (by polynomials of degree 16 at most; where that
/// fails, of rational weights, say, they are computed each time). These values also tell which
/// blocks x changes at all.
class BlockCurve {
 public:
  /// `scheme` must outlive the curve. `frequencies`: those that are asked for, ascending; empty: 0
  /// … ⌊n/2⌋. Where they are given and x changes no star, blocks are computed each time.
  BlockCurve(FreedScheme& scheme, int n, Interval interval, std::vector<int> frequencies = {});

  /// The frequencies asked for (and 0), for x in the interval; the other blocks have no rows.
  /// Interpolated ones are exact to about 1e-14.
  [[nodiscard]] Result<FrequencyBlocks> operator()(double x) const;
  /// All frequencies, from the scheme itself.
  [[nodiscard]] Result<FrequencyBlocks> exact(double x) const { return scheme_->blocks(n_, x); }
  [[nodiscard]] bool interpolated() const { return !nodes_.empty(); }
  /// Whether a value costs little: interpolated, or no star to refine.
  [[nodiscard]] bool quick() const { return interpolated() || !scheme_->everywhere(n_); }

  /// Frequencies asked for whose blocks x changes, ascending; all where that is not known.
  [[nodiscard]] const std::vector<int>& varying() const { return varying_; }
  /// Puts one frequency's block at x into `blocks`, in its place. Interpolated curves only.
  void put(double x, int omega, FrequencyBlocks& blocks) const;
  /// Puts the blocks of varying() at x into `blocks`, from the scheme itself. Fails where that has
  /// none, and where they are of other orbits than those that `blocks` has.
  [[nodiscard]] Status put_exact(double x, FrequencyBlocks& blocks) const;
  /// For each entry a number that its modulus exceeds nowhere in this part of the interval, up to
  /// rounding; nothing where the block is interpolated by no polynomial of degree 2 at most.
  [[nodiscard]] std::optional<Eigen::MatrixXd> moduli_within(Interval part, int omega) const;

 private:
  [[nodiscard]] Result<FrequencyBlocks> wanted_at(double x) const {
    return scheme_->blocks(n_, x, wanted_);
  }
  bool fit(int degree);
  void note_changes(const FrequencyBlocks& value);
  [[nodiscard]] std::vector<double> shares(double x) const;

  FreedScheme* scheme_;
  int n_;
  Interval interval_;
  std::vector<int> wanted_, varying_;
  std::vector<double> nodes_, weights_;  // Chebyshev points and their barycentric weights
  std::vector<FrequencyBlocks> values_;
};

}  // namespace limn::tune
