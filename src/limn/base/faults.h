#pragma once
/// All faults of one input, told at once.

#include <cstddef>
#include <vector>

#include "limn/base/error.h"

namespace limn::base {

/// Gathers faults as they are found. A fault with the place and message of an earlier one is that
/// one again. Beyond some thousands they are only counted.
class Faults {
 public:
  void add(Error fault);

  [[nodiscard]] bool none() const { return faults_.empty(); }
  /// How many were found; rises with each, so that two counts tell whether something failed.
  [[nodiscard]] std::size_t count() const { return faults_.size() + uncounted_; }
  /// In the order in which they were found.
  [[nodiscard]] const std::vector<Error>& list() const { return faults_; }

  /// One error for all of them: that of the first place, whose message goes on with a line for each
  /// of the next ones in the order of their places, twenty in all, and says how many more there
  /// are. A single fault is returned as it is. Precondition: !none().
  [[nodiscard]] Error joined() const;

 private:
  std::vector<Error> faults_;
  std::size_t uncounted_ = 0;
};

}  // namespace limn::base
