#include "limn/base/files/staged_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "limn/base/files/system_file.h"

namespace limn::base {
namespace {

constexpr int kMostAttempts = 100;  // at a name that nobody uses

Error cannot_write(const std::string& path, int code) {
  std::string hint;
  if (code == ENOENT || code == EACCES) hint = "is its directory there, and writable?";
  if (code == EFBIG) hint = "`ulimit -f` or the file system allows no larger one";
  return system_error(path, "cannot write", code, hint);
}

/// write(data, size) for what is left, until nothing is; 0 or errno.
template <class Write>
int write_until_done(std::string_view content, const Write& write) {
  while (!content.empty()) {
    const std::size_t chunk = content.size() < (1u << 30) ? content.size() : (1u << 30);
    const ssize_t written = write(content.data(), chunk);
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

std::string temporary_name(const std::string& target) {
  static std::atomic<unsigned> counter{0};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return directory_of(target) + ".limn-" + std::to_string(::getpid()) + "-" +
         std::to_string(static_cast<std::uint64_t>(now) % 1000000007u) + "-" +
         std::to_string(counter.fetch_add(1)) + ".tmp";
}

int write_all(int fd, std::string_view content) {
  return write_until_done(
      content, [&](const char* data, std::size_t size) { return ::write(fd, data, size); });
}

int write_all_at(int fd, std::uint64_t at, std::string_view content) {
  const char* const begin = content.data();
  return write_until_done(content, [&](const char* data, std::size_t size) {
    return ::pwrite(fd, data, size,
                    static_cast<off_t>(at + static_cast<std::uint64_t>(data - begin)));
  });
}

Staged::Staged(std::string shown, std::string target, bool folder)
    : shown_(std::move(shown)),
      target_(std::move(target)),
      temporary_(temporary_name(target_)),
      folder_(folder),
      unfinished_(temporary_, folder ? Unfinished::Kind::folder : Unfinished::Kind::file) {}

Staged::Staged(Staged&& other) noexcept
    : shown_(std::move(other.shown_)),
      target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      folder_(other.folder_),
      pending_(std::exchange(other.pending_, false)),
      old_(std::exchange(other.old_, {})),
      was_there_(other.was_there_),
      unfinished_(std::move(other.unfinished_)) {}

Staged::~Staged() {
  forget_old();
  remove();
}

void Staged::remove() noexcept {
  if (!pending_) return;
  pending_ = false;
  std::error_code ignored;
  if (folder_)
    std::filesystem::remove_all(temporary_, ignored);
  else
    ::unlink(temporary_.c_str());
}

/// No fsync: a crash of the machine may lose the new content, a crash of the program never leaves
/// half of it.
Status Staged::fill(int fd, const Fill& fill) {
  Descriptor file(fd);
  int code = fill(file.get());
  const int close_code = file.close();
  if (code == 0) code = close_code;
  if (code != 0) return cannot_write(shown_, code);
  return Done{};
}

Result<Staged> Staged::file(const std::string& shown, const std::string& target, mode_t mode,
                            const Fill& fill) {
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    Staged staged(shown, target, false);
    const int fd =
        open_retrying(staged.temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOCTTY, 0666);
    if (fd < 0 && errno == EEXIST) continue;
    if (fd < 0) return cannot_write(shown, errno);
    staged.pending_ = true;
    // A file system without permission bits may refuse; the content matters more.
    if (mode != 0 && ::fchmod(fd, mode) != 0) errno = 0;
    if (Status status = staged.fill(fd, fill); !status) return status.error();
    return staged;
  }
  return cannot_write(shown, EEXIST);
}

Result<Staged> Staged::folder(const std::string& shown, const std::string& target) {
  for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
    Staged staged(shown, target, true);
    const bool made = ::mkdir(staged.temporary_.c_str(), 0777) == 0;
    if (!made && errno == EEXIST) continue;
    if (!made) return cannot_write(shown, errno);
    staged.pending_ = true;
    return staged;
  }
  return cannot_write(shown, EEXIST);
}

Status Staged::put_in_place(bool keep_old) {
  struct stat info {};
  was_there_ = !folder_ && ::lstat(target_.c_str(), &info) == 0;
  if (was_there_ && keep_old) {
    old_ = temporary_name(target_);
    if (::link(target_.c_str(), old_.c_str()) != 0) old_.clear();  // then it cannot come back
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return cannot_write(shown_, errno);
  pending_ = false;
  return Done{};
}

void Staged::undo() noexcept {
  if (pending_) return;
  std::error_code ignored;
  if (!old_.empty()) {
    ::rename(old_.c_str(), target_.c_str());
    old_.clear();
  } else if (folder_) {
    std::filesystem::remove_all(target_, ignored);
  } else if (!was_there_) {
    ::unlink(target_.c_str());
  }
}

void Staged::forget_old() noexcept {
  if (!old_.empty()) ::unlink(old_.c_str());
  old_.clear();
}

}  // namespace limn::base
