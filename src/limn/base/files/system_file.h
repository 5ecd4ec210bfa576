#pragma once
/// Calls of the system that reading and writing files share.

#include <optional>
#include <string>

#include <sys/types.h>

#include "limn/base/error.h"

namespace limn::base {

/// "what: the system's words for the error `code`", at `path`.
[[nodiscard]] Error system_error(const std::string& path, const std::string& what, int code,
                                 std::string hint = {});

/// An open descriptor; closed at the end of its scope unless `close` was called.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool open() const { return fd_ >= 0; }
  /// 0 or errno: a full disk may be reported only here (NFS).
  int close();

 private:
  int fd_;
};

/// Never inherited by another program; tried again after a signal. Negative: errno says why.
[[nodiscard]] int open_retrying(const char* path, int flags, mode_t mode = 0);

/// "a directory", "a device", … of a file's mode.
[[nodiscard]] const char* kind_text(mode_t mode);

/// The folder that `path` is in, with its slash; empty: the working folder.
[[nodiscard]] std::string directory_of(const std::string& path);

/// What `path` means once symbolic links are followed, as far as they lead.
struct Target {
  std::string path;               ///< no link; it need not exist
  std::optional<int> descriptor;  ///< of this process, where the path names one, as /dev/stdout
  int error = 0;                  ///< errno, where the links lead nowhere
};
[[nodiscard]] Target target_of(const std::string& path);

}  // namespace limn::base
