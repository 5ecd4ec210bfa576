#pragma once
/// Other people's subdivision libraries behind one interface, for tests and benchmarks: a mesh
/// of theirs, made from a control mesh of ours, that refines itself. Nothing of theirs shows in
/// this header; each library has one source file, peer_NAME.cpp.

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::peers {

enum class Method {
  loop,
  catmull_clark,
  sqrt3,
  doo_sabin,
  modified_butterfly,
  interpolating_sqrt3,
  midedge
};

/// The numbers that hold the positions.
enum class Precision { single_float, double_float };

/// What is sharp in a control mesh, in OpenSubdiv's terms.
struct PeerTags {
  std::vector<std::array<Index, 2>> edges;  ///< by their ends
  std::vector<float> edge_sharpness;        ///< of each
  std::vector<Index> corners;               ///< vertices
  std::vector<float> corner_sharpness;      ///< of each
  std::vector<Index> holes;                 ///< faces
  int boundary = 1;                         ///< 0 none, 1 edge only, 2 edge and corner
  bool chaikin = false, smooth_triangles = false;
};

class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  /// `levels` steps. At most once per object: for √3 the parity of a step counts from the call.
  virtual void refine(int levels) = 0;

  /// To be called before `refine`, where `move_to_limit` shall follow.
  virtual void want_limit() {}
  /// Moves the points to the limit surface, and from there by `offset` along its unit normal
  /// (on the boundary not). False where the library has no limit surface. Once, after `refine`.
  virtual bool move_to_limit(double offset) {
    (void)offset;
    return false;
  }

  [[nodiscard]] virtual std::size_t vertex_count() const = 0;
  /// The mesh as it now is, in the library's own order of vertices and faces.
  [[nodiscard]] virtual Polygons polygons() const = 0;
};

/// A mesh of that library; nullptr where it has no such method. Throws std::runtime_error where
/// the library refuses the mesh.
[[nodiscard]] std::unique_ptr<Peer> cgal_peer(Method method, const Polygons& control);
[[nodiscard]] std::unique_ptr<Peer> openmesh_peer(Method method, const Polygons& control,
                                                  Precision precision = Precision::double_float);
[[nodiscard]] std::unique_ptr<Peer> opensubdiv_peer(Method method, const Polygons& control,
                                                    Precision precision = Precision::double_float);
/// With sharpness; its polygons are those that are no holes, with all vertices.
[[nodiscard]] std::unique_ptr<Peer> opensubdiv_peer(Method method, const Polygons& control,
                                                    const PeerTags& tags,
                                                    Precision precision = Precision::double_float);

}  // namespace limn::peers
