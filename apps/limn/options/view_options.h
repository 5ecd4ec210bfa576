#pragma once
/// Where the viewer of a picture stands, as several commands take it.

#include <CLI/CLI.hpp>

namespace limn::app {

struct ViewOptions {
  double azimuth = -50;
  double elevation = 30;

  /// --azimuth and --elevation.
  void declare(CLI::App& command);
};

}  // namespace limn::app
