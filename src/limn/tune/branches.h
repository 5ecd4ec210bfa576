#pragma once
/// What an equation says of each eigenvalue that may bear the sought label. Private to tune/.

#include <optional>
#include <vector>

#include "limn/spectrum/frequency_blocks.h"
#include "limn/tune/block_curve.h"
#include "limn/tune/freed_scheme.h"

namespace limn::tune {

/// A real eigenvalue (or one whose imaginary part may be rounding) of the sought component's block,
/// and left - right with it in the label's place.
struct Branch {
  Eigenvalue eigenvalue;
  double difference = 0;
};

/// The branches at one x: by ring, and in each ring by value, the largest first. While two samples
/// have the same rings in this order, each branch is continuous from one to the other.
struct BranchSample {
  double x = 0;
  bool defined = true;  ///< false: nothing is known at x, and there are no branches
  std::vector<Branch> branches;
  std::optional<double> labelled;  ///< left - right with the label's own eigenvalue
};

/// Fails where the scheme has no blocks at x or another component of the equation has no value.
[[nodiscard]] Result<BranchSample> sample_branches(const Requirement& requirement,
                                                   FreedScheme& scheme,
                                                   const FrequencyBlocks& blocks, double x,
                                                   Near near = Near::apart);

/// Whether both are defined and branch i of one continues branch i of the other.
[[nodiscard]] bool same_rings(const BranchSample& a, const BranchSample& b);

}  // namespace limn::tune
