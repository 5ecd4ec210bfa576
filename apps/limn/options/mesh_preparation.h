#pragma once
/// What is done to a mesh before it is used, as every command that takes a MESH offers it.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/repair/repair.h"

namespace limn::app {

struct MeshPreparation {
  bool triangulate = false;

  /// --triangulate, --weld, --cut, --orient, --repair.
  std::vector<CLI::Option*> declare(CLI::App& command);

  /// What of repair is asked for.
  [[nodiscard]] mesh::RepairOptions repair() const;

 private:
  std::string weld_;  // empty: no; else the distance in parts of the diagonal
  bool cut_ = false, orient_ = false, repair_ = false;
};

}  // namespace limn::app
