// OpenSubdiv: face-varying values.

#include <opensubdiv/far/primvarRefiner.h>

#include <vector>

#include "opensubdiv_topology.h"
#include "textured_peer.h"

namespace limn::peers {
namespace {

namespace far = OpenSubdiv::Far;

/// Positions, and points of a texture.
template <class Real>
struct Channels {
  std::vector<OsdPoint<Real>> points, values;
};

template <class Real>
Channels<Real> channels(const Polygons& control, const PeerTexture& texture) {
  Channels<Real> all{osd_points<Real>(control.positions), {}};
  for (const auto& [u, v] : texture.points)
    all.values.push_back({static_cast<Real>(u), static_cast<Real>(v), 0});
  return all;
}

template <class Real>
void refine(far::TopologyRefiner& refiner, int levels, Channels<Real>& all) {
  far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner.RefineUniform(uniform);
  const far::PrimvarRefinerReal<Real> primvars(refiner);
  for (int level = 1; level <= levels; ++level) {
    const far::TopologyLevel& at = refiner.GetLevel(level);
    std::vector<OsdPoint<Real>> fine(static_cast<std::size_t>(at.GetNumVertices()));
    primvars.Interpolate(level, all.points, fine);
    all.points.swap(fine);
    std::vector<OsdPoint<Real>> fine_values(static_cast<std::size_t>(at.GetNumFVarValues(0)));
    primvars.InterpolateFaceVarying(level, all.values, fine_values, 0);
    all.values.swap(fine_values);
  }
}

class TexturedPeer final : public Peer {
 public:
  TexturedPeer(Method method, const Polygons& control, const PeerTexture& texture)
      : refiner_(osd_topology(method, control, {}, &texture)),
        all_(channels<float>(control, texture)) {}

  void refine(int levels) override { peers::refine(*refiner_, levels, all_); }
  [[nodiscard]] std::size_t vertex_count() const override { return all_.points.size(); }
  /// Positions alone.
  [[nodiscard]] Polygons polygons() const override {
    Polygons result;
    result.positions = points_of(all_.points);
    return result;
  }

 private:
  std::unique_ptr<far::TopologyRefiner> refiner_;
  Channels<float> all_;
};

}  // namespace

std::unique_ptr<Peer> opensubdiv_textured_peer(Method method, const Polygons& control,
                                               const PeerTexture& texture) {
  if (!osd_has(method)) return nullptr;
  return std::make_unique<TexturedPeer>(method, control, texture);
}

PeerTextured opensubdiv_textured(Method method, const Polygons& control, const PeerTags& tags,
                                 const PeerTexture& texture, int levels) {
  const auto refiner = osd_topology(method, control, tags, &texture);
  Channels<double> all = channels<double>(control, texture);
  refine(*refiner, levels, all);
  PeerTextured result;
  result.texture.rule = texture.rule;
  result.polygons.positions = points_of(all.points);
  for (const OsdPoint<double>& value : all.values)
    result.texture.points.push_back({value.x, value.y});
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
