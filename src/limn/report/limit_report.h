#pragma once
/// Where something asked of the limit surface cannot be had, in words and in JSON.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/limit/limit_points.h"

namespace limn {

/// Vertices at which something is missing, in ascending order.
struct LimitGaps {
  std::vector<LimitPoints::Refused> limits;
  std::vector<Index> normals, curvatures;

  [[nodiscard]] bool any() const {
    return !limits.empty() || !normals.empty() || !curvatures.empty();
  }
};

/// The vertices whose normal is zero.
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals);
/// The vertices whose curvatures are not numbers.
[[nodiscard]] std::vector<Index> without_curvature(
    const std::vector<LimitPoints::Curvatures>& curvatures);

/// A sentence for each kind that is missing; vertices are counted from 0, as those of the refined
/// mesh, and only the first few are named. `normal` is what the file has for one that is missing.
[[nodiscard]] std::vector<std::string> gaps_text(const LimitGaps& gaps, const std::string& normal);
/// {"limits": {"count", "vertices"}, …} of what is missing; the first few vertices.
[[nodiscard]] nlohmann::ordered_json gaps_json(const LimitGaps& gaps);

}  // namespace limn
