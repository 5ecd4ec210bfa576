#include "limn/mesh/polygons.h"

namespace limn {

Polygons triangulated(const Polygons& polygons) {
  Polygons result;
  result.positions = polygons.positions;
  result.corners.reserve(3 * polygons.corners.size());
  const auto close_face = [&result] {
    result.face_begin.push_back(static_cast<Index>(result.corners.size()));
  };
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const Index first = polygons.face_begin[f], last = polygons.face_begin[f + 1];
    if (last - first <= 3) {  // a face too small is kept for Mesh::build to refuse
      for (Index c = first; c < last; ++c) result.corners.push_back(polygons.corners[c]);
      close_face();
      continue;
    }
    for (Index c = first + 1; c + 1 < last; ++c) {
      result.corners.push_back(polygons.corners[first]);
      result.corners.push_back(polygons.corners[c]);
      result.corners.push_back(polygons.corners[c + 1]);
      close_face();
    }
  }
  return result;
}

}  // namespace limn
