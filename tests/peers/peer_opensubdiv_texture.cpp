// OpenSubdiv: face-varying values.

#include <opensubdiv/far/primvarRefiner.h>

#include <vector>

#include "opensubdiv_topology.h"
#include "textured_peer.h"

namespace limn::peers {

PeerTextured opensubdiv_textured(Method method, const Polygons& control, const PeerTags& tags,
                                 const PeerTexture& texture, int levels) {
  namespace far = OpenSubdiv::Far;
  const auto refiner = osd_topology(method, control, tags, &texture);
  far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  const far::PrimvarRefinerReal<double> primvars(*refiner);
  std::vector<OsdPoint<double>> points = osd_points<double>(control.positions), values;
  for (const auto& [u, v] : texture.points) values.push_back({u, v, 0});
  for (int level = 1; level <= levels; ++level) {
    const far::TopologyLevel& at = refiner->GetLevel(level);
    std::vector<OsdPoint<double>> fine(static_cast<std::size_t>(at.GetNumVertices()));
    primvars.Interpolate(level, points, fine);
    points.swap(fine);
    std::vector<OsdPoint<double>> fine_values(static_cast<std::size_t>(at.GetNumFVarValues(0)));
    primvars.InterpolateFaceVarying(level, values, fine_values, 0);
    values.swap(fine_values);
  }
  PeerTextured result;
  result.texture.rule = texture.rule;
  result.polygons.positions = points_of(points);
  for (const OsdPoint<double>& value : values) result.texture.points.push_back({value.x, value.y});
  const far::TopologyLevel& level = refiner->GetLevel(levels);
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const far::ConstIndexArray corners = level.GetFaceVertices(f);
    const far::ConstIndexArray of_corner = level.GetFaceFVarValues(f, 0);
    for (int i = 0; i < corners.size(); ++i) {
      result.polygons.corners.push_back(corners[i]);
      result.texture.of_corner.push_back(of_corner[i]);
    }
    result.polygons.face_begin.push_back(static_cast<Index>(result.polygons.corners.size()));
  }
  return result;
}

}  // namespace limn::peers
