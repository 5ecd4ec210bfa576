#pragma once
/// Files and folders that are prepared under a temporary name beside the true one.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "limn/base/error.h"
#include "limn/base/files/unfinished.h"

namespace limn::base {

/// A name beside `target` that no other process is likely to use.
[[nodiscard]] std::string temporary_name(const std::string& target);

/// Writes all of it, whatever pieces the system takes; 0 or errno.
[[nodiscard]] int write_all(int fd, std::string_view content);
/// The same so many bytes from the file's beginning; from several threads at once.
[[nodiscard]] int write_all_at(int fd, std::uint64_t at, std::string_view content);

/// A file or a folder that waits for its name. What has none at the end of its scope is removed.
class Staged {
 public:
  /// Writes to the descriptor; 0 or errno.
  using Fill = std::function<int(int fd)>;

  /// A file with what `fill` writes. `shown`: the path for messages; `target`: what it becomes;
  /// `mode`: permission bits, or 0 for those of a new file (the umask decides).
  [[nodiscard]] static Result<Staged> file(const std::string& shown, const std::string& target,
                                           mode_t mode, const Fill& fill);
  /// An empty folder.
  [[nodiscard]] static Result<Staged> folder(const std::string& shown, const std::string& target);

  Staged(Staged&& other) noexcept;
  Staged& operator=(Staged&&) = delete;
  ~Staged();

  [[nodiscard]] const std::string& shown() const { return shown_; }
  [[nodiscard]] const std::string& target() const { return target_; }
  [[nodiscard]] const std::string& temporary() const { return temporary_; }

  /// Gives it its name. With `keep_old`, so that `undo` can bring back what had it before.
  [[nodiscard]] Status put_in_place(bool keep_old = false);
  /// Takes `put_in_place` back, as far as possible; what was new is gone again.
  void undo() noexcept;
  /// What `keep_old` kept is no longer needed.
  void forget_old() noexcept;

 private:
  Staged(std::string shown, std::string target, bool folder);
  [[nodiscard]] Status fill(int fd, const Fill& fill);
  void remove() noexcept;

  std::string shown_, target_, temporary_;
  bool folder_;
  bool pending_ = false;  // there is something of the temporary name
  std::string old_;       // a link to what had the name before, or empty
  bool was_there_ = false;
  Unfinished unfinished_;
};

}  // namespace limn::base
