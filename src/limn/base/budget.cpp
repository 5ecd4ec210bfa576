#include "limn/base/budget.h"

#include <chrono>
#include <cmath>
#include <utility>

namespace limn {

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

TimeBudget::TimeBudget(double seconds, Clock clock) : seconds_(seconds) {
  if (!std::isfinite(seconds)) return;
  start_ = clock();
  clock_ = std::move(clock);
}

bool TimeBudget::ended(double share) const {
  return clock_ && clock_() - start_ >= share * seconds_;
}

Stop TimeBudget::stop(double share) const {
  if (!clock_) return {};
  return [budget = *this, share] { return budget.ended(share); };
}

}  // namespace limn
