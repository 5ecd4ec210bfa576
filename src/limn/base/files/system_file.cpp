#include "limn/base/files/system_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>
#include <system_error>

namespace limn::base {
namespace {

/// The number in "/dev/fd/3", "/proc/self/fd/3" and the like.
std::optional<int> descriptor_of(std::string_view path) {
  if (path == "/dev/stdin") return STDIN_FILENO;
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  const std::string own = "/proc/" + std::to_string(::getpid()) + "/fd/";
  for (const std::string_view folder :
       {std::string_view("/dev/fd/"), std::string_view("/proc/self/fd/"), std::string_view(own)}) {
    if (!path.starts_with(folder)) continue;
    const std::string_view digits = path.substr(folder.size());
    int number = -1;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (fault == std::errc() && end == digits.data() + digits.size() && number >= 0) return number;
  }
  return std::nullopt;
}

}  // namespace

Error system_error(const std::string& path, const std::string& what, int code, std::string hint) {
  Error error;
  error.message = what + ": " + std::generic_category().message(code);
  error.hint = std::move(hint);
  error.file = path;
  return error;
}

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

int Descriptor::close() {
  const int fd = fd_;
  fd_ = -1;
  return ::close(fd) == 0 ? 0 : errno;
}

int open_retrying(const char* path, int flags, mode_t mode) {
  int fd = -1;
  do {
    fd = ::open(path, flags | O_CLOEXEC, mode);
  } while (fd < 0 && errno == EINTR);
  return fd;
}

const char* kind_text(mode_t mode) {
  if (S_ISDIR(mode)) return "a directory";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a file";
}

std::string directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

Target target_of(const std::string& path) {
  Target target{path, {}, 0};
  for (int depth = 0; depth < 40; ++depth) {
    target.descriptor = descriptor_of(target.path);
    if (target.descriptor) return target;
    struct stat info {};
    if (::lstat(target.path.c_str(), &info) != 0) {
      target.error = errno == ENOENT ? 0 : errno;
      return target;
    }
    if (!S_ISLNK(info.st_mode)) return target;
    std::array<char, 4096> link{};
    const ssize_t length = ::readlink(target.path.c_str(), link.data(), link.size());
    if (length < 0) {
      target.error = errno;
      return target;
    }
    const std::string text(link.data(), static_cast<std::size_t>(length));
    target.path = text.starts_with('/') ? text : directory_of(target.path) + text;
  }
  target.error = ELOOP;
  return target;
}

}  // namespace limn::base
