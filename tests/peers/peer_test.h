#pragma once
/// What the tests against other libraries share.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "control_meshes.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/refine/refine.h"
#include "peer.h"
#include "same_surface.h"

namespace limn::peers {

inline Polygons refined(const Scheme& scheme, const Polygons& control, int levels) {
  const auto result =
      refine::refine(scheme, Mesh::build(control).value(), control.positions, levels).value();
  return result.mesh.polygons(result.values);
}

/// A function that makes the peer's mesh from a control mesh.
template <class Make>
std::string difference_after(const Scheme& scheme, const Polygons& control, int levels,
                             const Make& make) {
  const std::unique_ptr<Peer> peer = make(control);
  peer->refine(levels);
  return difference(refined(scheme, control, levels), peer->polygons());
}

/// One comparison per level: the peer starts anew each time, in a single call.
template <class Make>
void expect_agreement(const Scheme& scheme, const std::vector<ControlMesh>& meshes, int levels,
                      const Make& make) {
  ASSERT_FALSE(meshes.empty());
  for (const ControlMesh& mesh : meshes)
    for (int level = 1; level <= levels; ++level)
      EXPECT_EQ(difference_after(scheme, mesh.polygons, level, make), "")
          << mesh.name << ", level " << level;
}

inline std::vector<ControlMesh> example(const std::string& name) {
  return {{name, read_mesh(LIMN_EXAMPLES "/" + name).value()}};
}

/// A change to the text of a scheme file, named by what it changes.
struct Edit {
  std::string name;
  std::vector<std::pair<std::string, std::string>> replacements;  ///< each must be found
  std::string addition;                                           ///< at the end of the file
};

inline Scheme edited_scheme(const std::string& name, const Edit& edit) {
  const std::string path = LIMN_SCHEMES "/" + name + ".toml";
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (const auto& [from, to] : edit.replacements) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  const Result<Scheme> scheme = parse_scheme(text + "\n" + edit.addition, path);
  EXPECT_TRUE(scheme.ok()) << (scheme ? "" : scheme.error().text());
  return scheme.value();
}

/// Every edit makes a difference, on some mesh, that the comparison sees.
template <class Make>
void expect_notice(const std::string& scheme_name, const std::vector<Edit>& edits,
                   const std::vector<ControlMesh>& meshes, int levels, const Make& make) {
  for (const Edit& edit : edits) {
    const Scheme scheme = edited_scheme(scheme_name, edit);
    bool noticed = false;
    for (const ControlMesh& mesh : meshes)
      noticed = noticed || !difference_after(scheme, mesh.polygons, levels, make).empty();
    EXPECT_TRUE(noticed) << "a changed " << edit.name;
  }
}

}  // namespace limn::peers
