#pragma once
/// Files: read whole, written whole or not at all.

#include <functional>
#include <string>
#include <string_view>

#include "limn/base/error.h"

namespace limn {

/// The whole content; an error names the path and the reason (missing, a directory, unreadable).
[[nodiscard]] Result<std::string> read_file(const std::string& path);

/// Writes `content` to a temporary file beside `path` and renames it over `path`, so that no
/// reader ever sees half a file. While it is being written its name is known to
/// `remove_unfinished_files`.
[[nodiscard]] Status write_file(const std::string& path, std::string_view content);

/// Takes the next piece of a content that is made piece by piece.
using Sink = std::function<void(std::string_view)>;

/// The same for a content that need not be in memory at once: `fill` gives it to the sink from
/// beginning to end, and may throw; then `path` stays as it was.
[[nodiscard]] Status write_file(const std::string& path,
                                const std::function<void(const Sink&)>& fill);

/// Removes the temporary files of writes in progress. Async-signal-safe: for the handler of an
/// interrupt, which exits afterwards.
void remove_unfinished_files() noexcept;

}  // namespace limn
