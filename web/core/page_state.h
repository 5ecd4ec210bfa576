#pragma once
/// What a page has loaded, by number. Private to web/core.

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "answer.h"
#include "limn/fast/fast_refiner.h"
#include "limn/mesh/sharpness/cuts.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/mesh/split/edge_paths.h"
#include "limn/scheme/parameter_setter.h"
#include "limn/spectrum/frequency_blocks.h"
#include "limn/study/artifact_values.h"
#include "limn/surface/refine_surface.h"
#include "page_core.h"

namespace limn::page {

inline constexpr int kMostValence = 128;
inline constexpr int kMostLevels = 10;
inline constexpr double kMostVertices = 2e6;  // of a refined mesh, as a page can draw it
inline constexpr double kMostBytes = 1.2e9;   // of the 2 GiB that WebAssembly may have

/// A text that was read, before any parameter is set.
struct ReadText {
  std::string text;
  scheme::ParameterSetter setter;
  std::vector<bool> integers;  ///< of each parameter whether whole numbers alone are taken
  Json features, reasons;      ///< what can be asked of it, and why the rest cannot
};

struct LoadedScheme {
  Scheme scheme;
  std::optional<FrequencyAnalysis> frequencies;  // made when asked for; refer to `scheme`
  std::optional<study::NamedAnalysis> lattice;
  study::SamplingDensities densities;
};

struct LoadedMesh {
  Mesh mesh;
  std::vector<Point3> points;
  Sharpness sharpness;
  mesh::Cuts cuts;  ///< what repair has cut
  TextureCoordinates texture;
  int moves = 0;  ///< how often a vertex was moved
};

/// Keeps what it was made of, whatever becomes of the numbers.
struct LoadedPlan {
  std::shared_ptr<LoadedScheme> scheme;
  std::shared_ptr<LoadedMesh> mesh;
  int levels = 0;
  bool limit = true, normals = true;
  Sharpness sharpness;                       ///< that of the mesh when it was made
  std::string reason;                        ///< why there is no limit, or not everywhere
  bool textured = false;                     ///< whether texture coordinates are wanted
  std::vector<bool> without_limit;           ///< of vertices; empty: none
  std::string pattern = "none", no_texture;  ///< as PageCore::texture says them
  std::vector<float> texture;                ///< of the triangles' corners
  std::optional<FastRefiner> refiner;        ///< nothing: the plain engine
  std::optional<FastRefiner::Limit> on_limit;
  FastRefiner::Scratch<float> scratch;
  Polygons refined;  ///< faces; with positions where the plain engine makes them
  /// As of `moves`, as they are drawn; normals that the surface does not have are sums of faces'.
  std::vector<float> positions, normals_there;
  bool has_limit = false, has_normals = false;  ///< what these are
  int moves = -1;                               ///< of the mesh, when they were made
  std::optional<mesh::EdgePaths> lines;
};

/// Things by number, from 1.
template <class Thing>
class Numbered {
 public:
  explicit Numbered(const char* what) : what_(what) {}
  int add(std::shared_ptr<Thing> thing) {
    things_.emplace(++last_, std::move(thing));
    return last_;
  }
  void remove(int id) { things_.erase(id); }
  [[nodiscard]] Result<std::shared_ptr<Thing>> find(int id) const {
    const auto found = things_.find(id);
    if (found == things_.end()) return Error{fmt::format("there is no {} number {}", what_, id)};
    return found->second;
  }

 private:
  const char* what_;
  int last_ = 0;
  std::map<int, std::shared_ptr<Thing>> things_;
};

struct PageCore::State {
  std::deque<std::shared_ptr<ReadText>> read;  ///< the last ones, latest first
  Numbered<LoadedScheme> schemes{"scheme"};
  Numbered<LoadedMesh> meshes{"mesh"};
  Numbered<LoadedPlan> plans{"plan"};
};

/// An array of three numbers a point, as floats.
[[nodiscard]] std::vector<float> floats_of(const std::vector<Point3>& points);

/// The scheme's analysis on the lattice, made once. Fails as regular_mask and ArtifactAnalysis::of.
[[nodiscard]] Result<const study::NamedAnalysis*> lattice_of(LoadedScheme& scheme);

/// [[x, y], …]
template <class Points>
[[nodiscard]] Json pairs_json(const Points& points) {
  Json list = Json::array();
  for (const auto& point : points) list.push_back({point[0], point[1]});
  return list;
}

/// Puts the surface of the mesh as it is now into `plan.positions` and `plan.normals_there`.
[[nodiscard]] Status update(LoadedPlan& plan);

/// The control mesh's edges on the refined mesh, by the plan's numbers of vertices.
[[nodiscard]] mesh::EdgePaths lines_of(LoadedPlan& plan);

/// Calls visit(a, b, c) for the corners (places in polygons.corners) of the triangles that faces
/// are cut into, without faces at a vertex that has no limit.
template <class Visit>
void each_triangle(const LoadedPlan& plan, Visit visit) {
  const Polygons& polygons = plan.refined;
  const auto is_hole = [&](Index f) {
    for (Index c = polygons.face_begin[f]; c < polygons.face_begin[f + 1]; ++c)
      if (plan.without_limit[polygons.corners[c]]) return true;
    return false;
  };
  for (Index f = 0; f < polygons.face_count(); ++f) {
    if (!plan.without_limit.empty() && is_hole(f)) continue;
    const Index first = polygons.face_begin[f];
    for (Index c = first + 1; c + 1 < polygons.face_begin[f + 1]; ++c) visit(first, c, c + 1);
  }
}

/// Texture coordinates for `plan`: the mesh's own, or such within each face. `pattern` is set.
[[nodiscard]] MeshAttributes texture_for(LoadedPlan& plan);
/// Of the surface that carries them.
void keep_texture(LoadedPlan& plan, const TextureCoordinates& texture);

}  // namespace limn::page
