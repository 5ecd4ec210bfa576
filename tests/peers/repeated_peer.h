#pragma once
/// Other people's evaluation of positions again and again, the topology being known, behind one
/// interface; see peer.h.

#include <memory>
#include <vector>

#include "peer.h"

namespace limn::peers {

class RepeatedPeer {
 public:
  RepeatedPeer() = default;
  RepeatedPeer(const RepeatedPeer&) = delete;
  RepeatedPeer& operator=(const RepeatedPeer&) = delete;
  virtual ~RepeatedPeer() = default;

  /// The refined positions from those of the control vertices, anew.
  virtual void evaluate() = 0;
  [[nodiscard]] virtual std::size_t vertex_count() const = 0;
  /// As `opensubdiv_peer` numbers them.
  [[nodiscard]] virtual std::vector<Point3> points() const = 0;
};

/// OpenSubdiv's Far::StencilTable of the last level's vertices from the control vertices;
/// `evaluate` is its UpdateValues, over chunks where limn's loops may use more than one thread.
/// nullptr where the library has no such method; throws std::runtime_error where it refuses the
/// mesh. `levels` ≥ 1.
[[nodiscard]] std::unique_ptr<RepeatedPeer> opensubdiv_stencils(
    Method method, const Polygons& control, int levels,
    Precision precision = Precision::double_float, const PeerTags& tags = {});

/// The same by Far::PrimvarRefiner, level by level, without tables.
[[nodiscard]] std::unique_ptr<RepeatedPeer> opensubdiv_primvars(
    Method method, const Polygons& control, int levels,
    Precision precision = Precision::double_float, const PeerTags& tags = {});

}  // namespace limn::peers
