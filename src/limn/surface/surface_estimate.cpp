#include "limn/surface/surface_estimate.h"

#include <algorithm>

#include "limn/fast/fast_estimate.h"
#include "limn/fast/fast_pieces.h"
#include "limn/limit/limit_points.h"

namespace limn::surface {
namespace {

// Bytes for each vertex of the result, where they do not follow from the types (measured).
constexpr double kQuickNumbers = 36;  // of the quick limit's plan
constexpr double kPlainNumbers = 48;  // of the plain way: what is still to do, and where
constexpr double kTable = 250;        // rows of curvatures, and their text as it grows

}  // namespace

refine::RefineEstimate estimate_with_limit(const Scheme& scheme, const Mesh& control, int levels,
                                           const LimitWork& work) {
  const Split& split = *scheme.split;
  constexpr double kPoint = sizeof(Point3);
  const refine::RefineEstimate plain =
      refine::estimate_refinement(split, control, levels, sizeof(Point3));
  const bool quick = work.quick && has_fast_layout(scheme);
  if (quick && work.written && !work.curvatures)
    return fast::FastPieces::estimate(split, control, levels, {work.limit, work.limit});
  refine::RefineEstimate result = quick ? fast::estimate_fast(split, control, levels) : plain;
  // refined, and as they are handed on
  const double attributes = result.vertices * 2 * kPoint * work.columns;
  result.peak_bytes += attributes;
  if (!work.limit && !work.curvatures) return result;
  if (quick && !work.curvatures) {  // refined points, those of the limit, normals
    result.peak_bytes += result.vertices * (3 * kPoint + kQuickNumbers);
    return result;
  }
  // A dual split's vertices are taken to the centres of faces, one step further on.
  const int steps = split.is_dual() ? levels + 1 : levels;
  const double last = refine::estimate_refinement(split, control, steps, sizeof(Point3)).peak_bytes;
  double beside = 2 * kPoint + kPlainNumbers;
  if (work.curvatures) beside += sizeof(LimitPoints::Curvatures);
  // the table comes when the steps of the limit are over
  const double table = work.curvatures ? plain.vertices * kTable : 0;
  result.peak_bytes =
      std::max(last + plain.vertices * beside, plain.peak_bytes + plain.vertices * beside + table) +
      attributes;
  return result;
}

}  // namespace limn::surface
