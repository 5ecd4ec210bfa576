#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/report/study_files.h"
#include "options/number_option.h"
#include "options/time_option.h"
#include "python_module.h"

namespace limn::app {
namespace {

struct StudyCommand {
  std::string study, output, dask;
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
    print_json(report::quantities_json());
  else
    print_text(report::quantities_text());
  return kDone;
}

int forecast(const search::Study& study, const StudyCommand& command) {
  const Result<search::StudyForecast> found = search::forecast_study(study);
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
        base::printable(study.title.empty() ? study.file : study.title), found->points,
        study.coordinates.size(), time_text(found->seconds_each), found->measured,
        time_text(found->seconds), found->threads));
  }
  return kDone;
}

Result<search::StudyRun> run(const search::Study& study, search::Store& store,
                             const StudyCommand& command, base::ProgressLine& line) {
  const TimeBudget budget(time_limit(command.seconds));
  search::StudyOptions options;
  options.stop = budget.stop();
  options.progress = [&line](const search::StudyProgress& at) {
    line.show(fmt::format("point {} of {}, {} feasible, generation {}, {} left at most", at.done,
                          at.most, at.feasible, at.generation, time_text(at.seconds_left)));
  };
  return search::run_study(study, store, options);
}

int carry_out(const search::Study& study, const StudyCommand& command) {
  Result<search::Store> store = report::open_study_folder(study, command.output, command.restart);
  if (!store) return report(store.error());
  base::ProgressLine line;
  const Result<search::StudyRun> done = run(study, *store, command, line);
  if (!done) return report(done.error());
  report::StudyFiles files{
      .folder = command.output, .all_points = command.csv, .schemes = command.schemes};
  files.progress = [&line](const std::string& what) { line.show(what); };
  std::string text;
  nlohmann::ordered_json json;
  if (const Status status = report::conclude_study(study, *done, files, text, json); !status)
    return report(status.error());
  if (command.json)
    print_json(json);
  else
    print_text(text);
  return kDone;
}

/// The same study, its points evaluated by the workers of a Dask scheduler: Python's part.
int leave_to_dask(const StudyCommand& command) {
  std::vector<std::string> words{command.study,
                                 "-o",
                                 command.output,
                                 "--dask",
                                 command.dask,
                                 "--best",
                                 std::to_string(command.schemes)};
  if (command.seconds > 0)
    words.insert(words.end(), {"--time", fmt::format("{}", command.seconds)});
  if (command.csv) words.emplace_back("--csv");
  if (command.restart) words.emplace_back("--restart");
  if (command.json) words.emplace_back("--json");
  if (is_quiet()) words.emplace_back("--quiet");
  return report(become_python("limn.study", "distributed", words));
}

int study(const StudyCommand& command) {
  if (command.quantities) return list_quantities(command);
  if (command.study.empty())
    return report(Error{"STUDY.toml is missing", "`limn study --help` explains the use"});
  const Result<search::Study> read = search::read_study(command.study);
  if (!read) return report(read.error());
  if (command.dry_run) return forecast(*read, command);
  if (command.output.empty())
    return report(Error{"-o is missing: a study is kept in a folder",
                        "add -o FOLDER, or --dry-run to see what it costs"});
  if (command.output == base::kStandardStream)
    return report(Error{"a study is kept in a folder, which cannot be standard output"});
  return command.dask.empty() ? carry_out(*read, command) : leave_to_dask(command);
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
  command
      ->add_option("--dask", chosen->dask,
                   "have the points evaluated by the workers of this Dask scheduler, as "
                   "tcp://host:8786 (starts python3 -m limn.study)")
      ->type_name("SCHEDULER");
  command->add_flag("--restart", chosen->restart, "throw away the points that the folder holds");
  command->add_flag("--quantities", chosen->quantities,
                    "list the numbers that a study can ask for");
  command->add_flag("--json", chosen->json, "print one JSON object");
  command->footer(
      "Example: limn study loop-family.toml --dry-run\n"
      "         limn study loop-family.toml -o loop-family --csv\n"
      "         limn study loop-family.toml -o loop-family --dask tcp://10.0.0.1:8786");
  command->callback([&action, chosen] { action = [chosen] { return study(*chosen); }; });
}

}  // namespace limn::app
