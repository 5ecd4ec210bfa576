#pragma once
/// Several files, written together or not at all.

#include <memory>

#include "limn/base/error.h"

namespace limn::base {

/// While it lives, `write_file` and `make_folder` of its thread only prepare what they are asked
/// for, under temporary names beside the true ones; `commit` gives all of it its names. Without
/// `commit` nothing is left of it. A file can be written once in it. What cannot be replaced by a
/// rename (standard output, devices, pipes) is written at once all the same.
class FileTransaction {
 public:
  /// One at a time in a thread.
  FileTransaction();
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;
  ~FileTransaction();

  /// Renames one after the other; meanwhile the signals of this thread wait. Where a rename fails,
  /// the earlier ones are undone as far as the file system allows (old content is kept by a hard
  /// link until the end), and the error names the file. Call it once.
  [[nodiscard]] Status commit();

  struct Parts;

 private:
  std::unique_ptr<Parts> parts_;
};

}  // namespace limn::base
