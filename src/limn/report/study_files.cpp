#include "limn/report/study_files.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/certify/certificate/certificate_json.h"
#include "limn/certify/certify.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/search/front.h"

namespace limn::report {
namespace {

namespace fs = std::filesystem;

/// Schemes of an earlier run, of which there may have been more.
Status remove_old(const std::string& folder) {
  static const std::regex numbered(R"(\d+(\.certificate\.json|\.toml))");
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (std::regex_match(entry.path().filename().string(), numbered))
      fs::remove(entry.path(), failed);
  if (failed) return Error{"cannot be written: " + failed.message(), {}, folder};
  return Done{};
}

std::string notes_of(const StudyResult& result, const search::Evaluated& one) {
  std::string notes = "Found by a study";
  if (!result.study.title.empty()) notes += fmt::format(", {}", result.study.title);
  for (std::size_t i = 0; i < result.study.objectives.size(); ++i)
    notes += fmt::format("{} {} = {:.8g}", i == 0 ? ":" : ",",
                         result.study.objectives[i].value.text(), *one.outcome.objectives[i]);
  return notes + ".";
}

/// Whether the scheme of the file has, to the last bit, what was found.
Status compare_again(const search::Study& study, const Scheme& scheme, const search::Evaluated& one,
                     const std::string& path) {
  const search::Outcome again = search::evaluate_scheme(study, scheme);
  if (again.feasible == one.outcome.feasible && again.objectives == one.outcome.objectives)
    return Done{};
  return Error{"the scheme that was written does not have the numbers that the store has",
               "the store may be of another version of limn: run the study with --restart", path};
}

Status write_certificate(const search::Study& study, const Scheme& scheme,
                         const std::string& path) {
  const Result<certify::Certificate> certificate =
      certify::certify(scheme, study.valences, study.certify_options());
  if (!certificate) return certificate.error();
  if (Status shown = certify::check_certificate(*certificate); !shown) return shown;
  return base::write_file(path, certify::certificate_json(*certificate).dump(1) + "\n");
}

Status write_schemes(const StudyResult& result, const StudyFiles& files,
                     nlohmann::ordered_json& json) {
  const search::Study& study = result.study;
  const std::string folder = files.folder + "/best";
  if (Status status = remove_old(folder); !status) return status;
  const bool certified = std::any_of(study.demands.begin(), study.demands.end(),
                                     [](const search::Demand& demand) { return demand.certified; });
  const std::string base = study.folder.empty()
                               ? study.scheme_name
                               : (fs::path(study.folder) / study.scheme_name).string();
  const std::vector<std::string> shipped = shipped_schemes();
  const bool is_shipped =
      std::find(shipped.begin(), shipped.end(), study.scheme_name) != shipped.end();
  const std::vector<std::size_t> chosen = search::spread(study, result.run.points, result.best,
                                                         static_cast<std::size_t>(files.schemes));
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (files.progress) files.progress(fmt::format("scheme {} of {}", k + 1, chosen.size()));
    const search::Evaluated& one = result.run.points[chosen[k]];
    const std::string name = fmt::format("{}/{:02}", folder, k + 1);
    const std::string path = name + ".toml";
    const Result<std::string> extends =
        scheme::extended_name(is_shipped ? study.scheme_name : base, path);
    if (!extends) return extends.error();
    const std::string text = search::point_text(study, one.point, *extends, notes_of(result, one));
    const Result<Scheme> back = parse_scheme(text, path);
    if (!back) return scheme::not_written(back.error(), path);
    if (Status status = compare_again(study, *back, one, path); !status) return status;
    if (Status status = base::write_file(path, text); !status) return status;
    const auto at = std::find(result.best.begin(), result.best.end(), chosen[k]);
    nlohmann::ordered_json& entry =
        json["best"][static_cast<std::size_t>(at - result.best.begin())];
    entry["scheme"] = path;
    if (!certified) continue;
    const std::string certificate = name + ".certificate.json";
    if (Status status = write_certificate(study, *back, certificate); !status) return status;
    entry["certificate"] = certificate;
  }
  return Done{};
}

Status write_all(const StudyResult& result, const StudyFiles& files, nlohmann::ordered_json& json) {
  const std::string& folder = files.folder;
  if (Status status = write_schemes(result, files, json); !status) return status;
  if (Status status = base::write_file(folder + "/front.csv", csv_text(front_table(result)));
      !status)
    return status;
  if (files.all_points)
    if (Status status = base::write_file(folder + "/points.csv",
                                         csv_text(study_table(result.study, result.run.points)));
        !status)
      return status;
  if (result.best.empty()) return Done{};
  const figure::Figure figure = study_figure(result);
  for (const char* name : {"/front.svg", "/front.pdf"})
    if (Status status = figure.write(folder + name); !status) return status;
  return Done{};
}

}  // namespace

Result<search::Store> open_study_folder(const search::Study& study, const std::string& folder,
                                        bool restart) {
  std::error_code failed;
  fs::create_directories(folder + "/best", failed);
  if (failed) return Error{"the folder cannot be made: " + failed.message(), {}, folder};
  return search::Store::open(folder + "/study.sqlite", study, restart);
}

Status conclude_study(const search::Study& study, const search::StudyRun& run,
                      const StudyFiles& files, std::string& text, nlohmann::ordered_json& json) {
  StudyResult result{study, run};
  result.best = search::best_points(study, run.points);
  for (const search::Landmark& one : study.landmarks) {
    if (files.progress) files.progress("other schemes: " + base::printable(one.label));
    result.landmarks.push_back({one.label, search::evaluate_scheme(study, one.scheme)});
  }
  json = study_json(result);
  if (Status status = write_all(result, files, json); !status) return status;
  text = study_text(result);
  if (!run.finished) text += "the time ended: the same command goes on from here\n";
  text += fmt::format("written to {}\n", base::printable(files.folder));
  return Done{};
}

}  // namespace limn::report
