#include "limn/report/fairness_record.h"

#include <cmath>

#include "limn/extraordinary/limit_points.h"
#include "limn/fairness/laplacian.h"
#include "limn/fairness/second_form.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

constexpr int kMostLevels = 12;  // of meshes that hardly grow
// refined and limit points, normals, and what is fitted
constexpr std::size_t kBytesPerVertex = 3 * sizeof(Point3) + sizeof(SecondForm);

int default_levels(const Scheme& scheme, const Mesh& control) {
  int levels = 1;
  while (levels < kMostLevels &&
         estimate_refinement(*scheme.split, control, levels + 1, sizeof(Point3)).vertices <=
             kFairnessVertices)
    ++levels;
  return levels;
}

Result<FairnessLevel> measured(const Scheme& scheme, const Refined<Point3>& fine, int level) {
  LimitOptions options;
  options.steps_made = level;
  const Result<LimitPoints> limit = approx_limit_points(scheme, fine.mesh, fine.values, options);
  if (!limit) return limit.error();
  const Result<SurfaceEnergies> energies = approx_energies(fine.mesh, limit->positions);
  if (!energies) return energies.error();
  FairnessLevel result;
  result.level = level;
  result.vertices = fine.mesh.vertex_count();
  result.faces = fine.mesh.face_count();
  result.laplacian_energy = laplacian_energy(fine.mesh, limit->positions);
  result.scaled_laplacian =
      result.laplacian_energy * std::pow(scheme.split->dilation.growth(), level);
  result.energies = *energies;
  return result;
}

template <class Value>
Trend trend_over(const FairnessRecord& record, Value value, double negligible) {
  std::vector<double> values;
  values.reserve(record.levels.size());
  for (const FairnessLevel& level : record.levels) values.push_back(value(level));
  return trend_of(values, negligible);
}

/// What rounding makes of a plane, at the densest sampling, is far below these.
void set_trends(FairnessRecord& record) {
  constexpr double kNegligible = 1e-9;
  const double area = record.last().energies.area;
  const double least = area > 0 ? kNegligible : 0;
  record.area = trend_over(
      record, [](const auto& l) { return l.energies.area; }, 0);
  record.thin_plate = trend_over(
      record, [](const auto& l) { return l.energies.thin_plate; }, least);
  record.curvature_variation = trend_over(
      record, [](const auto& l) { return l.energies.curvature_variation; },
      area > 0 ? least / area : 0);
  record.scaled_laplacian = trend_over(
      record, [](const auto& l) { return l.scaled_laplacian; }, least * area);
}

}  // namespace

Result<FairnessRecord> approx_fairness(const std::string& label, const Scheme& scheme,
                                       const Mesh& control, const std::vector<Point3>& points,
                                       const FairnessOptions& options) {
  const int levels = options.levels > 0 ? options.levels : default_levels(scheme, control);
  const Status refinable =
      check_refinable(scheme, control, levels, kBytesPerVertex, available_memory());
  if (!refinable) return refinable.error();
  FairnessRecord record;
  record.scheme = label;
  record.split = scheme.split->name;
  record.growth = scheme.split->dilation.growth();
  RuleTables<double> tables(scheme);
  Refined<Point3> fine{control, points};
  for (int level = 1; level <= levels; ++level) {
    if (options.progress) options.progress(level, levels);
    Result<Refined<Point3>> next = refine_once(scheme, fine.mesh, fine.values, level - 1, tables);
    if (!next) return next.error();
    fine = std::move(*next);
    const Result<FairnessLevel> row = measured(scheme, fine, level);
    if (!row) return row.error();
    record.levels.push_back(*row);
  }
  set_trends(record);
  return record;
}

}  // namespace limn
