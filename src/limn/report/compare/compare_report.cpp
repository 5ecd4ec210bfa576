#include "limn/report/compare/compare_report.h"

#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/refine/refine.h"
#include "limn/report/compare/compare_rows.h"
#include "limn/report/compare/record_json.h"
#include "limn/study/surface_scenes.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const Point3& p) { return {p.x, p.y, p.z}; }

Json distance_json(const MeshComparison& on_mesh, const PairDistance& pair) {
  const mesh::SurfaceDistance& distance = pair.distance;
  return {{"a", on_mesh.surfaces[pair.first].name},
          {"b", on_mesh.surfaces[pair.second].name},
          {"largest", distance.largest},
          {"mean", distance.mean},
          {"relative", distance.largest / distance.diagonal},
          {"at", {point_json(distance.where[0]), point_json(distance.where[1])}}};
}

/// fairness_json's object of one scheme.
Json one_fairness_json(const std::string& mesh, const Result<study::FairnessRecord>& record) {
  if (!record) return {};
  return fairness_json(mesh, {*record}).at("schemes").at(0);
}

std::string distances_text(const MeshComparison& on_mesh) {
  if (on_mesh.distances.empty()) return {};
  std::string text =
      fmt::format("\ndistance of limit surfaces over {}\n", base::printable(on_mesh.mesh));
  for (const PairDistance& pair : on_mesh.distances) {
    const Point3& at = pair.distance.where[0];
    text += fmt::format("  {} – {}: {}; largest at ({:.4g}, {:.4g}, {:.4g})\n",
                        base::printable(on_mesh.surfaces[pair.first].name),
                        base::printable(on_mesh.surfaces[pair.second].name),
                        distance_text(pair.distance), at.x, at.y, at.z);
  }
  return text;
}

/// That make about as many faces as so many steps of a dyadic split.
int steps_of(const Split& split, int steps) {
  const double growth = std::log(split.dilation.growth()) / std::log(4.0);
  return static_cast<int>(std::lround(steps / growth));
}

}  // namespace

Status check_steps(const std::vector<LabelledScheme>& schemes, const Mesh& mesh,
                   const MeshOptions& options) {
  for (const auto& [label, scheme] : schemes) {
    const auto check = [&, &scheme = scheme](int steps) {
      return refine::check_refinable(scheme, mesh, steps, sizeof(Point3), base::available_memory());
    };
    if (!check(0)) continue;  // its surface is missing whatever the steps
    Status status = check(steps_of(*scheme.split, options.steps));
    if (!status) {
      status.error().message = label + ": " + status.error().message;
      return status;
    }
  }
  return Done{};
}

MeshComparison compare_on_mesh(const std::vector<LabelledScheme>& schemes, const std::string& name,
                               const Mesh& mesh, const std::vector<Point3>& points,
                               const MeshOptions& options) {
  const auto begin = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  MeshComparison on_mesh{.mesh = name};
  for (const auto& [label, scheme] : schemes) {
    begin(label + ": limit surface");
    LimitGaps& gaps = on_mesh.gaps.emplace_back();
    Result<figure::SmoothSurface> surface =
        study::limit_surface(scheme, mesh, points, steps_of(*scheme.split, options.steps), &gaps);
    if (!surface) {
      on_mesh.missing.push_back(label + ": " + surface.error().message);
      on_mesh.fairness.emplace_back(surface.error());
      continue;
    }
    on_mesh.surfaces.push_back({label, std::move(*surface)});
    on_mesh.fairness.push_back(study::approx_fairness(
        label, scheme, mesh, points,
        {.levels = options.fairness_levels,
         .progress =
             [&](int level, int levels) {
               begin(fmt::format("{}: fairness, level {} of {}", label, level, levels));
             },
         .partial = true}));
    if (const auto& fairness = on_mesh.fairness.back(); !fairness)
      on_mesh.missing.push_back(label + ": " + fairness.error().message);
  }
  Result<std::vector<PairDistance>> distances = approx_distances(
      on_mesh.surfaces,
      [&](const std::string& a, const std::string& b) { begin("distance of " + a + " and " + b); });
  if (distances)
    on_mesh.distances = std::move(*distances);
  else
    on_mesh.missing.push_back(distances.error().message);
  return on_mesh;
}

Warnings gap_warnings(const MeshComparison& comparison,
                      const std::vector<LabelledScheme>& schemes) {
  Warnings warnings;
  for (std::size_t i = 0; i < schemes.size(); ++i)
    for (Error& warning :
         gaps_text(comparison.gaps[i],
                   {.mesh = comparison.mesh, .normal = kLeftOutOfPictures, .curvatures = ""})) {
      warning.message = fmt::format("{}, refined: {}", schemes[i].label, warning.message);
      warnings.push_back(std::move(warning));
    }
  return warnings;
}

std::string missing_text(const Comparison& comparison) {
  std::string text;
  for (const study::SchemeRecord& scheme : comparison.schemes)
    for (const std::string& reason : study::missing_parts(scheme))
      text += fmt::format("  {}: {}\n", base::printable(scheme.label), base::printable(reason));
  if (comparison.on_mesh)
    for (const std::string& reason : comparison.on_mesh->missing)
      text += "  " + base::printable(reason) + "\n";
  return text.empty() ? text : "\nmissing (–)\n" + text;
}

std::string compare_text(const Comparison& comparison, bool differences) {
  std::vector<std::string> labels;
  labels.reserve(comparison.schemes.size());
  for (const study::SchemeRecord& scheme : comparison.schemes)
    labels.push_back(base::printable(scheme.label));
  std::string text = table_text(labels, compare_sections(comparison), differences);
  if (comparison.on_mesh) text += distances_text(*comparison.on_mesh);
  return text + missing_text(comparison) +
         "\n* the best of its line; ? an energy whose limit is not known\n";
}

nlohmann::ordered_json compare_json(const Comparison& comparison) {
  const std::optional<MeshComparison>& on_mesh = comparison.on_mesh;
  Json json{{"tolerance_percent", comparison.tolerance},
            {"mesh", on_mesh ? Json(on_mesh->mesh) : Json()},
            {"schemes", Json::array()},
            {"distances", Json::array()},
            {"missing", Json::array()}};
  for (std::size_t i = 0; i < comparison.schemes.size(); ++i) {
    Json record = record_json(comparison.schemes[i]);
    if (on_mesh) record["gaps"] = gaps_json(on_mesh->gaps[i]);
    if (on_mesh) record["fairness"] = one_fairness_json(on_mesh->mesh, on_mesh->fairness[i]);
    json["schemes"].push_back(std::move(record));
  }
  if (!on_mesh) return json;
  for (const PairDistance& pair : on_mesh->distances)
    json["distances"].push_back(distance_json(*on_mesh, pair));
  json["missing"] = on_mesh->missing;
  return json;
}

}  // namespace limn::report
