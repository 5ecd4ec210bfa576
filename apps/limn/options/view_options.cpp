#include "options/view_options.h"

#include "options/number_option.h"

namespace limn::app {

void ViewOptions::declare(CLI::App& command) {
  command.add_option("--azimuth", azimuth, "of the viewer about the z axis, in degrees from x")
      ->capture_default_str()
      ->check(number_between(-360, 360));
  command.add_option("--elevation", elevation, "of the viewer over the xy plane, in degrees")
      ->capture_default_str()
      ->check(number_between(-90, 90));
}

}  // namespace limn::app
