#pragma once
/// Where something asked of the limit surface cannot be had, in words and in JSON.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/surface/refine_surface.h"

namespace limn::report {

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

}  // namespace limn::report
