#pragma once
/// Parts of a mesh with sharpness: the surroundings of some vertices. Private to crease_limit.

#include <unordered_map>
#include <vector>

#include "limn/mesh/sharpness/sharpness.h"

namespace limn::limit {

/// The faces round some vertices, the *centres*, which are its vertices 0, 1, ….
struct MeshPart {
  Mesh mesh;
  std::vector<Point3> values;
  Sharpness sharpness;  ///< without holes
};

/// Cuts out the faces within some rings of the centres. Where these meet in a vertex only, each fan
/// gets a copy of it.
class PartCutter {
 public:
  /// All must outlive it.
  PartCutter(const Mesh& mesh, const std::vector<Point3>& values, const Sharpness& sharpness)
      : mesh_(mesh), values_(values), sharpness_(sharpness) {}

  /// To be called once. The centres are different and none is isolated. Cost O(size of the part).
  [[nodiscard]] MeshPart run(const std::vector<Index>& centres, int rings);

  /// The number of a half-edge in the part. Precondition: run; its face is there.
  [[nodiscard]] Index number(Index h) const {
    const Index f = mesh_.face(h);
    return first_.at(f) + (h - mesh_.face_begin(f));
  }

 private:
  void find_faces(const std::vector<Index>& centres, int rings);
  void visit_fan(Index v, std::unordered_map<Index, bool>& seen, std::vector<Index>& next);
  [[nodiscard]] Index twin(Index h) const;
  void name_fan(Index h);
  void add(Index h);

  const Mesh& mesh_;
  const std::vector<Point3>& values_;
  const Sharpness& sharpness_;
  std::vector<Index> faces_;
  std::unordered_map<Index, Index> first_;  // of each face of the part, its first half-edge there
  std::vector<Index> vertex_;               // of each half-edge of the part
  Mesh::Arrays arrays_;
  MeshPart part_;
};

/// The part that is left of a part, round its first `centres` vertices.
[[nodiscard]] MeshPart cut_out(const MeshPart& part, Index centres, int rings);

}  // namespace limn::limit
