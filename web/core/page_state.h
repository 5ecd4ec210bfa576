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
#include "limn/mesh/sharpness/tags.h"
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
  ParameterSetter setter;
  std::vector<bool> integers;  ///< of each parameter whether whole numbers alone are taken
  Json features, reasons;      ///< what can be asked of it, and why the rest cannot
};

struct LoadedScheme {
  Scheme scheme;
  std::optional<FrequencyAnalysis> frequencies;  // made when asked for; refer to `scheme`
  std::optional<NamedAnalysis> lattice;
  SamplingDensities densities;
};

struct LoadedMesh {
  Mesh mesh;
  std::vector<Point3> points;
  Sharpness sharpness;
  SharpnessTags cut_tags;  ///< what holds the copies together that repair has made
  int moves = 0;           ///< how often a vertex was moved
};

/// Keeps what it was made of, whatever becomes of the numbers.
struct LoadedPlan {
  std::shared_ptr<LoadedScheme> scheme;
  std::shared_ptr<LoadedMesh> mesh;
  int levels = 0;
  bool limit = true, normals = true;
  Sharpness sharpness;                 ///< that of the mesh when it was made
  std::string reason;                  ///< why there is no limit
  std::optional<FastRefiner> refiner;  ///< nothing: the plain engine
  std::optional<FastRefiner::Limit> on_limit;
  FastRefiner::Scratch<double> scratch;
  Polygons refined;  ///< faces; positions and normals as of `moves`
  std::vector<Point3> normals_there;
  bool has_limit = false, has_normals = false;  ///< what these are
  int moves = -1;                               ///< of the mesh, when they were made
  std::optional<std::vector<std::uint32_t>> lines;
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
[[nodiscard]] Result<const NamedAnalysis*> lattice_of(LoadedScheme& scheme);

/// [[x, y], …]
template <class Points>
[[nodiscard]] Json pairs_json(const Points& points) {
  Json list = Json::array();
  for (const auto& point : points) list.push_back({point[0], point[1]});
  return list;
}

/// Puts the surface of the mesh as it is now into `plan.refined` and `plan.normals_there`.
[[nodiscard]] Status update(LoadedPlan& plan);

/// The control mesh's edges on the refined mesh, pairs of vertices; none where the split does not
/// keep edges.
[[nodiscard]] std::vector<std::uint32_t> edges_on_surface(LoadedPlan& plan);

}  // namespace limn::page
