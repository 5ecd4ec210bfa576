#include "limn/limit/limit_points.h"

namespace limn {

std::string_view to_string(NoCurvature reason) {
  switch (reason) {
    case NoCurvature::none: return "";
    case NoCurvature::boundary: return "on the boundary";
    case NoCurvature::no_limit: return "no limit point there";
    case NoCurvature::no_normal: return "no normal there";
    case NoCurvature::unbounded:
      return "not known to be bounded there, by the vertex's eigenvalues";
    case NoCurvature::regular: return "not bounded wherever the mesh is regular";
    case NoCurvature::direction:
      return "bounded, but another from each side: second derivatives jump there";
    case NoCurvature::not_regular: return "too near to the boundary, or to other irregular places";
    case NoCurvature::unknown: return "not known there";
    case NoCurvature::too_large: break;
  }
  return "beyond the range of numbers";
}

}  // namespace limn
