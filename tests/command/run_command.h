#pragma once
/// Runs the built command as a user would, in a folder of its own.

#include <concepts>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace limn::test {

struct Outcome {
  int code = -1;  ///< exit status; 128 + signal where one ended it
  std::string out, err;
};

/// A temporary folder in which the command runs.
class Folder {
 public:
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  void write(const std::string& name, const std::string& content) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  /// Names of the files in it.
  [[nodiscard]] int count() const;

  /// `limn ARGUMENTS`, run by a shell in this folder; `prefix` goes before the command.
  [[nodiscard]] Outcome limn(const std::string& arguments, const std::string& prefix = {}) const;
  /// Lines of a shell in this folder, where $LIMN is the command; standard input is empty.
  [[nodiscard]] Outcome shell(const std::string& script) const;

 private:
  TemporaryFolder temporary_;
  std::string path_ = temporary_.path().string();
};

/// Bad input: exit 2, the reason on standard error with these parts, nothing on standard output.
void expect_refused(const Outcome& outcome, const std::vector<std::string>& parts);
template <std::convertible_to<std::string> Part>
void expect_refused(const Outcome& outcome, const Part& part) {
  expect_refused(outcome, std::vector<std::string>{part});
}

}  // namespace limn::test
