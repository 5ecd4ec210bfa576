/// Parameters solved for.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/report/system_report.h"
#include "limn/report/tune_report.h"
#include "limn/report/tuned_scheme.h"
#include "module.h"

namespace limn::python {
namespace {

using Json = nlohmann::ordered_json;

/// What is solved: a freed name and what is required of it.
struct Task {
  FreedScheme freed;
  Requirement requirement;
  std::optional<SearchRange> between;

  [[nodiscard]] const SearchRange* searched() const { return between ? &*between : nullptr; }
};

Task task_of(const Scheme& scheme, const std::string& name, const std::string& require,
             const std::string& between, bool everywhere) {
  Task task{
      value_of(FreedScheme::make(scheme, name, everywhere ? Reach::everywhere : Reach::automatic),
               Fault::scheme),
      value_of(Requirement::parse(require, scheme), Fault::scheme),
      {}};
  if (!between.empty()) task.between = value_of(SearchRange::parse(between), Fault::scheme);
  return task;
}

/// find(n) at each valence, until the time ends.
template <class Found, class Find>
std::vector<Found> at_each(const std::vector<int>& valences, double seconds, Find find) {
  const TimeBudget budget(seconds);
  const Stop stop = stop_of(budget);
  const auto all = without_gil([&]() -> Result<std::vector<Found>> {
    std::vector<Found> list;
    for (const int n : valences) {
      if (!list.empty() && stop()) break;
      Result<Found> one = find(n, stop);
      if (!one) return one.error();
      if (one->time_ended) break;
      list.push_back(*std::move(one));
    }
    return list;
  });
  if (!all) raise(all.error(), Fault::scheme);
  return *all;
}

/// As `limn tune --json`; with the scheme file of the solutions under "text", or why there is none
/// under "no_text".
py::object solve(const Scheme& scheme, const std::string& name, const std::string& require,
                 const std::vector<int>& valences, const std::string& between, bool everywhere,
                 double seconds, const std::string& extends) {
  Task task = task_of(scheme, name, require, between, everywhere);
  const bool range = task.requirement.has_range();
  Json list = Json::array();
  Json result{{"scheme", scheme.name}, {"free", name}, {"require", task.requirement.text}};
  if (range) {
    const auto ranges = at_each<ValenceRange>(valences, seconds, [&](int n, const Stop& stop) {
      return range_at(task.freed, task.requirement, n, task.searched(), stop);
    });
    for (const ValenceRange& one : ranges) list.push_back(report::tune_json(one));
    result["common"] = report::intervals_json(common_range(ranges));
  } else {
    const auto solutions =
        at_each<ValenceSolutions>(valences, seconds, [&](int n, const Stop& stop) {
          return solve_at(task.freed, task.requirement, n, task.searched(), stop);
        });
    for (const ValenceSolutions& one : solutions) list.push_back(report::tune_json(one));
    if (!extends.empty()) {
      const Result<std::string> text =
          report::tuned_scheme_text(task.freed, task.requirement, solutions, extends);
      result[text ? "text" : "no_text"] = text ? *text : text.error().text();
    }
  }
  result["time_ended"] = list.size() != valences.size();
  result["valences"] = std::move(list);
  return to_python(result);
}

/// As `limn tune --json` of several names or requirements; the rest as of `solve`.
py::object solve_system(const Scheme& scheme, const std::vector<std::string>& free,
                        const std::vector<std::string>& require, const std::vector<int>& valences,
                        const std::vector<std::string>& between, bool everywhere, double seconds,
                        const std::string& extends) {
  tune::FreedNames names = value_of(
      tune::FreedNames::make(scheme, free, everywhere ? Reach::everywhere : Reach::automatic),
      Fault::scheme);
  std::vector<Requirement> requirements;
  for (const std::string& text : require)
    requirements.push_back(value_of(Requirement::parse(text, scheme), Fault::scheme));
  std::vector<SearchRange> ranges;
  for (const std::string& text : between)
    ranges.push_back(value_of(SearchRange::parse(text), Fault::scheme));
  if (!ranges.empty() && ranges.size() != free.size())
    raise({"there are other numbers of ranges and of names"}, Fault::scheme);
  std::vector<const SearchRange*> searched(free.size(), nullptr);
  for (std::size_t j = 0; j < ranges.size(); ++j) searched[j] = &ranges[j];
  const auto solutions =
      at_each<tune::SystemSolutions>(valences, seconds, [&](int n, const Stop& stop) {
        return tune::solve_system_at(names, requirements, n, searched, stop);
      });
  Json list = Json::array(), closed = Json::object();
  for (const tune::SystemSolutions& one : solutions)
    list.push_back(report::system_json(names, one));
  const std::vector<std::optional<std::string>> forms = report::common_forms(names, solutions);
  for (std::size_t j = 0; j < forms.size(); ++j)
    closed[free[j]] = forms[j] ? Json(*forms[j]) : Json();
  Json result{{"scheme", scheme.name}, {"free", free}, {"require", require}};
  if (!extends.empty()) {
    const Result<std::string> text =
        report::tuned_system_text(names, requirements, solutions, extends);
    result[text ? "text" : "no_text"] = text ? *text : text.error().text();
  }
  result["time_ended"] = list.size() != valences.size();
  result["valences"] = std::move(list);
  result["closed_forms"] = std::move(closed);
  return to_python(result);
}

}  // namespace

void bind_tuning(py::module_& module) {
  module.def("tune", &solve, py::arg("scheme"), py::arg("free"), py::arg("require"),
             py::arg("valences"), py::arg("between"), py::arg("everywhere"), py::arg("seconds"),
             py::arg("extends"));
  module.def("tune_system", &solve_system, py::arg("scheme"), py::arg("free"), py::arg("require"),
             py::arg("valences"), py::arg("between"), py::arg("everywhere"), py::arg("seconds"),
             py::arg("extends"));
  module.def("freeable_names", &freeable_names, py::arg("scheme"));
}

}  // namespace limn::python
