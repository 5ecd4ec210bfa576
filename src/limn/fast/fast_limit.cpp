#include "limn/fast/fast_refiner.h"

#include <algorithm>

#include "limn/base/large_vector.h"
#include "limn/fast/limit/limit_forms.h"

namespace limn {

Result<std::optional<FastRefiner::Limit>> approx_fast_limit(const Scheme& scheme,
                                                            const FastRefiner& refiner) {
  fast::LimitReader reader(scheme);
  return refiner.limit(reader);
}

Result<std::optional<FastLimitMesh>> approx_fast_limit_mesh(const Scheme& scheme,
                                                            const FastRefiner& refiner,
                                                            const std::vector<Point3>& positions) {
  using Found = std::optional<FastLimitMesh>;
  const Result<std::optional<FastRefiner::Limit>> limit = approx_fast_limit(scheme, refiner);
  if (!limit) return limit.error();
  if (!*limit) return Found();
  const auto vertices = static_cast<std::size_t>(refiner.vertex_count());
  std::vector<Point3> fine = base::large_vector<Point3>(vertices);
  std::vector<Point3> points = base::large_vector<Point3>(vertices);
  std::vector<Point3> normals = base::large_vector<Point3>(vertices);
  FastRefiner::Scratch<double> scratch;
  refiner.evaluate_limit<double>(**limit, numbers_of(positions), numbers_of(points),
                                 numbers_of(normals), scratch);
  std::copy_n(scratch.refined().data(), 3 * vertices, numbers_of(fine).data());
  return Found({refined_polygons(refiner, std::move(fine)), std::move(points), std::move(normals)});
}

}  // namespace limn
