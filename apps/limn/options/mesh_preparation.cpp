#include "options/mesh_preparation.h"

#include "options/number_option.h"

namespace limn::app {

std::vector<CLI::Option*> MeshPreparation::declare(CLI::App& command) {
  return {
      command.add_flag("--triangulate", triangulate,
                       "cut polygons into triangles first, concave ones too"),
      command
          .add_flag("--weld{1e-6}", weld_,
                    "join vertices that lie within 1e-6 of the mesh's diagonal (--weld=EPS: within "
                    "that part of it; 0: in one place)")
          ->check(number_between(0, 1).description("")),
      command.add_flag("--cut", cut_,
                       "give each sheet its own copies where an edge has more than two faces or "
                       "the faces round a vertex are not one fan; cut one-sided surfaces open"),
      command.add_flag("--orient", orient_,
                       "reverse the fewest faces so that neighbours run the same way"),
      command.add_flag("--repair", repair_,
                       "drop degenerate and repeated faces, join vertices in one place (or as "
                       "--weld says), cut and orient"),
  };
}

mesh::RepairOptions MeshPreparation::repair() const {
  mesh::RepairOptions options;
  if (repair_) options = mesh::RepairOptions::everything();
  options.cut = options.cut || cut_;
  options.orient = options.orient || orient_;
  double distance = 0;
  if (!weld_.empty() && read_number(weld_, distance)) options.weld = distance;
  return options;
}

}  // namespace limn::app
