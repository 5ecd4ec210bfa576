/// The page's core as functions that JavaScript calls; web/page/src/core/api.ts is the same from
/// there. Arrays are copied, so that a worker may hand them on.

#include <emscripten/bind.h>

#include "page_core.h"

using emscripten::typed_memory_view;
using emscripten::val;
using limn::page::PageCore;

namespace {

PageCore& core() {
  static PageCore page;
  return page;
}

template <class Number>
val array_of(const std::vector<Number>& numbers) {
  return val(typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

/// {json, NAME: array, …}
template <class... Arrays>
val object(const std::string& json, const Arrays&... named) {
  val made = val::object();
  made.set("json", json);
  (made.set(named.first, array_of(named.second)), ...);
  return made;
}

template <class Number>
std::pair<const char*, const std::vector<Number>&> named(const char* name,
                                                         const std::vector<Number>& numbers) {
  return {name, numbers};
}

}  // namespace

EMSCRIPTEN_BINDINGS(limn_page) {
  using emscripten::function;
  function(
      "version", +[] { return core().version(); });
  function(
      "schemes", +[] { return core().schemes(); });
  function(
      "load", +[](const std::string& text, const std::string& parameters) {
        return core().load(text, parameters);
      });
  function(
      "unload", +[](int id) { core().unload(id); });
  function(
      "show", +[](int id) { return core().show(id); });
  function(
      "eigen", +[](int id, int valence, bool quick) { return core().eigen(id, valence, quick); });
  function(
      "characteristicMap", +[](int id, int valence, int steps) {
        const auto made = core().characteristic_map(id, valence, steps);
        return object(made.json, named("points", made.points), named("lines", made.lines));
      });
  function(
      "artifacts", +[](int id, double fx, double fy) { return core().artifacts(id, fx, fy); });
  function(
      "sampling", +[](int id, double percent) { return core().sampling(id, percent); });
  function(
      "artifactMap", +[](int id, int size, const std::string& measure) {
        const auto made = core().artifact_map(id, size, measure);
        return object(made.json, named("values", made.values));
      });
  function(
      "wave", +[](int id, double fx, double fy, int levels) {
        const auto made = core().wave(id, fx, fy, levels);
        return object(made.json, named("positions", made.positions),
                      named("triangles", made.triangles), named("errors", made.errors));
      });
  function(
      "regularity", +[](int id, double seconds) { return core().regularity(id, seconds); });
  function(
      "meshes", +[] { return core().meshes(); });
  function(
      "mesh", +[](const std::string& name) { return core().mesh(name); });
  // Bytes come as a std::string, which embind takes from an Uint8Array as they are.
  function(
      "loadMesh", +[](const std::string& name, const std::string& bytes,
                      const std::string& repair) { return core().load_mesh(name, bytes, repair); });
  function(
      "unloadMesh", +[](int id) { core().unload_mesh(id); });
  function(
      "control", +[](int id) {
        const auto made = core().control(id);
        return object(made.json, named("positions", made.positions), named("edges", made.edges));
      });
  function(
      "plan", +[](int scheme, int mesh, const std::string& options) {
        return core().plan(scheme, mesh, options);
      });
  function(
      "unplan", +[](int id) { core().unplan(id); });
  function(
      "topology", +[](int id) {
        const auto made = core().topology(id);
        return object(made.json, named("triangles", made.triangles));
      });
  function(
      "lines", +[](int id) {
        const auto made = core().lines(id);
        return object(made.json, named("vertices", made.vertices), named("begin", made.begin),
                      named("segments", made.segments));
      });
  function(
      "texture", +[](int id) {
        const auto made = core().texture(id);
        return object(made.json, named("coordinates", made.coordinates));
      });
  function(
      "evaluate", +[](int id) {
        const auto made = core().evaluate(id);
        return object(made.json, named("positions", made.positions),
                      named("normals", made.normals));
      });
  function(
      "curvature", +[](int id) {
        const auto made = core().curvature(id);
        return object(made.json, named("gaussian", made.gaussian), named("mean", made.mean));
      });
  function(
      "distance", +[](int plan, int other) {
        const auto made = core().distance(plan, other);
        return object(made.json, named("values", made.values));
      });
  function(
      "moveVertex", +[](int id, int vertex, double x, double y, double z) {
        return core().move_vertex(id, vertex, x, y, z);
      });
  function(
      "setSharpness", +[](int id, const std::string& kind, int index, double sharpness) {
        return core().set_sharpness(id, kind, index, sharpness);
      });
}
