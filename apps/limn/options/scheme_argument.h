#pragma once
/// SCHEME on a command line, with parameters of its own.

#include <set>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/scheme.h"

namespace limn::app {

/// A scheme and what a report calls it.
struct NamedScheme {
  std::string label;
  Scheme scheme;
};

/// "NAME_OR_PATH[:name=value[,name=value…]]". The last colon begins the parameters, unless the
/// whole text is a file or what follows is the rest of a path. `common` ("name=value") is set as
/// well. Fails as find_scheme and set_parameters do (a parameter has one value), and where nothing
/// follows the colon.
[[nodiscard]] Result<Scheme> scheme_argument(const std::string& text,
                                             const std::vector<std::string>& common = {});

/// NAME_OR_PATH of it.
[[nodiscard]] std::string scheme_name_of(const std::string& text);

/// The parameters that are given a value, after the colon or in `common`.
[[nodiscard]] std::set<std::string> given_parameters(const std::string& text,
                                                     const std::vector<std::string>& common);

/// What a report calls it: the scheme's name and what is set, "laplacian-butterfly b=3/16".
[[nodiscard]] std::string scheme_label(const std::string& text, const Scheme& scheme);

/// All of them; `common` ("name=value") is set in each as well. Labels differ:
/// where two would be the same (a shipped scheme and a file of its name), they are the texts. Fails
/// as scheme_argument does, and where a text comes twice.
[[nodiscard]] Result<std::vector<NamedScheme>> scheme_arguments(
    const std::vector<std::string>& texts, const std::vector<std::string>& common = {});

}  // namespace limn::app
