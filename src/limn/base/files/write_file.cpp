#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>

#include "limn/base/files/file.h"
#include "limn/base/files/staged_file.h"
#include "limn/base/files/system_file.h"
#include "limn/base/files/transaction_parts.h"

namespace limn::base {
namespace {

using Fill = Staged::Fill;

/// What `fill` gives, piece after piece; after an error the rest is dropped.
Fill in_order(const std::function<void(const Sink&)>& fill) {
  return [&fill](int fd) {
    int code = 0;
    fill([&](std::string_view piece) {
      if (code == 0) code = write_all(fd, piece);
    });
    return code;
  };
}

/// What `fill` gives, each piece where it belongs; after an error the rest is dropped.
Fill at_places(const std::function<Status(const PlacedSink&)>& fill, Status& given) {
  return [&fill, &given](int fd) {
    std::atomic<int> code = 0;
    given = fill([&](std::uint64_t at, std::string_view piece) {
      if (code.load(std::memory_order_relaxed) != 0) return;
      if (const int failed = write_all_at(fd, at, piece); failed != 0) code = failed;
    });
    return given ? code.load() : ECANCELED;
  };
}

/// What cannot be replaced by a rename; `fd` is closed.
Status write_directly(const std::string& path, int fd, const Fill& fill) {
  Descriptor file(fd);
  if (!file.open()) return system_error(path, "cannot open for writing", errno);
  int code = fill(file.get());
  if (code == 0) code = file.close();
  if (code != 0) return system_error(path, "cannot write", code);
  return Done{};
}

Status write_to_descriptor(const std::string& path, int fd, const Fill& fill) {
  return write_directly(path, ::fcntl(fd, F_DUPFD_CLOEXEC, 3), fill);
}

/// The descriptor that `path` means, or none; where symbolic links lead otherwise.
Target output_target(const std::string& path) {
  if (path == kStandardStream) return {path, STDOUT_FILENO, 0};
  return target_of(path);
}

/// Whether a file that is there may be replaced.
Status check_replaceable(const std::string& path, const struct stat& info) {
  if (S_ISDIR(info.st_mode)) return system_error(path, "cannot write", EISDIR);
  // A rename would replace even a file that is read-only.
  if (::access(path.c_str(), W_OK) != 0) return system_error(path, "cannot write", errno);
  return Done{};
}

/// Writes what `fill` writes to `path`, or what stands there for the time being.
Status write_filled(const std::string& path, const Fill& fill) {
  if (path.empty()) return system_error(path, "cannot write to an empty path", ENOENT);
  FileTransaction::Parts* const transaction = FileTransaction::Parts::current();
  const std::string present = transaction != nullptr ? transaction->present_path(path) : path;
  const Target target = output_target(present);
  if (target.descriptor) return write_to_descriptor(path, *target.descriptor, fill);
  struct stat info {};
  const bool exists = ::stat(present.c_str(), &info) == 0;
  if (exists)
    if (Status status = check_replaceable(present, info); !status) {
      status.error().file = path;
      return status;
    }
  if (exists && !S_ISREG(info.st_mode))
    return write_directly(path, open_retrying(present.c_str(), O_WRONLY | O_NOCTTY), fill);
  if (target.error != 0) return system_error(path, "cannot write", target.error);
  const mode_t mode = exists ? static_cast<mode_t>(info.st_mode & 0777) : 0;
  Result<Staged> staged = Staged::file(path, target.path, mode, fill);
  if (!staged) return staged.error();
  if (transaction != nullptr) return transaction->add(*std::move(staged));
  return staged->put_in_place();
}

}  // namespace

Status write_file(const std::string& path, std::string_view content) {
  return write_file(path, [&](const Sink& sink) { sink(content); });
}

Status write_file(const std::string& path, const std::function<void(const Sink&)>& fill) {
  return write_filled(path, in_order(fill));
}

bool takes_places(const std::string& path) {
  if (path.empty()) return false;
  FileTransaction::Parts* const transaction = FileTransaction::Parts::current();
  const std::string present = transaction != nullptr ? transaction->present_path(path) : path;
  if (output_target(present).descriptor) return false;
  struct stat info {};
  return ::stat(present.c_str(), &info) != 0 || S_ISREG(info.st_mode);
}

Status write_file_at_places(const std::string& path,
                            const std::function<Status(const PlacedSink&)>& fill) {
  assert(takes_places(path));
  Status given = Done{};
  Status written = write_filled(path, at_places(fill, given));
  return given ? written : given;
}

Status check_can_write(const std::string& path) {
  if (path.empty()) return system_error(path, "cannot write to an empty path", ENOENT);
  const Target target = output_target(path);
  if (target.descriptor) {
    const int flags = ::fcntl(*target.descriptor, F_GETFL);
    if (flags >= 0 && (flags & O_ACCMODE) != O_RDONLY) return Done{};
    return system_error(path, "cannot write", EBADF);
  }
  if (target.error != 0) return system_error(path, "cannot write", target.error);
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0) {
    if (Status status = check_replaceable(path, info); !status || !S_ISREG(info.st_mode))
      return status;
  } else if (errno != ENOENT) {
    return system_error(path, "cannot write", errno);
  }
  if (target.path.ends_with('/')) return system_error(path, "cannot write", EISDIR);
  std::string folder = directory_of(target.path);
  if (folder.empty()) folder = ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return system_error(path, "cannot write", errno, "is its directory there, and writable?");
  return Done{};
}

}  // namespace limn::base
