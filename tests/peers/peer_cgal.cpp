// CGAL, package Surface Subdivision Methods, on Surface_mesh with doubles.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <stdexcept>

#include "peer.h"

namespace limn::peers {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

class CgalPeer final : public Peer {
 public:
  CgalPeer(Method method, const Polygons& control) : method_(method) {
    for (const Point3& p : control.positions) mesh_.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (Index f = 0; f < control.face_count(); ++f) {
      corners.clear();
      for (Index c = control.face_begin[f]; c < control.face_begin[f + 1]; ++c)
        corners.emplace_back(static_cast<SurfaceMesh::size_type>(control.corners[c]));
      if (mesh_.add_face(corners) == SurfaceMesh::null_face())
        throw std::runtime_error("CGAL refuses a face");
    }
  }

  void refine(int levels) override {
    namespace subdivide = CGAL::Subdivision_method_3;
    const auto steps = CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels));
    switch (method_) {
      case Method::loop: return subdivide::Loop_subdivision(mesh_, steps);
      case Method::catmull_clark: return subdivide::CatmullClark_subdivision(mesh_, steps);
      case Method::sqrt3: return subdivide::Sqrt3_subdivision(mesh_, steps);
      case Method::doo_sabin: return subdivide::DooSabin_subdivision(mesh_, steps);
      case Method::modified_butterfly:
      case Method::interpolating_sqrt3:
      case Method::midedge: break;
    }
  }

  [[nodiscard]] std::size_t vertex_count() const override { return mesh_.number_of_vertices(); }

  [[nodiscard]] Polygons polygons() const override {
    Polygons result;
    std::vector<Index> number(mesh_.num_vertices(), kNone);  // removed ones have indices too
    for (const auto v : mesh_.vertices()) {
      number[static_cast<std::size_t>(v)] = result.vertex_count();
      const Kernel::Point_3& p = mesh_.point(v);
      result.positions.push_back({p.x(), p.y(), p.z()});
    }
    for (const auto f : mesh_.faces()) {
      for (const auto v : mesh_.vertices_around_face(mesh_.halfedge(f)))
        result.corners.push_back(number[static_cast<std::size_t>(v)]);
      result.face_begin.push_back(static_cast<Index>(result.corners.size()));
    }
    return result;
  }

 private:
  Method method_;
  SurfaceMesh mesh_;
};

}  // namespace

std::unique_ptr<Peer> cgal_peer(Method method, const Polygons& control) {
  if (method == Method::modified_butterfly || method == Method::interpolating_sqrt3 ||
      method == Method::midedge)
    return nullptr;
  return std::make_unique<CgalPeer>(method, control);
}

}  // namespace limn::peers
