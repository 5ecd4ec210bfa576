#pragma once

#include <string_view>

namespace limn::app {

/// The web page that limn was built with (docs/page.md); empty: without one.
[[nodiscard]] std::string_view page_file();

}  // namespace limn::app
