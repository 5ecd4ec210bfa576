// OpenMesh, Subdivider::Uniform, on ArrayKernel meshes.
//
// Of its two Loops we take LoopT: CompositeLoopT gives the same closed surfaces, but at boundaries
// not the cubic B-spline curve that everyone else has. Both, and Sqrt3T, tabulate the weights of
// valences below 50 and read past the end of the table beyond.

// g++ looks into what it inlines, and warns about that even in system headers
#pragma GCC diagnostic push
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/MidpointT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3InterpolatingSubdividerLabsikGreinerT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#pragma GCC diagnostic pop

#include <stdexcept>

#include "peer.h"

namespace limn::peers {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
struct FloatTraits : OpenMesh::DefaultTraits {};

/// `Subdivider` is one of OpenMesh::Subdivider::Uniform.
template <class Mesh, class Subdivider>
class OpenMeshPeer final : public Peer {
 public:
  using Point = typename Mesh::Point;
  using Real = typename Mesh::Scalar;

  explicit OpenMeshPeer(const Polygons& control) {
    for (const Point3& p : control.positions)
      mesh_.add_vertex(
          Point(static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)));
    std::vector<OpenMesh::VertexHandle> corners;
    for (Index f = 0; f < control.face_count(); ++f) {
      corners.clear();
      for (Index c = control.face_begin[f]; c < control.face_begin[f + 1]; ++c)
        corners.emplace_back(control.corners[c]);
      if (!mesh_.add_face(corners).is_valid()) throw std::runtime_error("OpenMesh refuses a face");
    }
  }

  void refine(int levels) override {
    Subdivider subdivider;
    if (!subdivider(mesh_, static_cast<std::size_t>(levels)))
      throw std::runtime_error("OpenMesh does not refine the mesh");
  }

  [[nodiscard]] std::size_t vertex_count() const override { return mesh_.n_vertices(); }

  [[nodiscard]] Polygons polygons() const override {
    Polygons result;
    for (const auto v : mesh_.vertices()) {
      const Point& p = mesh_.point(v);
      result.positions.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    }
    for (const auto f : mesh_.faces()) {
      for (const auto v : mesh_.fv_range(f)) result.corners.push_back(v.idx());
      result.face_begin.push_back(static_cast<Index>(result.corners.size()));
    }
    return result;
  }

 private:
  Mesh mesh_;
};

template <class Traits, class Real>
std::unique_ptr<Peer> make_peer(Method method, const Polygons& control) {
  namespace uniform = OpenMesh::Subdivider::Uniform;
  using Triangles = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  using Polys = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
  switch (method) {
    case Method::loop:
      return std::make_unique<OpenMeshPeer<Triangles, uniform::LoopT<Triangles, Real>>>(control);
    case Method::catmull_clark:
      return std::make_unique<OpenMeshPeer<Polys, uniform::CatmullClarkT<Polys, Real>>>(control);
    case Method::sqrt3:
      return std::make_unique<OpenMeshPeer<Triangles, uniform::Sqrt3T<Triangles, Real>>>(control);
    case Method::modified_butterfly:
      return std::make_unique<
          OpenMeshPeer<Triangles, uniform::ModifiedButterflyT<Triangles, Real>>>(control);
    case Method::interpolating_sqrt3:
      return std::make_unique<
          OpenMeshPeer<Triangles, uniform::InterpolatingSqrt3LGT<Triangles, Real>>>(control);
    case Method::midedge:
      return std::make_unique<OpenMeshPeer<Polys, uniform::MidpointT<Polys, Real>>>(control);
    case Method::doo_sabin: break;
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<Peer> openmesh_peer(Method method, const Polygons& control, Precision precision) {
  return precision == Precision::double_float ? make_peer<DoubleTraits, double>(method, control)
                                              : make_peer<FloatTraits, float>(method, control);
}

}  // namespace limn::peers
