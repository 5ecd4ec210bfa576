// OpenSubdiv: Far::TopologyRefiner, uniform, and PrimvarRefiner.

#include <opensubdiv/far/primvarRefiner.h>

#include <cmath>
#include <vector>

#include "opensubdiv_topology.h"
#include "peer.h"

namespace limn::peers {
namespace {

namespace far = OpenSubdiv::Far;

template <class Real>
class OpenSubdivPeer final : public Peer {
 public:
  OpenSubdivPeer(Method method, const Polygons& control, const PeerTags& tags)
      : refiner_(osd_topology(method, control, tags)),
        points_(osd_points<Real>(control.positions)) {}

  void refine(int levels) override {
    far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = full_topology_;
    refiner_->RefineUniform(uniform);
    const far::PrimvarRefinerReal<Real> primvars(*refiner_);
    for (int level = 1; level <= levels; ++level) {
      std::vector<OsdPoint<Real>> fine(
          static_cast<std::size_t>(refiner_->GetLevel(level).GetNumVertices()));
      primvars.Interpolate(level, points_, fine);
      points_.swap(fine);
    }
  }

  void want_limit() override { full_topology_ = true; }

  bool move_to_limit(double offset) override {
    std::vector<OsdPoint<Real>> limit(points_.size());
    std::vector<OsdPoint<Real>> u(points_.size());
    std::vector<OsdPoint<Real>> v(points_.size());
    const far::TopologyLevel& level = refiner_->GetLevel(refiner_->GetMaxLevel());
    far::PrimvarRefinerReal<Real>(*refiner_).Limit(points_, limit, u, v);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Real x = u[i].y * v[i].z - u[i].z * v[i].y;
      const Real y = u[i].z * v[i].x - u[i].x * v[i].z;
      const Real z = u[i].x * v[i].y - u[i].y * v[i].x;
      const bool boundary = level.IsVertexBoundary(static_cast<int>(i));
      const Real scale =
          boundary ? 0 : static_cast<Real>(offset) / std::sqrt(x * x + y * y + z * z);
      points_[i] = {limit[i].x + scale * x, limit[i].y + scale * y, limit[i].z + scale * z};
    }
    return true;
  }

  [[nodiscard]] std::size_t vertex_count() const override { return points_.size(); }

  [[nodiscard]] Polygons polygons() const override {
    Polygons result;
    result.positions = points_of(points_);
    const far::TopologyLevel& level = refiner_->GetLevel(refiner_->GetMaxLevel());
    for (int f = 0; f < level.GetNumFaces(); ++f) {
      if (level.IsFaceHole(f)) continue;
      const far::ConstIndexArray corners = level.GetFaceVertices(f);
      for (int i = 0; i < corners.size(); ++i) result.corners.push_back(corners[i]);
      result.face_begin.push_back(static_cast<Index>(result.corners.size()));
    }
    return result;
  }

 private:
  std::unique_ptr<far::TopologyRefiner> refiner_;
  std::vector<OsdPoint<Real>> points_;
  bool full_topology_ = false;
};

}  // namespace

std::unique_ptr<Peer> opensubdiv_peer(Method method, const Polygons& control, Precision precision) {
  return opensubdiv_peer(method, control, PeerTags(), precision);
}

std::unique_ptr<Peer> opensubdiv_peer(Method method, const Polygons& control, const PeerTags& tags,
                                      Precision precision) {
  if (!osd_has(method)) return nullptr;
  if (precision == Precision::double_float)
    return std::make_unique<OpenSubdivPeer<double>>(method, control, tags);
  return std::make_unique<OpenSubdivPeer<float>>(method, control, tags);
}

}  // namespace limn::peers
