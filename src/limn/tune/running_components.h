#pragma once
/// Eigencomponents at one valence as x moves: only blocks that x changes and that matter are solved
/// again. Most parameters weigh whole rings, and so touch frequency 0 alone; of others the block of
/// frequency 2 mostly bounds those of all above. Private to tune/.

#include <optional>

#include "limn/spectrum/eigencomponents.h"
#include "limn/tune/freed_scheme.h"
#include "limn/tune/frequency_order.h"

namespace limn::tune {

/// Whether blocks may be interpolated ones.
enum class Blocks { quick, exact };

class RunningComponents {
 public:
  /// Of what `requirement` asks for. `curve` must outlive it.
  RunningComponents(const Requirement& requirement, const BlockCurve& curve, Interval interval);
  RunningComponents(const RunningComponents&) = delete;
  RunningComponents& operator=(const RunningComponents&) = delete;

  /// Without a verdict, for x in the interval. Has no eigenvalues of a frequency from 3 on that no
  /// requirement asks for here: others have larger ones. Holds until the next call. Fails as the
  /// curve does.
  [[nodiscard]] Result<const Eigencomponents*> at(double x, Blocks which = Blocks::quick);
  /// Blocks whose eigenvalues were computed so far.
  [[nodiscard]] long long solved() const { return solved_; }

 private:
  [[nodiscard]] Status begin(double x);
  void solve(int omega);
  void label();

  const BlockCurve& curve_;
  FrequencyOrder order_;
  bool all_;           // or 0, 1 and 2 alone, for an inequality
  bool first_ = true;  // nothing is known yet
  FrequencyBlocks blocks_;
  std::optional<SpectrumReader> reader_;  // of blocks_
  std::vector<Eigen::MatrixXcd> known_;   // the blocks that the spectra are of
  double largest_constant_ = 0;           // modulus of frequencies from 3 on that x leaves alone
  Eigencomponents found_;
  long long solved_ = 0;
};

}  // namespace limn::tune
