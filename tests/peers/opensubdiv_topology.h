#pragma once
/// What the adapters of OpenSubdiv share; see peer.h for why no other file includes this.

#include <opensubdiv/far/topologyDescriptor.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "textured_peer.h"

namespace limn::peers {

template <class Real>
struct OsdPoint {
  Real x = 0, y = 0, z = 0;

  // NOLINTBEGIN(readability-identifier-naming): the names that the library calls
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const OsdPoint& point, Real weight) {
    x += weight * point.x;
    y += weight * point.y;
    z += weight * point.z;
  }
  // NOLINTEND(readability-identifier-naming)
};

template <class Real>
std::vector<OsdPoint<Real>> osd_points(const std::vector<Point3>& points) {
  std::vector<OsdPoint<Real>> result;
  result.reserve(points.size());
  for (const Point3& p : points)
    result.push_back({static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)});
  return result;
}

template <class Real>
std::vector<Point3> points_of(const std::vector<OsdPoint<Real>>& points) {
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const OsdPoint<Real>& p : points)
    result.push_back(
        {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
  return result;
}

inline bool osd_has(Method method) {
  return method == Method::loop || method == Method::catmull_clark;
}

/// Boundaries are "edge only", unless the tags say else: cubic B-spline curves, corners rounded
/// like the rest.
inline std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> osd_topology(
    Method method, const Polygons& control, const PeerTags& tags = {},
    const PeerTexture* texture = nullptr) {
  namespace far = OpenSubdiv::Far;
  namespace sdc = OpenSubdiv::Sdc;
  std::vector<int> degrees;
  for (Index f = 0; f < control.face_count(); ++f) degrees.push_back(control.degree(f));
  far::TopologyDescriptor descriptor;
  descriptor.numVertices = control.vertex_count();
  descriptor.numFaces = control.face_count();
  descriptor.numVertsPerFace = degrees.data();
  descriptor.vertIndicesPerFace = control.corners.data();
  descriptor.numCreases = static_cast<int>(tags.edges.size());
  descriptor.creaseVertexIndexPairs = tags.edges.empty() ? nullptr : tags.edges.front().data();
  descriptor.creaseWeights = tags.edge_sharpness.data();
  descriptor.numCorners = static_cast<int>(tags.corners.size());
  descriptor.cornerVertexIndices = tags.corners.data();
  descriptor.cornerWeights = tags.corner_sharpness.data();
  descriptor.numHoles = static_cast<int>(tags.holes.size());
  descriptor.holeIndices = tags.holes.data();
  sdc::Options options;
  options.SetVtxBoundaryInterpolation(
      static_cast<sdc::Options::VtxBoundaryInterpolation>(tags.boundary));
  if (tags.chaikin) options.SetCreasingMethod(sdc::Options::CREASE_CHAIKIN);
  if (tags.smooth_triangles) options.SetTriangleSubdivision(sdc::Options::TRI_SUB_SMOOTH);
  far::TopologyDescriptor::FVarChannel channel;
  if (texture != nullptr) {
    options.SetFVarLinearInterpolation(
        static_cast<sdc::Options::FVarLinearInterpolation>(texture->rule));
    channel.numValues = static_cast<int>(texture->points.size());
    channel.valueIndices = texture->of_corner.data();
    descriptor.numFVarChannels = 1;
    descriptor.fvarChannels = &channel;
  }
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  const sdc::SchemeType scheme = method == Method::loop ? sdc::SCHEME_LOOP : sdc::SCHEME_CATMARK;
  std::unique_ptr<far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(scheme, options)));
  if (!refiner) throw std::runtime_error("OpenSubdiv refuses the mesh");
  return refiner;
}

}  // namespace limn::peers
