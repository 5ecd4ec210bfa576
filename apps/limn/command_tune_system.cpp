#include <algorithm>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/report/system_report.h"
#include "options/tune_options.h"

namespace limn::app {
namespace {

/// What the options ask for, read against the scheme.
struct SystemTask {
  Scheme scheme;
  tune::FreedNames names;
  std::vector<Requirement> requirements;
  Valences valences;
  std::vector<std::optional<SearchRange>> between;

  [[nodiscard]] std::vector<const SearchRange*> searched() const {
    std::vector<const SearchRange*> list;
    for (const auto& range : between) list.push_back(range ? &*range : nullptr);
    return list;
  }
};

Status check_use(const TuneOptions& options) {
  if (options.range)
    return Error{"--range is for one free name and one requirement",
                 "leave it out: inequalities are asked of each solution of the equations"};
  if (!options.between.empty() && options.between.size() != options.free.size())
    return Error{fmt::format("--between is given {} times for {} names", options.between.size(),
                             options.free.size()),
                 "give it once for each --free, in their order"};
  if (!options.output.empty())
    if (Status status = check_scheme_path(options.output); !status) return status;
  return check_outputs({options.output});
}

Result<SystemTask> read_system_task(const TuneOptions& options) {
  if (Status status = check_use(options); !status) return status.error();
  Result<Valences> valences = read_valences(options.valence);
  if (!valences) return valences.error();
  Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return scheme.error();
  Result<tune::FreedNames> names = tune::FreedNames::make(
      *scheme, options.free, options.everywhere ? Reach::everywhere : Reach::automatic);
  if (!names) return names.error();
  std::vector<Requirement> requirements;
  for (const std::string& text : options.require) {
    Result<Requirement> one = Requirement::parse(text, *scheme);
    if (!one) return one.error();
    requirements.push_back(*std::move(one));
  }
  std::vector<std::optional<SearchRange>> between(options.free.size());
  for (std::size_t j = 0; j < options.between.size(); ++j) {
    Result<SearchRange> range = SearchRange::parse(options.between[j]);
    if (!range) return range.error();
    between[j] = *std::move(range);
  }
  return SystemTask{*std::move(scheme), *std::move(names), std::move(requirements), *valences,
                    std::move(between)};
}

std::string quoted_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + base::printable(word);
  return text;
}

void print(const SystemTask& task, const std::vector<tune::SystemSolutions>& all, const Walk& walk,
           const TuneOptions& options) {
  const std::vector<std::optional<std::string>> forms = report::common_forms(task.names, all);
  if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array(),
                           closed = nlohmann::ordered_json::object();
    for (const tune::SystemSolutions& one : all)
      list.push_back(report::system_json(task.names, one));
    for (std::size_t j = 0; j < forms.size(); ++j)
      closed[task.names.one(j).name()] =
          forms[j] ? nlohmann::ordered_json(*forms[j]) : nlohmann::ordered_json();
    print_json({{"scheme", task.scheme.name},
                {"free", options.free},
                {"require", options.require},
                {"valences", list},
                {"closed_forms", closed},
                {"time_ended", walk.ended_early()}});
    return;
  }
  std::string text = fmt::format("{}: {} such that {}\n", base::printable(task.scheme.name),
                                 quoted_list(options.free), quoted_list(options.require)) +
                     report::system_heading();
  for (const tune::SystemSolutions& one : all) text += report::system_text(task.names, one);
  for (std::size_t j = 0; j < forms.size(); ++j)
    if (forms[j])
      text += fmt::format("    all  {} = {} (recognised, not proved)\n", task.names.one(j).name(),
                          *forms[j]);
  if (walk.ended_early()) text += walk.what_was_reached() + "; " + kMoreTime + "\n";
  print_text(text);
}

}  // namespace

int tune_system(const TuneOptions& options) {
  Result<SystemTask> task = read_system_task(options);
  if (!task) return report(task.error());
  Walk walk(task->valences, options.seconds);
  std::vector<tune::SystemSolutions> all;
  const Status status = walk.each([&](int n) -> Result<bool> {
    Result<tune::SystemSolutions> found =
        tune::solve_system_at(task->names, task->requirements, n, task->searched(), walk.stop());
    if (!found) return found.error();
    if (found->time_ended) return false;
    all.push_back(*std::move(found));
    return true;
  });
  if (!status) return report(status.error());
  if (walk.ended_early() && !options.output.empty())
    return report({walk.what_was_reached() + ", so that no file is written", kMoreTime});
  const auto text_of = [&](const std::string& extends) {
    return report::tuned_system_text(task->names, task->requirements, all, extends);
  };
  if (!options.output.empty())
    if (Status written = write_tuned(options, text_of); !written) return report(written.error());
  print(*task, all, walk, options);
  const bool undecided = std::any_of(all.begin(), all.end(), [](const tune::SystemSolutions& at) {
    return std::any_of(
        at.solutions.begin(), at.solutions.end(),
        [](const tune::SystemSolution& one) { return one.holds == Truth::undecided; });
  });
  return undecided ? kUndecided : kDone;
}

}  // namespace limn::app
