#pragma once
/// Eigencomponents at one valence as x moves: only blocks that have changed are solved again. Most
/// parameters weigh whole rings, and so touch frequency 0 alone. Private to tune/.

#include "limn/spectrum/eigencomponents.h"

namespace limn {

class RunningComponents {
 public:
  /// Without a verdict. Holds until the next call.
  [[nodiscard]] const Eigencomponents& at(const FrequencyBlocks& blocks);
  /// Blocks whose eigenvalues were computed so far.
  [[nodiscard]] long long solved() const { return solved_; }

 private:
  std::vector<Eigen::MatrixXcd> known_;  // the blocks that the spectra are of
  Eigencomponents found_;
  long long solved_ = 0;
};

}  // namespace limn
