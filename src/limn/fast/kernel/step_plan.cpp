#include "limn/fast/kernel/step_plan.h"

namespace limn::fast {

std::size_t bytes_of(const StepPlan& plan) {
  std::size_t indices = plan.patches.frame.size() + plan.patches.runs.size();
  for (const RowPlan& rows : plan.rows) indices += rows.sources.size() + rows.targets.size();
  std::size_t points = 0;
  for (const std::vector<FinePoint>& run : plan.patches.shape.runs) points += run.size();
  return indices * sizeof(Index) + points * sizeof(FinePoint);
}

}  // namespace limn::fast
