#pragma once
/// The papers that limn makes anew: one line for each, in papers.cpp, and a page that lists them.

#include <string>
#include <vector>

#include "papers/paper_page.h"

namespace limn {

struct Paper {
  std::string name;  ///< in commands, and of its folder
  std::string authors, title;
  std::string picture;  ///< one of its figures, to show on the list
  std::string content;  ///< what of it its page holds
  /// Makes the folder with index.html.
  Status (*write)(const std::string& directory, const PaperProgress& progress);
};

/// In order of their names.
[[nodiscard]] const std::vector<Paper>& papers();

/// `directory`/index.html, which leads to the papers' own pages in `directory`/NAME.
[[nodiscard]] Status write_paper_list(const std::string& directory,
                                      const std::vector<const Paper*>& written);

}  // namespace limn
