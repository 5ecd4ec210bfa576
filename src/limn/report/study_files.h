#pragma once
/// The folder of a study: its store, and the files of what was found.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/report/study_report.h"
#include "limn/search/store.h"

namespace limn::report {

/// FOLDER/study.sqlite; the folder is made. Fails as Store::open does, and where there can be no
/// such folder.
[[nodiscard]] Result<search::Store> open_study_folder(const search::Study& study,
                                                      const std::string& folder,
                                                      bool restart = false);

struct StudyFiles {
  std::string folder;  ///< open_study_folder has made it
  bool all_points = false;
  int schemes = 12;                                       ///< of the front, at most
  std::function<void(const std::string&)> progress = {};  ///< what is done next
};

/// Finds the best points, evaluates the schemes to compare with, and writes front.csv, front.svg,
/// front.pdf, with all_points points.csv, and best/01.toml …: schemes of the front, read back and
/// evaluated anew, with certificates (checked) where the study has demands that are certified.
/// Puts what `limn study` prints into `text` and `json`: study_json, with "scheme" and
/// "certificate" in "best" where there are such files. Fails where a scheme does not come out as it
/// was found.
[[nodiscard]] Status conclude_study(const search::Study& study, const search::StudyRun& run,
                                    const StudyFiles& files, std::string& text,
                                    nlohmann::ordered_json& json);

}  // namespace limn::report
