#pragma once
/// What a FileTransaction has prepared so far.

#include <optional>
#include <string>
#include <vector>

#include "limn/base/files/file_transaction.h"
#include "limn/base/files/staged_file.h"

namespace limn::base {

struct FileTransaction::Parts {
  /// This thread's, or null.
  [[nodiscard]] static Parts* current();

  /// Where `path` lies until the commit: elsewhere only in folders that are not there yet.
  [[nodiscard]] std::string present_path(const std::string& path) const;

  /// Fails where it has one of the same target.
  [[nodiscard]] Status add(Staged file);

  /// Makes what is missing of a folder.
  [[nodiscard]] Status add_folder(const std::string& path);

  std::vector<Staged> folders;         ///< each with everything below it
  std::vector<Unfinished> subfolders;  ///< of these; the transaction's files know themselves
  std::vector<Staged> files;           ///< in the order of writing; also those in new folders
};

}  // namespace limn::base
