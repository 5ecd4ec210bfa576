#include "limn/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace limn {
namespace {

Error system_error(const std::string& path, const std::string& what, int code,
                   std::string hint = {}) {
  Error error;
  error.message = what + ": " + std::generic_category().message(code);
  error.hint = std::move(hint);
  error.file = path;
  return error;
}

/// An open descriptor; closed at the end of its scope unless `close` was called.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool open() const { return fd_ >= 0; }
  /// 0 or errno: a full disk may be reported only here (NFS).
  int close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0 ? 0 : errno;
  }

 private:
  int fd_;
};

int open_retrying(const char* path, int flags, mode_t mode = 0) {
  int fd = -1;
  do {
    fd = ::open(path, flags | O_CLOEXEC, mode);
  } while (fd < 0 && errno == EINTR);
  return fd;
}

/// 0 or errno.
int write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const std::size_t chunk = content.size() < (1u << 30) ? content.size() : (1u << 30);
    const ssize_t written = ::write(fd, content.data(), chunk);
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Names of unfinished files, in memory that a signal handler may read. A slot's path is
/// written only while it is `claimed`, and read only while it is `live`.
enum SlotState : int { unused, claimed, live };
struct Slot {
  std::atomic<int> state{unused};
  std::array<char, 4096> path{};
};
std::array<Slot, 16> slots;
static_assert(std::atomic<int>::is_always_lock_free);

/// Keeps a path in the table. If the table is full or the path too long, the write goes on
/// without: only the tidying after an interrupt is lost.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& path) {
    if (path.size() >= slots[0].path.size()) return;
    for (Slot& slot : slots) {
      int expected = unused;
      if (!slot.state.compare_exchange_strong(expected, claimed)) continue;
      std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
      slot.state.store(live);
      slot_ = &slot;
      return;
    }
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile() {
    if (slot_ != nullptr) slot_->state.store(unused);
  }

 private:
  Slot* slot_ = nullptr;
};

std::string directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

/// The file that a write to `path` must replace: symbolic links are followed, also one whose
/// target does not exist yet, so that the link stays a link. Returns 0 or errno.
int follow_links(std::string& path) {
  for (int depth = 0; depth < 40; ++depth) {
    struct stat info {};
    if (::lstat(path.c_str(), &info) != 0) return errno == ENOENT ? 0 : errno;
    if (!S_ISLNK(info.st_mode)) return 0;
    std::array<char, 4096> target{};
    const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
    if (length < 0) return errno;
    const std::string link(target.data(), static_cast<std::size_t>(length));
    path = link.starts_with('/') ? link : directory_of(path) + link;
  }
  return ELOOP;
}

/// A name in the directory of `target` that no other process is likely to use.
std::string temporary_name(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return directory_of(target) + ".limn-" + std::to_string(::getpid()) + "-" +
         std::to_string(static_cast<std::uint64_t>(now) % 1000000007u) + "-" +
         std::to_string(counter.fetch_add(1)) + ".tmp";
}

using Fill = std::function<void(const Sink&)>;

/// 0 or errno. After an error the rest is dropped.
int write_all(int fd, const Fill& fill) {
  int code = 0;
  fill([&](std::string_view piece) {
    if (code == 0) code = write_all(fd, piece);
  });
  return code;
}

/// Devices and pipes cannot be replaced by a rename.
Status write_directly(const std::string& path, const Fill& fill) {
  Descriptor file(open_retrying(path.c_str(), O_WRONLY | O_NOCTTY));
  if (!file.open()) return system_error(path, "cannot open for writing", errno);
  if (const int code = write_all(file.get(), fill)) {
    return system_error(path, "cannot write", code);
  }
  if (const int code = file.close()) return system_error(path, "cannot write", code);
  return Done{};
}

/// Fills the open temporary file and renames it. No fsync: a crash of the machine may lose the
/// new content, a crash of the program never leaves half of it.
Status fill_and_rename(const std::string& path, Descriptor& file, const std::string& temporary,
                       const std::string& target, const Fill& fill) {
  int code = 0;
  try {
    code = write_all(file.get(), fill);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  const int close_code = file.close();
  if (code == 0) code = close_code;
  if (code == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) code = errno;
  if (code == 0) return Done{};
  ::unlink(temporary.c_str());
  return system_error(path, "cannot write", code);
}

/// `mode`: the permission bits of the file that is replaced, or 0 for a new file (the umask
/// decides). `path`: as the user gave it, for messages.
Status replace_file(const std::string& path, const std::string& target, mode_t mode,
                    const Fill& fill) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const std::string temporary = temporary_name(target);
    // Registered before it exists, so that no interrupt can fall between the two.
    const UnfinishedFile registered(temporary);
    Descriptor file(open_retrying(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0666));
    if (!file.open()) {
      if (errno == EEXIST) continue;
      return system_error(path, "cannot write", errno, "is its directory there, and writable?");
    }
    // A file system without permission bits may refuse; the content matters more.
    if (mode != 0 && ::fchmod(file.get(), mode) != 0) errno = 0;
    return fill_and_rename(path, file, temporary, target, fill);
  }
  return system_error(path, "cannot write", EEXIST);
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  Descriptor file(open_retrying(path.c_str(), O_RDONLY | O_NOCTTY));
  if (!file.open()) return system_error(path, "cannot read", errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return system_error(path, "cannot read", errno);
  if (S_ISDIR(info.st_mode)) return system_error(path, "cannot read", EISDIR);
  // The size is a hint only: a pipe has none, and a file may grow while it is read.
  std::string content;
  std::size_t used = 0;
  content.resize(S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) + 1 : 65536);
  for (;;) {
    const ssize_t got = ::read(file.get(), content.data() + used, content.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(path, "cannot read", errno);
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
    if (used == content.size()) content.resize(2 * used);
  }
  content.resize(used);
  return content;
}

Status write_file(const std::string& path, std::string_view content) {
  return write_file(path, [&](const Sink& sink) { sink(content); });
}

Status write_file(const std::string& path, const std::function<void(const Sink&)>& fill) {
  if (path.empty()) return system_error(path, "cannot write to an empty path", ENOENT);
  struct stat info {};
  const bool exists = ::stat(path.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) return system_error(path, "cannot write", EISDIR);
  if (exists && !S_ISREG(info.st_mode)) return write_directly(path, fill);
  // A rename would replace even a file that is read-only.
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    return system_error(path, "cannot write", errno);
  }
  std::string target = path;
  if (const int code = follow_links(target)) return system_error(path, "cannot write", code);
  const mode_t mode = exists ? static_cast<mode_t>(info.st_mode & 0777) : 0;
  return replace_file(path, target, mode, fill);
}

void remove_unfinished_files() noexcept {
  const int saved = errno;
  for (Slot& slot : slots) {
    if (slot.state.load() == live) ::unlink(slot.path.data());
  }
  errno = saved;
}

}  // namespace limn
