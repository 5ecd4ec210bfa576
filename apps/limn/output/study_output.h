#pragma once
/// The files of `limn study`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/report/study_report.h"

namespace limn::app {

struct StudyFiles {
  std::string folder;  ///< exists
  bool all_points = false;
  int schemes = 12;  ///< of the front, at most
  std::function<void(const std::string&)> progress = {};
};

/// front.csv, front.svg, front.pdf, with all_points points.csv, and best/01.toml …: schemes of the
/// front, read back and evaluated anew, with certificates (checked) where the study has demands
/// that are certified. Adds "scheme" and "certificate" to the entries of "best" in `json` that have
/// such files. Fails where a scheme does not come out as it was found.
[[nodiscard]] Status write_study_files(const StudyResult& result, const StudyFiles& files,
                                       nlohmann::ordered_json& json);

}  // namespace limn::app
