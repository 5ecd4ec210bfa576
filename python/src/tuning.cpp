/// Parameters solved for.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
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
    for (const ValenceRange& one : ranges) list.push_back(tune_json(one));
    result["common"] = intervals_json(common_range(ranges));
  } else {
    const auto solutions =
        at_each<ValenceSolutions>(valences, seconds, [&](int n, const Stop& stop) {
          return solve_at(task.freed, task.requirement, n, task.searched(), stop);
        });
    for (const ValenceSolutions& one : solutions) list.push_back(tune_json(one));
    if (!extends.empty()) {
      const Result<std::string> text =
          tuned_scheme_text(task.freed, task.requirement, solutions, extends);
      result[text ? "text" : "no_text"] = text ? *text : text.error().text();
    }
  }
  result["time_ended"] = list.size() != valences.size();
  result["valences"] = std::move(list);
  return to_python(result);
}

}  // namespace

void bind_tuning(py::module_& module) {
  module.def("tune", &solve, py::arg("scheme"), py::arg("free"), py::arg("require"),
             py::arg("valences"), py::arg("between"), py::arg("everywhere"), py::arg("seconds"),
             py::arg("extends"));
  module.def("freeable_names", &freeable_names, py::arg("scheme"));
}

}  // namespace limn::python
