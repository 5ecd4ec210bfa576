#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/budget.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/report/tune_report.h"
#include "limn/report/tuned_scheme.h"
#include "options/tune_options.h"

namespace limn::app {
namespace {

/// What the options ask for, read against the scheme.
struct Task {
  Scheme scheme;
  FreedScheme freed;
  Requirement requirement;
  Valences valences;
  std::optional<SearchRange> between;

  [[nodiscard]] const SearchRange* searched() const { return between ? &*between : nullptr; }
};

Result<Task> read_task(const TuneOptions& options) {
  Result<Valences> valences = read_valences(options.valence);
  if (!valences) return valences.error();
  Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return scheme.error();
  Result<FreedScheme> freed = FreedScheme::make(
      *scheme, options.free.front(), options.everywhere ? Reach::everywhere : Reach::automatic);
  if (!freed) return freed.error();
  Result<Requirement> requirement = Requirement::parse(options.require.front(), *scheme);
  if (!requirement) return requirement.error();
  if (requirement->has_range() != options.range)
    return Error{fmt::format("requirement '{}' {}", requirement->text,
                             options.range ? "is an equation, which has no range"
                                           : "is no equation, so that it holds in a range"),
                 options.range ? "leave out --range" : "add --range"};
  if (!options.output.empty())
    if (Status status = check_scheme_path(options.output); !status) return status.error();
  if (Status status = check_outputs({options.output}); !status) return status.error();
  if (options.range && !options.output.empty())
    return Error{"-o writes solutions, not ranges", "leave out -o or --range"};
  std::optional<SearchRange> between;
  if (options.between.size() > 1)
    return Error{"--between is given more than once", "one name has one range"};
  if (!options.between.empty()) {
    Result<SearchRange> read = SearchRange::parse(options.between.front());
    if (!read) return read.error();
    between = std::move(*read);
  }
  return Task{std::move(*scheme), std::move(*freed), std::move(*requirement), *valences,
              std::move(between)};
}

nlohmann::ordered_json heading_json(const Task& task, const nlohmann::ordered_json& valences,
                                    const Walk& walk) {
  return {{"scheme", task.scheme.name},
          {"free", task.freed.name()},
          {"require", task.requirement.text},
          {"valences", valences},
          {"time_ended", walk.ended_early()}};
}

/// What was solved, as it is printed.
struct Solved {
  std::vector<ValenceSolutions> all;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text;
  bool undecided = false;
  bool any_value = false;
  Error without_value;  ///< why the last of those without a value has none
};

Result<Solved> solve_each(Task& task, Walk& walk, bool json) {
  Solved solved;
  const Status status = walk.each([&](int n) -> Result<bool> {
    Result<ValenceSolutions> found =
        solve_at(task.freed, task.requirement, n, task.searched(), walk.stop());
    if (!found) return found.error();
    if (found->time_ended) return false;
    for (const Solution& solution : found->solutions)
      solved.undecided = solved.undecided || solution.holds == Truth::undecided;
    solved.any_value = solved.any_value || found->has_value;
    if (!found->has_value) solved.without_value.message = found->reason;
    if (json)
      solved.list.push_back(report::tune_json(*found));
    else
      solved.text += report::tune_text(task.freed.name(), *found);
    solved.all.push_back(std::move(*found));
    return true;
  });
  if (!status) return status.error();
  return solved;
}

int solve(Task& task, const TuneOptions& options) {
  Walk walk(task.valences, options.seconds);
  const Result<Solved> solved = solve_each(task, walk, options.json);
  if (!solved) return report(solved.error());
  if (walk.ended_early() && !options.output.empty())
    return report({walk.what_was_reached() + ", so that no file is written", kMoreTime});
  if (!solved->any_value && !solved->all.empty()) return report(solved->without_value);
  const auto text_of = [&](const std::string& extends) {
    return report::tuned_scheme_text(task.freed, task.requirement, solved->all, extends);
  };
  if (!options.output.empty())
    if (Status written = write_tuned(options, text_of); !written) return report(written.error());
  if (options.json) {
    print_json(heading_json(task, solved->list, walk));
  } else {
    std::string text = fmt::format("{}: {} such that {}\n", base::printable(task.scheme.name),
                                   task.freed.name(), base::printable(task.requirement.text)) +
                       report::solution_heading(task.freed.name()) + solved->text;
    if (walk.ended_early()) text += walk.what_was_reached() + "; " + kMoreTime + "\n";
    print_text(text);
  }
  return solved->undecided ? kUndecided : kDone;
}

int find_ranges(Task& task, const TuneOptions& options) {
  const bool json = options.json;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text = fmt::format("{}: {} such that {}\n", base::printable(task.scheme.name),
                                 task.freed.name(), base::printable(task.requirement.text));
  std::vector<ValenceRange> ranges;
  bool undecided = false;
  Walk walk(task.valences, options.seconds);
  const Status status = walk.each([&](int n) -> Result<bool> {
    Result<ValenceRange> found =
        range_at(task.freed, task.requirement, n, task.searched(), walk.stop());
    if (!found) return found.error();
    if (found->time_ended) return false;
    if (json)
      list.push_back(report::tune_json(*found));
    else
      text += report::tune_text(task.freed.name(), *found);
    undecided = undecided || found->undecided;
    ranges.push_back(std::move(*found));
    return true;
  });
  if (!status) return report(status.error());
  const std::vector<Interval> common = common_range(ranges);
  if (ranges.size() > 1) text += report::common_text(task.freed.name(), common);
  if (walk.ended_early()) text += walk.what_was_reached() + "; " + kMoreTime + "\n";
  if (json) {
    nlohmann::ordered_json object = heading_json(task, list, walk);
    object["common"] = report::intervals_json(common);
    print_json(object);
  } else {
    print_text(text);
  }
  return undecided ? kUndecided : kDone;
}

int tune(const TuneOptions& options) {
  if (options.free.size() > 1 || options.require.size() > 1) return tune_system(options);
  Result<Task> task = read_task(options);
  if (!task) return report(task.error());
  return options.range ? find_ranges(*task, options) : solve(*task, options);
}

}  // namespace

void declare_tune(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "tune",
      "the values of a parameter or a let at which the eigencomponents are as required");
  const auto options = std::make_shared<TuneOptions>();
  command->add_option("SCHEME", options->scheme.name, kSchemeArgumentHelp)->required();
  command
      ->add_option("--free", options->free,
                   "the parameter or let that is to be found; as many as there are")
      ->type_name("NAME")
      ->required()
      ->allow_extra_args(false);
  command
      ->add_option(
          "--require", options->require,
          "an equation in position, tangent, cup, saddle, n and the scheme's names; with "
          "--range an inequality, c1 (what it needs of the eigenvalues), convergent or "
          "bounded-curvature (by the eigenvalues and the regular lattice). Of several, the "
          "equations are solved, and the others asked of each solution")
      ->type_name("TEXT")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--valence", options->valence, "a valence, or a range of them")
      ->type_name("N or A..B")
      ->capture_default_str();
  command
      ->add_option("--between", options->between,
                   "look here alone; else in the parameter's range, or from -4 to 4; of several "
                   "names the ranges in their order")
      ->type_name("LOW,HIGH")
      ->allow_extra_args(false);
  command
      ->add_option("-o,--output", options->output,
                   "also write a scheme file with the solutions, in fractions, to FILE (.toml)")
      ->type_name("FILE");
  command->add_flag("--range", options->range, "the range in which the requirement holds");
  command->add_flag("--everywhere", options->everywhere,
                    "the value is that of the regular neighbours, too");
  declare_time(*command, options->seconds, "how long to go on to further valences");
  options->scheme.declare_parameters(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn tune sqrt3 --free alpha --require \"cup = tangent^2\"\n"
      "         limn tune mine.toml --free s --free r --require \"cup = tangent^2\" --require "
      "\"saddle = tangent^2\"");
  command->callback([&action, options] { action = [options] { return tune(*options); }; });
}

}  // namespace limn::app
