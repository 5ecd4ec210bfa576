#include "limn/base/files/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include "limn/base/files/system_file.h"
#include "limn/base/memory.h"

namespace limn::base {
namespace {

Error too_large(const std::string& path, std::uint64_t bound, bool of_memory) {
  Error error;
  error.file = path;
  error.message = "cannot read: it is larger than " + bytes_text(static_cast<double>(bound));
  if (of_memory) error.hint = "half of the memory that is free";
  return error;
}

/// Until the end of what is read, or the bound; `expected` bytes are a hint only.
Result<std::string> read_all(int fd, const std::string& path, std::uint64_t most,
                             std::uint64_t expected) {
  const bool of_memory = most == 0;
  if (of_memory) most = static_cast<std::uint64_t>(std::min(available_memory() / 2, 1e15));
  if (expected > most) return too_large(path, most, of_memory);
  constexpr std::uint64_t kPiece = 65536;
  std::string content;
  std::size_t used = 0;
  content.resize(std::min(std::max(expected, kPiece), most) + 1);
  for (;;) {
    const ssize_t got = ::read(fd, content.data() + used, content.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(path, "cannot read", errno);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    if (used > most) return too_large(path, most, of_memory);
    if (used == content.size()) content.resize(std::min<std::uint64_t>(2 * used, most + 1));
  }
  content.resize(used);
  return content;
}

Error wrong_kind(const std::string& path, mode_t mode, bool pipes) {
  Error error;
  error.file = path;
  error.message = std::string("cannot read: ") +
                  (pipes ? "neither a regular file nor a pipe" : "not a regular file") + ", but " +
                  kind_text(mode);
  return error;
}

bool is_readable_kind(mode_t mode, bool pipes) {
  return S_ISREG(mode) || (pipes && S_ISFIFO(mode));
}

std::filesystem::path place_of(const std::string& path) {
  std::error_code ignored;
  // absolute first: weakly_canonical leaves "x" as it is where there is none, and makes "./x" whole
  return std::filesystem::weakly_canonical(std::filesystem::absolute(target_of(path).path, ignored),
                                           ignored);
}

}  // namespace

Result<std::string> read_file(const std::string& path, const ReadBound& bound) {
  struct stat info {};
  // looked at before it is opened: to open a pipe waits for a writer, a device may do anything
  if (::stat(path.c_str(), &info) != 0) return system_error(path, "cannot read", errno);
  if (!is_readable_kind(info.st_mode, bound.pipes))
    return wrong_kind(path, info.st_mode, bound.pipes);
  const int wait = S_ISFIFO(info.st_mode) ? 0 : O_NONBLOCK;
  Descriptor file(open_retrying(path.c_str(), O_RDONLY | O_NOCTTY | wait));
  if (!file.open()) return system_error(path, "cannot read", errno);
  if (::fstat(file.get(), &info) != 0) return system_error(path, "cannot read", errno);
  if (!is_readable_kind(info.st_mode, bound.pipes))  // it was another one a moment ago
    return wrong_kind(path, info.st_mode, bound.pipes);
  const auto size = S_ISREG(info.st_mode) ? static_cast<std::uint64_t>(info.st_size) : 0;
  return read_all(file.get(), path, bound.bytes, size);
}

Result<std::string> read_standard_input(std::uint64_t most_bytes) {
  struct stat info {};
  const std::string name = "standard input";
  if (::fstat(STDIN_FILENO, &info) != 0) return system_error(name, "cannot read", errno);
  if (S_ISDIR(info.st_mode)) return wrong_kind(name, info.st_mode, true);
  const auto size = S_ISREG(info.st_mode) ? static_cast<std::uint64_t>(info.st_size) : 0;
  return read_all(STDIN_FILENO, name, most_bytes, size);
}

bool is_standard_output(const std::string& path) {
  return path == kStandardStream || target_of(path).descriptor == STDOUT_FILENO;
}

bool is_same_output(const std::string& a, const std::string& b) {
  const bool printed = is_standard_output(a);
  if (printed || is_standard_output(b)) return printed && is_standard_output(b);
  struct stat one {
  }, other{};
  if (::stat(a.c_str(), &one) == 0 && ::stat(b.c_str(), &other) == 0)
    return S_ISREG(one.st_mode) && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
  return place_of(a) == place_of(b);
}

}  // namespace limn::base
