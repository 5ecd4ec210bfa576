#pragma once
/// --time, as several commands take it.

#include <string>

#include "command.h"

namespace limn::app {

/// How long an analysis looks for more if nothing else is asked.
inline constexpr double kDefaultSeconds = 10;

/// Adds --time SECONDS; 0 means without end. `what` says what ends.
CLI::Option* declare_time(CLI::App& command, double& seconds, const std::string& what);

/// As the library takes it: infinite in place of 0.
[[nodiscard]] double time_limit(double seconds);

}  // namespace limn::app
