#pragma once
/// What becomes of a control mesh's attributes, as command lines say it.

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/scheme/scheme.h"
#include "limn/surface/refine_surface.h"
#include "options/control_mesh.h"

namespace limn::app {

/// --attributes and --uv.
struct AttributeOptions {
  std::string numbers = "smooth";  // none, linear
  std::string texture;             // as USD names the rules; empty: cornersPlus1

  void declare(CLI::App& command);
  /// --uv alone.
  void declare_texture(CLI::App& command);
  /// Whether there are to be any.
  [[nodiscard]] bool wanted() const { return numbers != "none"; }
  [[nodiscard]] AttributeRules rules() const;
  /// Leaves out what files with this extension cannot hold, and texture coordinates that the scheme
  /// cannot refine, each with a warning; fails where --uv asks for these.
  [[nodiscard]] Status fit(ControlMesh& control, const Scheme& scheme, const std::string& extension,
                           const std::string& output) const;
};

/// Leaves out what files with this extension cannot hold, which one warning names.
void leave_out_lost(MeshAttributes& attributes, const std::string& extension,
                    const std::string& output, MeshRemarks& remarks);

/// "numbers", the names of vertices' numbers; "texture_points", how many; and under "labels" how
/// many names of each kind faces have.
[[nodiscard]] nlohmann::ordered_json attributes_json(const MeshAttributes& attributes);

}  // namespace limn::app
