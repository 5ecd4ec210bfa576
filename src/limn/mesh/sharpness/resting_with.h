#pragma once
/// Vertices that rest with edges that end elsewhere.

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::mesh {

/// The sharpness of a vertex that rests as long as one of these edges is sharp, and is then blended
/// as they are: by the mean of what is left of those that end last. 0 without edges.
[[nodiscard]] inline double resting_with(const std::vector<double>& edges) {
  double last = 0;
  for (const double s : edges) last = std::max(last, std::ceil(s) - 1);
  double sum = 0;
  int count = 0;
  for (const double s : edges) {
    if (!(s > last)) continue;
    sum += s - last;
    ++count;
  }
  return count > 0 ? last + sum / count : 0;
}

}  // namespace limn::mesh
