#include "limn/tune/frequency_order.h"

#include <algorithm>

namespace limn::tune {

double radius_bound(const Eigen::MatrixXd& moduli) {
  constexpr int kSteps = 6;
  double best = std::numeric_limits<double>::infinity();
  Eigen::VectorXd v = Eigen::VectorXd::Ones(moduli.rows());
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::VectorXd next = moduli * v;
    best = std::min(best, (next.array() / v.array()).maxCoeff());
    const double largest = next.maxCoeff();
    if (!(largest > 0)) return 0;
    v = (next / largest).cwiseMax(1e-9);  // any positive vector will do
  }
  return best;
}

const std::vector<BoundedFrequency>& FrequencyOrder::at(double x) {
  const double width = (interval_.high - interval_.low) / kParts;
  const double place = std::clamp((x - interval_.low) / width, 0.0, kParts - 1.0);
  const auto i = static_cast<std::size_t>(place);
  std::vector<BoundedFrequency>& part = parts_[i];
  if (known_[i]) return part;
  known_[i] = true;
  // wider by a little, for an x at the end that rounding puts beside it
  const double low = interval_.low + width * (static_cast<double>(i) - 1e-6);
  for (const int omega : curve_.varying()) {
    if (omega < 3) continue;
    part.push_back({omega});
    if (const auto moduli = curve_.moduli_within({low, low + width * (1 + 2e-6)}, omega))
      part.back().bound = radius_bound(*moduli);
  }
  std::stable_sort(
      part.begin(), part.end(),
      [](const BoundedFrequency& a, const BoundedFrequency& b) { return a.bound > b.bound; });
  return part;
}

}  // namespace limn::tune
