#pragma once
/// Numbers of a command line.

#include <CLI/CLI.hpp>
#include <string_view>

namespace limn::app {

/// The whole of `text` as one finite number: no nan, no inf, nothing behind it.
[[nodiscard]] bool read_number(std::string_view text, double& value);

/// That an option is such a number from `low` to `high`. (CLI::Range lets nan pass.)
[[nodiscard]] CLI::Validator number_between(double low, double high);

}  // namespace limn::app
