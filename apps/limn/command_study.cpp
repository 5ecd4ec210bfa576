#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/search/front.h"
#include "limn/search/run_study.h"
#include "options/number_option.h"
#include "options/time_option.h"
#include "output/study_output.h"

namespace limn::app {
namespace {

struct StudyCommand {
  std::string study, output;
  double seconds = 0;
  int schemes = 12;
  bool dry_run = false, csv = false, restart = false, quantities = false, json = false;
};

std::string time_text(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds < 100) return fmt::format("{:.2g} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

int list_quantities(const StudyCommand& command) {
  if (command.json)
    print_json(quantities_json());
  else
    print_text(quantities_text());
  return kDone;
}

int forecast(const Study& study, const StudyCommand& command) {
  const Result<StudyForecast> found = forecast_study(study);
  if (!found) return report(found.error());
  if (command.json) {
    print_json({{"study", study.title.empty() ? study.file : study.title},
                {"points", found->points},
                {"measured", found->measured},
                {"seconds_each", found->seconds_each},
                {"threads", found->threads},
                {"seconds", found->seconds}});
  } else {
    print_text(fmt::format(
        "{}: at most {} points of {} coordinates; {} each ({} measured), about {} on {} threads\n",
        printable(study.title.empty() ? study.file : study.title), found->points,
        study.coordinates.size(), time_text(found->seconds_each), found->measured,
        time_text(found->seconds), found->threads));
  }
  return kDone;
}

/// The folder is made at once: the store must last if the run does not.
Status make_folders(const std::string& path) {
  std::error_code failed;
  std::filesystem::create_directories(path + "/best", failed);
  if (failed) return Error{"the folder cannot be made: " + failed.message(), {}, path};
  return Done{};
}

std::vector<LandmarkOutcome> landmarks_of(const Study& study, ProgressLine& line) {
  std::vector<LandmarkOutcome> list;
  for (const Landmark& one : study.landmarks) {
    line.show("other schemes: " + printable(one.label));
    list.push_back({one.label, evaluate_scheme(study, one.scheme)});
  }
  return list;
}

Result<StudyRun> run(const Study& study, const StudyCommand& command, ProgressLine& line) {
  Result<Store> store = Store::open(command.output + "/study.sqlite", study, command.restart);
  if (!store) return store.error();
  const TimeBudget budget(time_limit(command.seconds));
  StudyOptions options;
  options.stop = budget.stop();
  options.progress = [&line](const StudyProgress& at) {
    line.show(fmt::format("point {} of {}, {} feasible, generation {}, {} left at most", at.done,
                          at.most, at.feasible, at.generation, time_text(at.seconds_left)));
  };
  return run_study(study, *store, options);
}

int carry_out(const Study& study, const StudyCommand& command) {
  if (Status status = make_folders(command.output); !status) return report(status.error());
  ProgressLine line;
  const Result<StudyRun> done = run(study, command, line);
  if (!done) return report(done.error());
  StudyResult result{study, *done};
  result.best = best_points(study, done->points);
  result.landmarks = landmarks_of(study, line);
  nlohmann::ordered_json json = study_json(result);
  StudyFiles files{.folder = command.output, .all_points = command.csv, .schemes = command.schemes};
  files.progress = [&line](const std::string& what) { line.show(what); };
  if (Status status = write_study_files(result, files, json); !status)
    return report(status.error());
  if (command.json) {
    print_json(json);
    return kDone;
  }
  std::string text = study_text(result);
  if (!done->finished) text += "the time ended: the same command goes on from here\n";
  print_text(text + fmt::format("written to {}\n", printable(command.output)));
  return kDone;
}

int study(const StudyCommand& command) {
  if (command.quantities) return list_quantities(command);
  if (command.study.empty())
    return report(Error{"STUDY.toml is missing", "`limn study --help` explains the use"});
  const Result<Study> read = read_study(command.study);
  if (!read) return report(read.error());
  if (command.dry_run) return forecast(*read, command);
  if (command.output.empty())
    return report(Error{"-o is missing: a study is kept in a folder",
                        "add -o FOLDER, or --dry-run to see what it costs"});
  if (command.output == kStandardStream)
    return report(Error{"a study is kept in a folder, which cannot be standard output"});
  return carry_out(*read, command);
}

}  // namespace

void declare_study(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "study", "searches a family of schemes: sweeps, optima and Pareto fronts, resumable");
  const auto chosen = std::make_shared<StudyCommand>();
  command->add_option(
      "STUDY", chosen->study,
      "a study file (.toml): scheme, free numbers, objectives, requirements, method");
  command
      ->add_option("-o,--output", chosen->output,
                   "keep the study in this folder, and go on from what it holds")
      ->type_name("FOLDER");
  command->add_flag("--dry-run", chosen->dry_run,
                    "say how many points there are and what they cost, by a few that are measured");
  command->add_flag("--csv", chosen->csv, "also write all points to points.csv");
  command
      ->add_option("--best", chosen->schemes, "write so many schemes of the front, spread over it")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  declare_time(*command, chosen->seconds,
               "stop after so long; the same command goes on from there");
  command->add_flag("--restart", chosen->restart, "throw away the points that the folder holds");
  command->add_flag("--quantities", chosen->quantities,
                    "list the numbers that a study can ask for");
  command->add_flag("--json", chosen->json, "print one JSON object");
  command->footer(
      "Example: limn study loop-family.toml --dry-run\n"
      "         limn study loop-family.toml -o loop-family --csv");
  command->callback([&action, chosen] { action = [chosen] { return study(*chosen); }; });
}

}  // namespace limn::app
