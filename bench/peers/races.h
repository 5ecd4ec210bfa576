#pragma once
/// Who runs against whom: one scheme, one control mesh, limn's engines and other libraries.

#include <optional>
#include <string>
#include <vector>

#include "limn/scheme/scheme.h"
#include "measure.h"
#include "peers/peer.h"
#include "peers/textured_peer.h"

namespace limn::peers {

/// A scheme and what other libraries call it, if they have it.
struct Race {
  std::string name;
  Scheme scheme;
  std::optional<Method> method;

  /// √3 grows by 3 in a step where the others grow by 4: it gets one more.
  [[nodiscard]] int steps(int level) const;
};

/// The schemes that other libraries have, and one whose rules look farther than theirs; or the one
/// scheme asked for, by name or file. Throws std::runtime_error where there is none such.
[[nodiscard]] std::vector<Race> races(const std::string& only);

/// A control mesh with a cut into triangles, for the schemes that need them; and what is sharp of
/// either, or its texture.
struct Control {
  std::string name;
  Polygons triangles, polygons;
  int level = 0;
  PeerTags triangle_tags = {}, polygon_tags = {};
  PeerTexture triangle_texture = {}, polygon_texture = {};

  [[nodiscard]] const Polygons& of(const Race& race) const {
    return race.scheme.split->any_polygons ? polygons : triangles;
  }
  [[nodiscard]] const PeerTags& tags_of(const Race& race) const {
    return race.scheme.split->any_polygons ? polygon_tags : triangle_tags;
  }
  [[nodiscard]] const PeerTexture& texture_of(const Race& race) const {
    return race.scheme.split->any_polygons ? polygon_texture : triangle_texture;
  }
};

/// The control mesh with so large a share of its edges sharp, taken at random, in different ways: a
/// fifth of them for ever, the others by 0.5, 1, 1.5, … 4, and so that creases end, fade, meet.
[[nodiscard]] Control with_sharp_edges(Control control, double share);
/// The control mesh with texture coordinates that have seams: a chart for the faces in each octant.
[[nodiscard]] Control with_texture(Control control);

/// Full refinement, topology and positions: the plain engine on doubles, the fast engine where it
/// has a layout for the split, on doubles and floats, one thread and two; OpenSubdiv (uniform
/// refinement), CGAL and OpenMesh, none of which uses more than one thread. Floats where a library
/// takes them: it is then a little faster. With sharpness or a texture, limn and OpenSubdiv alone;
/// with a texture, refine_surface (surface/) makes all of it, on doubles. `race` and `control` must
/// outlive the contenders.
[[nodiscard]] std::vector<Contender> full_refinement(const Race& race, const Control& control);

/// Positions alone, the topology being known: `prepare` works it out, `run` evaluates. The quick
/// engine with its scratch memory kept; OpenSubdiv's StencilTable::UpdateValues on one thread and
/// on two (the range of stencils is cut) and its PrimvarRefiner (no code of which uses threads).
[[nodiscard]] std::vector<Contender> repeated_evaluation(const Race& race, const Control& control);

/// The floor: positions as floats and, of full refinement, corners as 32-bit numbers, written once
/// by one thread to memory that was written before, but is in no cache.
[[nodiscard]] Contender floor_of(Trial::Size size);
[[nodiscard]] double floor_bytes(Trial::Size size);

}  // namespace limn::peers
