#pragma once
/// What the page asks of limn: the library behind plain functions of numbers, texts and arrays, as
/// a web page can call them. No mathematics and no state of a page, only what the page has loaded.
///
/// Answers are JSON: {"ok": true, …} with the keys and numbers of the command's --json, made by the
/// same writers, or {"ok": false, "errors": [{"line", "column", "message", "hint"}]}. Arrays that
/// go with an answer are empty where it is not ok. Nothing throws, whatever the input. Schemes,
/// meshes and plans are called by the numbers ("id") that loading them has given.
///
/// One thread at a time. `web/page/src/core/api.ts` is the same from the page's side.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace limn::page {

/// The image of a characteristic map: x, y of points, and pairs of them that are edges.
struct MapAnswer {
  std::string json;
  std::vector<float> points;
  std::vector<std::uint32_t> lines;
};
/// A square of values, row by row from below.
struct FieldAnswer {
  std::string json;
  std::vector<float> values;
};
/// A wave's surface: x, y, z of points, triangles, and at each point its distance from the signal.
struct WaveAnswer {
  std::string json;
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<float> errors;
};
/// x, y, z of a mesh's vertices, and the pairs that its edges join.
struct ControlAnswer {
  std::string json;
  std::vector<float> positions;
  std::vector<std::uint32_t> edges;
};
/// A refined mesh's triangles.
struct TopologyAnswer {
  std::string json;
  std::vector<std::uint32_t> triangles;
};
/// The control mesh's edges on the surface: point p is the mean of the refined vertices
/// vertices[begin[p]] … vertices[begin[p + 1] - 1]; `segments` are pairs of points.
struct LinesAnswer {
  std::string json;
  std::vector<std::uint32_t> vertices, begin, segments;
};
/// Two numbers for each corner of topology's triangles, one after the other.
struct TextureAnswer {
  std::string json;
  std::vector<float> coordinates;
};
/// x, y, z of points and normals.
struct SurfaceAnswer {
  std::string json;
  std::vector<float> positions, normals;
};
/// The two symmetric functions of principal curvatures; NaN where there is none.
struct CurvatureAnswer {
  std::string json;
  std::vector<float> gaussian, mean;
};

/// All that one page has loaded.
class PageCore {
 public:
  PageCore();
  ~PageCore();
  PageCore(PageCore&&) noexcept;
  PageCore& operator=(PageCore&&) noexcept;

  /// {"version"}
  [[nodiscard]] std::string version() const;

  /// {"schemes": [{"name", "title", "split", "lattice": "triangles" or "quads", "source", "text"}]}
  [[nodiscard]] std::string schemes() const;
  /// A scheme of a file's text, with its parameters: "" or a JSON object of texts (expressions) and
  /// numbers. {"id", "name", "title", "split", "lattice", "dual", "source", "notes", "file",
  /// "parameters": [{"name", "meaning", "value": text, "number", "default": text, "min", "max":
  /// numbers or null, "integer"}], "valences": {"regular", "least", "most"}, "features":
  /// {"eigen", "refine", "boundary", "sharpness": bool}, "reasons": {feature: why it
  /// is missing}}. What was read last is kept, so that other parameters of the same text cost next
  /// to nothing (limn/scheme/parameter_setter.h).
  [[nodiscard]] std::string load(const std::string& text, const std::string& parameters);
  void unload(int scheme);
  /// As `limn show --json`.
  [[nodiscard]] std::string show(int scheme);

  /// {"regular_part", …} and one of "valences" of `limn eigen --json`, from the least valence to
  /// 128. `quick`: the regular lattice is not looked at, which takes some tenths of a second for a
  /// new mask; bounded curvature is then undecided or refuted.
  [[nodiscard]] std::string eigen(int scheme, int valence, bool quick);
  /// After 0 … 5 steps. {"valence", "eigenvalue", "regular", "reason", "turned_over", "net":
  /// {"points": [[x, y]], "lines": [[i, j]]}}: the control net.
  [[nodiscard]] MapAnswer characteristic_map(int scheme, int valence, int steps);

