#include "options/number_option.h"

#include <cmath>
#include <string>

#include <fast_float/fast_float.h>
#include <fmt/core.h>

namespace limn::app {

bool read_number(std::string_view text, double& value) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const auto [end, fault] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

CLI::Validator number_between(double low, double high) {
  const std::string range = fmt::format("[{:g} - {:g}]", low, high);
  return {[low, high](std::string& text) -> std::string {
            double value = 0;
            if (!read_number(text, value)) return fmt::format("'{}' is not a number", text);
            if (value >= low && value <= high) return {};
            return fmt::format("{} is not between {:g} and {:g}", text, low, high);
          },
          "NUMBER in " + range};
}

}  // namespace limn::app
