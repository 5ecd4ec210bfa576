#pragma once
/// Schemes of a command line that takes several, each with parameters of its own.

#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/scheme.h"

namespace limn::app {

/// What the help of an option says of SCHEME.
inline constexpr const char* kSchemeArgumentHelp =
    "a shipped scheme or a scheme file, with its parameters after a colon, as "
    "laplacian-butterfly:b=3/16";

/// A scheme and what a report calls it.
struct NamedScheme {
  std::string label;
  Scheme scheme;
};

/// "NAME_OR_PATH[:name=value[,name=value…]]". The last colon begins the parameters, unless the
/// whole text is a file. Fails as find_scheme and set_parameters do, and where nothing follows the
/// colon.
[[nodiscard]] Result<Scheme> scheme_argument(const std::string& text);

/// What a report calls it: the scheme's name and what is set, "laplacian-butterfly b=3/16".
[[nodiscard]] std::string scheme_label(const std::string& text, const Scheme& scheme);

/// All of them; `common` ("name=value") is set in each as well, before its own. Labels differ:
/// where two would be the same (a shipped scheme and a file of its name), they are the texts. Fails
/// as scheme_argument does, and where a text comes twice.
[[nodiscard]] Result<std::vector<NamedScheme>> scheme_arguments(
    const std::vector<std::string>& texts, const std::vector<std::string>& common = {});

}  // namespace limn::app
