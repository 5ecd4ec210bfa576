#pragma once
/// Files: read whole and within bounds, written whole or not at all. Several that belong together:
/// file_transaction.h.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "limn/base/error.h"
#include "limn/base/files/unfinished.h"

namespace limn::base {

/// What is read of a path, at most.
struct ReadBound {
  std::uint64_t bytes = 0;  ///< at most so many; 0: half of the memory that is free
  bool pipes = true;        ///< named pipes too, not regular files alone
};

/// The whole content of a regular file, or of a pipe until its writers close it. Fails where the
/// path is missing, a folder, a device, unreadable, or larger than the bound, which is looked at
/// before reading and while reading: a file may grow, and a pipe has no size.
[[nodiscard]] Result<std::string> read_file(const std::string& path, const ReadBound& bound = {});

/// What comes on standard input until its end, of whatever kind it is; errors call it "standard
/// input". `most_bytes` as in ReadBound.
[[nodiscard]] Result<std::string> read_standard_input(std::uint64_t most_bytes = 0);

/// The path that means standard output, or standard input; a file of this name is ./-
inline constexpr const char* kStandardStream = "-";

/// Whether what is written to `path` goes to standard output: "-", or a name of descriptor 1, as
/// /dev/stdout.
[[nodiscard]] bool is_standard_output(const std::string& path);

/// Writes `content` to a temporary file beside `path` and renames it over `path`, so that no
/// reader ever sees half a file; in a `FileTransaction`, the rename waits for its `commit`.
/// A rename makes a new file. It keeps the name of the old one, its permission bits, and symbolic
/// links to it; other hard links keep the old content, and owner, access lists and extended
/// attributes are those of a new file. Standard output, descriptors (/dev/fd/3), devices and pipes
/// cannot be replaced and are written directly, at once.
[[nodiscard]] Status write_file(const std::string& path, std::string_view content);

/// Takes the next piece of a content that is made piece by piece.
using Sink = std::function<void(std::string_view)>;

/// The same for a content that need not be in memory at once: `fill` gives it to the sink from
/// beginning to end, and may throw; then `path` stays as it was.
[[nodiscard]] Status write_file(const std::string& path,
                                const std::function<void(const Sink&)>& fill);

/// Takes a piece of a content that belongs so many bytes from its beginning; from several threads
/// at once.
using PlacedSink = std::function<void(std::uint64_t at, std::string_view piece)>;

/// Whether a path can be written by `write_file_at_places`: it is no file yet, or a regular one.
[[nodiscard]] bool takes_places(const std::string& path);

/// As `write_file`, for pieces that come in any order; they do not overlap, and leave no gaps.
/// Where `fill` gives an error, that is the result, and `path` stays as it was. Precondition:
/// takes_places(path).
[[nodiscard]] Status write_file_at_places(const std::string& path,
                                          const std::function<Status(const PlacedSink&)>& fill);

/// Whether a file can be made or replaced at `path`, as far as can be told without doing it, so
/// that what cannot be written is refused before the work.
[[nodiscard]] Status check_can_write(const std::string& path);

/// Whether both paths are outputs into one place: one regular file, there or to come, or standard
/// output. Devices such as /dev/null can be written twice.
[[nodiscard]] bool is_same_output(const std::string& a, const std::string& b);

/// Makes a folder, and those above it, where they are missing. In a `FileTransaction` what is
/// missing is made under another name, and takes its own by a rename at `commit`.
[[nodiscard]] Status make_folder(const std::string& path);

}  // namespace limn::base
