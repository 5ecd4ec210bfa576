#include "view_options.h"

namespace limn::app {

void ViewOptions::declare(CLI::App& command) {
  command.add_option("--azimuth", azimuth, "of the viewer about the z axis, in degrees from x")
      ->capture_default_str()
      ->check(CLI::Range(-360.0, 360.0));
  command.add_option("--elevation", elevation, "of the viewer over the xy plane, in degrees")
      ->capture_default_str()
      ->check(CLI::Range(-90.0, 90.0));
}

}  // namespace limn::app
