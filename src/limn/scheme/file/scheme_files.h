#pragma once
/// Where the files come from that a scheme `extends`: shipped schemes and the file system, or
/// whatever a caller puts in their place.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// A scheme file's content.
struct SchemeText {
  std::string text;  ///< TOML
  std::string path;  ///< for messages, and what names in the text are relative to
  std::string id;    ///< the same for two names of one file, so that circles are seen
};

/// The file that is called `name` in the file `from` ("." where that has no path; empty: on a
/// command line).
using SchemeLoader =
    std::function<Result<SchemeText>(const std::string& name, const std::string& from)>;

/// A shipped scheme by its name, or else a file: a path, relative to the folder of `from`. An
/// unknown name lists the near ones. What a file extends must be a regular file: no device or pipe.
[[nodiscard]] Result<SchemeText> load_scheme_text(const std::string& name, const std::string& from);

/// parse_scheme (scheme.h), with other files from `load`. At most nine files extend one another.
[[nodiscard]] Result<Scheme> parse_scheme(std::string_view text, const std::string& path,
                                          const SchemeLoader& load);

/// The files that a scheme was read from (Scheme::texts), by paths as they were opened. Paths that
/// are no files, as those of shipped schemes, are left out.
[[nodiscard]] std::vector<std::string> scheme_files(const Scheme& scheme);

/// The scheme that was read from these texts (Scheme::texts), and from nothing else: no file is
/// opened. Fails as parse_scheme, where a text is missing, and where one is left over.
[[nodiscard]] Result<Scheme> parse_texts(const std::vector<SourceText>& texts);

}  // namespace limn