  /// As `limn artifacts --frequency fx,fy --json`.
  [[nodiscard]] std::string artifacts(int scheme, double fx, double fy);
  /// As `limn artifacts --tolerance percent --json`.
  [[nodiscard]] std::string sampling(int scheme, double percent);
  /// Artifacts in percent of the signal at size × size frequencies, 2 … 512, at the centres of
  /// equal cells of the Nyquist region's bounding box; NaN outside the region. `measure`:
  /// "mean_energy", percent_of_signal of artifacts(), or "total_energy", total_energy_percent.
  /// {"size", "extent": [x0, y0, x1, y1], "lattice", "cell": the region's corners, "measure",
  /// "largest"}.
  [[nodiscard]] FieldAnswer artifact_map(int scheme, int size, const std::string& measure);
  /// The limit of the wave cos 2π f·x at the points of a square grid of 16 · 2^levels cells a side,
  /// 0 ≤ levels ≤ 4, over two wavelengths or so: heights, and what of them is not the signal.
  /// {"extent", "size": points a side, "signal": its amplitude, "waves": how many were summed,
  /// "largest_error"}.
  [[nodiscard]] WaveAnswer wave(int scheme, double fx, double fy, int levels);
  /// As `limn regularity --json`, after at most about so many seconds.
  [[nodiscard]] std::string regularity(int scheme, double seconds);

  /// {"meshes": [{"name", "summary", "faces": "triangles", "quads" or "mixed"}]}
  [[nodiscard]] std::string meshes() const;
  /// Loads one of them; answers as load_mesh.
  [[nodiscard]] std::string mesh(const std::string& name);
  /// A mesh file's content. `repair`: "", or words of weld, orient, cut, repair, triangulate with
  /// commas, as the command's options. {"id", "faces", "closed", "check": as `limn check --json`,
  /// "warnings", "repaired"}; a mesh that cannot be refined is refused, with its "check".
  [[nodiscard]] std::string load_mesh(const std::string& file_name, std::string_view content,
                                      const std::string& repair);
  void unload_mesh(int mesh);
  /// The mesh as it is now. {"vertices", "edges", "faces", "bounds": [[x, y, z], [x, y, z]],
  /// "sharp": {"edges": {number: sharpness}, "vertices": {…}}}.
  [[nodiscard]] ControlAnswer control(int mesh);
  [[nodiscard]] std::string move_vertex(int mesh, int vertex, double x, double y, double z);
  /// `kind`: "edge" or "vertex"; 0 ≤ sharpness ≤ 10, which is for ever.
  [[nodiscard]] std::string set_sharpness(int mesh, const std::string& kind, int index,
                                          double sharpness);

  /// How this mesh is refined by this scheme. `options`: "" or {"levels": 3, "limit": true,
  /// "normals": true, "texture": false, "instead": 0}. {"id", "vertices", "triangles", "engine":
  /// "fast" or "plain", "limit", "reason", "missing": at how many vertices there is no limit}; the
  /// faces there are left out of "triangles". It is made for the sharpness that the mesh has, and
  /// for any positions. `instead`: a plan that goes, whose memory this one takes; of the same mesh,
  /// with other parameters, it takes its faces too.
  [[nodiscard]] std::string plan(int scheme, int mesh, const std::string& options);
  void unplan(int plan);
  [[nodiscard]] TopologyAnswer topology(int plan);
  /// As long as refining anew by the plain engine.
  [[nodiscard]] LinesAnswer lines(int plan);
  /// Of a plan that was made with "texture". {"pattern", "reason": why there is none}: "image", the
  /// texture coordinates that came with the mesh; or, where there are none, "triangles" or "quads":
  /// coordinates within each control face, from corner to corner (0, 0), (1, 0), (0, 1) or (0, 0),
  /// (1, 0), (1, 1), (0, 1); or "none".
  [[nodiscard]] TextureAnswer texture(int plan);
  /// {"limit", "normals": "limit" or "faces", "milliseconds"}
  [[nodiscard]] SurfaceAnswer evaluate(int plan);
  /// At the plan's vertices. {"missing": how many have none, "reasons": as gaps of `limn refine`}
  [[nodiscard]] CurvatureAnswer curvature(int plan);
  /// From each vertex of one surface to the other. {"largest", "mean", "diagonal"}
  [[nodiscard]] FieldAnswer distance(int plan, int other);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace limn::page
