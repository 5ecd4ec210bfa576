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
  std::vector<Index> normals;
  struct Curvatures {
    NoCurvature reason;
    std::vector<Index> vertices;
  };
  std::vector<Curvatures> curvatures;  ///< by reason

  [[nodiscard]] bool any() const {
    return !limits.empty() || !normals.empty() || !curvatures.empty();
  }
};

/// The vertices whose normal is zero.
[[nodiscard]] std::vector<Index> without_normal(const std::vector<Point3>& normals);
/// The vertices that have no curvature, by reason.
[[nodiscard]] std::vector<LimitGaps::Curvatures> without_curvature(
    const std::vector<NoCurvature>& reasons);

/// Where the results of a limit surface go, for messages.
struct GapPlaces {
  std::string mesh;        ///< the file that has its vertices; empty: none
  std::string normal;      ///< what becomes of a normal that is missing
  std::string curvatures;  ///< the file that has its curvatures
};
/// What GapPlaces::normal is where a surface is drawn.
inline constexpr const char* kLeftOutOfPictures = "pictures leave out the triangles there";
/// A sentence for each kind that is missing and each reason, with the file it is missing from;
/// vertices are counted from 0, as those of the refined mesh, and only the first few are named.
[[nodiscard]] Warnings gaps_text(const LimitGaps& gaps, const GapPlaces& places);
/// {"limits", "normals", "curvatures"} of what is missing, each {"count", "vertices": all, counted
/// from 0, "reasons": [{"reason", "vertices"}]}, the last not of normals.
[[nodiscard]] nlohmann::ordered_json gaps_json(const LimitGaps& gaps);

}  // namespace limn
