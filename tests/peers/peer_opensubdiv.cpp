// OpenSubdiv: Far::TopologyRefiner, uniform, and PrimvarRefiner. The boundary is its "edge only"
// interpolation: a cubic B-spline curve, corners rounded like the rest.

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "peer.h"

namespace limn::peers {
namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;

template <class Real>
struct OsdPoint {
  Real x = 0, y = 0, z = 0;

  // NOLINTBEGIN(readability-identifier-naming): the names that PrimvarRefiner calls
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const OsdPoint& point, Real weight) {
    x += weight * point.x;
    y += weight * point.y;
    z += weight * point.z;
  }
  // NOLINTEND(readability-identifier-naming)
};

template <class Real>
class OpenSubdivPeer final : public Peer {
 public:
  OpenSubdivPeer(Method method, const Polygons& control) {
    std::vector<int> degrees;
    for (Index f = 0; f < control.face_count(); ++f) degrees.push_back(control.degree(f));
    far::TopologyDescriptor descriptor;
    descriptor.numVertices = control.vertex_count();
    descriptor.numFaces = control.face_count();
    descriptor.numVertsPerFace = degrees.data();
    descriptor.vertIndicesPerFace = control.corners.data();
    sdc::Options options;
    options.SetVtxBoundaryInterpolation(sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
    const sdc::SchemeType scheme = method == Method::loop ? sdc::SCHEME_LOOP : sdc::SCHEME_CATMARK;
    refiner_.reset(Factory::Create(descriptor, Factory::Options(scheme, options)));
    if (!refiner_) throw std::runtime_error("OpenSubdiv refuses the mesh");
    for (const Point3& p : control.positions)
      points_.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
  }

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
    for (const OsdPoint<Real>& p : points_)
      result.positions.push_back(
          {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
    const far::TopologyLevel& level = refiner_->GetLevel(refiner_->GetMaxLevel());
    for (int f = 0; f < level.GetNumFaces(); ++f) {
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
  if (method != Method::loop && method != Method::catmull_clark) return nullptr;
  if (precision == Precision::double_float)
    return std::make_unique<OpenSubdivPeer<double>>(method, control);
  return std::make_unique<OpenSubdivPeer<float>>(method, control);
}

}  // namespace limn::peers
