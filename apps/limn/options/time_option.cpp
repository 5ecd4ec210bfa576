#include "options/time_option.h"

#include <limits>

#include "options/number_option.h"

namespace limn::app {

CLI::Option* declare_time(CLI::App& command, double& seconds, const std::string& what) {
  constexpr double kMost = 1e9;
  return command.add_option("--time", seconds, what + "; 0: without end")
      ->type_name("SECONDS")
      ->check(number_between(0, kMost))
      ->capture_default_str();
}

double time_limit(double seconds) {
  return seconds == 0 ? std::numeric_limits<double>::infinity() : seconds;
}

}  // namespace limn::app
