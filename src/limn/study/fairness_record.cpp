#include "limn/study/fairness_record.h"

#include <algorithm>
#include <cmath>

#include "limn/base/memory.h"
#include "limn/fairness/laplacian.h"
#include "limn/fairness/second_form.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/refine/refine_estimate.h"
#include "limn/surface/refine_surface.h"

namespace limn::study {
namespace {

constexpr int kMostLevels = 12;  // of meshes that hardly grow
// refined and limit points, normals, and what is fitted
constexpr std::size_t kBytesPerVertex = 3 * sizeof(Point3) + sizeof(fairness::SecondForm);

int default_levels(const Scheme& scheme, const Mesh& control) {
  int levels = 1;
  while (levels < kMostLevels &&
         refine::estimate_refinement(*scheme.split, control, levels + 1, sizeof(Point3)).vertices <=
             kFairnessVertices)
    ++levels;
  return levels;
}

/// What rounding alone may have made is nothing.
void clear_rounding(FairnessLevel& level) {
  const auto clear = [](double& value, double rounding) {
    if (value <= rounding) value = 0;
  };
  clear(level.laplacian_energy, level.laplacian_rounding);
  clear(level.energies.area, level.energies.rounding.area);
  clear(level.energies.thin_plate, level.energies.rounding.thin_plate);
  clear(level.energies.curvature_variation, level.energies.rounding.curvature_variation);
}

Result<FairnessLevel> measured(const Scheme& scheme, const Mesh& control,
                               const std::vector<Point3>& points, int level,
                               std::vector<LimitPoints::Refused>* refused) {
  Result<RefinedSurface> surface = refine_surface(
      scheme, control, points,
      {.levels = level, .limit = true, .partial = refused != nullptr, .connectivity = true});
  if (!surface) return surface.error();
  if (refused != nullptr) *refused = std::move(surface->gaps.limits);
  const Mesh& fine = *surface->mesh;
  const std::vector<Point3>& positions = surface->limit;
  const Result<SurfaceEnergies> energies = approx_energies(fine, positions);
  if (!energies) return energies.error();
  FairnessLevel result;
  result.level = level;
  result.vertices = fine.vertex_count();
  result.faces = fine.face_count();
  result.energies = *energies;
  result.laplacian_energy = fairness::laplacian_energy(fine, positions);
  result.laplacian_rounding =
      fairness::laplacian_rounding(fine, positions, result.laplacian_energy);
  clear_rounding(result);
  result.scaled_laplacian =
      result.laplacian_energy * std::pow(scheme.split->dilation.growth(), level);
  return result;
}

template <class Value>
fairness::Trend trend_over(const FairnessRecord& record, Value value, double negligible) {
  std::vector<double> values;
  values.reserve(record.levels.size());
  for (const FairnessLevel& level : record.levels) values.push_back(value(level));
  return fairness::trend_of(values, negligible);
}

/// Changes that are none: what rounding makes, and what is far below the energies of a surface of
/// this area that bends.
void set_trends(FairnessRecord& record) {
  constexpr double kNegligible = 1e-9;
  const FairnessLevel& last = record.last();
  const SurfaceEnergies::Rounding& rounding = last.energies.rounding;
  const double area = last.energies.area > rounding.area ? last.energies.area : 0;
  const double least = area > 0 ? kNegligible : 0;
  record.area = trend_over(
      record, [](const auto& l) { return l.energies.area; }, rounding.area);
  record.thin_plate = trend_over(
      record, [](const auto& l) { return l.energies.thin_plate; },
      std::max(least, rounding.thin_plate));
  record.curvature_variation = trend_over(
      record, [](const auto& l) { return l.energies.curvature_variation; },
      std::max(area > 0 ? least / area : 0, rounding.curvature_variation));
  const double scale =
      last.laplacian_energy > 0 ? last.scaled_laplacian / last.laplacian_energy : 1;
  record.scaled_laplacian = trend_over(
      record, [](const auto& l) { return l.scaled_laplacian; },
      std::max(least * area, last.laplacian_rounding * scale));
}

}  // namespace

Result<FairnessRecord> approx_fairness(const std::string& label, const Scheme& scheme,
                                       const Mesh& control, const std::vector<Point3>& points,
                                       const FairnessOptions& options) {
  const int levels = options.levels > 0 ? options.levels : default_levels(scheme, control);
  const Status refinable =
      refine::check_refinable(scheme, control, levels, kBytesPerVertex, base::available_memory());
  if (!refinable) return refinable.error();
  if (Status squares = mesh::check_squares(points); !squares) return squares.error();
  FairnessRecord record;
  record.scheme = label;
  record.split = scheme.split->name;
  record.growth = scheme.split->dilation.growth();
  for (int level = 1; level <= levels; ++level) {
    if (options.progress) options.progress(level, levels);
    const Result<FairnessLevel> row =
        measured(scheme, control, points, level, options.partial ? &record.refused : nullptr);
    if (!row) return row.error();
    record.levels.push_back(*row);
  }
  set_trends(record);
  return record;
}

}  // namespace limn::study
