#pragma once
/// Progress of long work, for a terminal: one line that rewrites itself, once a second has passed.

#include <chrono>
#include <string>

namespace limn::base {

class ProgressLine {
 public:
  /// Writes nothing unless standard error is a terminal and `wanted`.
  explicit ProgressLine(bool wanted = true);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows `text` in place of the last one, if the work has taken over a second so far.
  void show(const std::string& text);
  /// The same, however early.
  void show_now(const std::string& text);

  /// From now on no line shows anything.
  static void show_none();

 private:
  std::chrono::steady_clock::time_point start_;
  bool enabled_;
  bool shown_ = false;
};

}  // namespace limn::base
