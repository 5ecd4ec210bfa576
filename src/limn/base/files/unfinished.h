#pragma once
/// Names of what is not finished yet, kept where the handler of a signal may read them.

#include <string>

namespace limn::base {

/// While it lives, `path` is removed by `remove_unfinished_files`: a file, or a folder that is
/// empty once the files of it that are known here are removed. Make it before the file, so that no
/// signal falls between the two. Thread-safe.
class Unfinished {
 public:
  enum class Kind { file, folder };
  explicit Unfinished(const std::string& path, Kind kind = Kind::file);
  Unfinished(Unfinished&& other) noexcept : node_(other.node_) { other.node_ = nullptr; }
  Unfinished& operator=(Unfinished&&) = delete;
  ~Unfinished();

  struct Node;

 private:
  Node* node_;
};

/// Removes what is unfinished. Async-signal-safe: for the handler of a signal that ends the
/// process.
void remove_unfinished_files() noexcept;

}  // namespace limn::base
