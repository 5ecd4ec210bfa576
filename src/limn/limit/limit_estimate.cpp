#include "limn/limit/limit_estimate.h"

#include <algorithm>

#include "limn/limit/limit_points.h"
#include "limn/refine/fast/fast_refiner.h"

namespace limn {
namespace {

// Bytes for each vertex of the result, where they do not follow from the types (measured).
constexpr double kQuickNumbers = 36;  // of the quick limit's plan
constexpr double kPlainNumbers = 48;  // of the plain way: what is still to do, and where
constexpr double kTable = 250;        // rows of curvatures, and their text as it grows

}  // namespace

RefineEstimate estimate_with_limit(const Split& split, const Mesh& control, int levels,
                                   const LimitWork& work) {
  constexpr double kPoint = sizeof(Point3);
  const RefineEstimate plain = estimate_refinement(split, control, levels, sizeof(Point3));
  RefineEstimate result = work.quick ? FastRefiner::estimate(split, control, levels) : plain;
  if (!work.limit && !work.curvatures) return result;
  if (work.quick && !work.curvatures) {  // refined points, those of the limit, normals
    result.peak_bytes += result.vertices * (3 * kPoint + kQuickNumbers);
    return result;
  }
  // A dual split's vertices are taken to the centres of faces, one step further on.
  const int steps = split.births.corners ? levels + 1 : levels;
  const double last = estimate_refinement(split, control, steps, sizeof(Point3)).peak_bytes;
  double beside = 2 * kPoint + kPlainNumbers;
  if (work.curvatures) beside += sizeof(LimitPoints::Curvatures);
  // the table comes when the steps of the limit are over
  const double table = work.curvatures ? plain.vertices * kTable : 0;
  result.peak_bytes =
      std::max(last + plain.vertices * beside, plain.peak_bytes + plain.vertices * beside + table);
  return result;
}

}  // namespace limn
