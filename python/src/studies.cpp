/// Studies: read, their points evaluated, their searches kept in a folder.

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/report/study_files.h"
#include "limn/search/run_study.h"
#include "module.h"

namespace limn::python {
namespace {

using Words = std::vector<std::string>;
using StudyPointer = std::shared_ptr<search::Study>;

/// feasible, reason, violation, objectives, demands (yes, no, undecided), seconds: what travels
/// between machines.
using OutcomeTuple = std::tuple<bool, py::bytes, double, std::vector<std::optional<double>>,
                                std::vector<std::optional<std::string>>, double>;

/// Of the file, or of a text in its place.
StudyPointer read(const std::string& path, const std::optional<std::string>& text) {
  return std::make_shared<search::Study>(value_of(without_gil([&] {
                                                    return text ? search::parse_study(*text, path)
                                                                : search::read_study(path);
                                                  }),
                                                  Fault::other));
}

search::Point point_of(const search::Study& study, const Words& fractions) {
  if (fractions.size() != study.coordinates.size())
    raise({"a point has a number for each coordinate"}, Fault::other);
  search::Point point;
  for (const std::string& fraction : fractions) point.emplace_back(fraction);
  return point;
}

Words words_of(const search::Point& point) {
  Words words;
  for (const Rational& value : point) words.push_back(to_string(value));
  return words;
}

OutcomeTuple evaluate(const search::Study& study, const Words& fractions) {
  const search::Point point = point_of(study, fractions);
  const search::Outcome found = without_gil([&] { return search::evaluate_point(study, point); });
  std::vector<std::optional<std::string>> demands;
  for (const std::optional<Truth>& truth : found.demands)
    demands.push_back(truth ? std::optional<std::string>(to_string(*truth)) : std::nullopt);
  return {found.feasible, py::bytes(found.reason), found.violation, found.objectives, demands,
          found.seconds};
}

search::Outcome outcome_of(const search::Study& study, const OutcomeTuple& tuple) {
  search::Outcome outcome;
  std::vector<std::optional<std::string>> demands;
  py::bytes reason;
  std::tie(outcome.feasible, reason, outcome.violation, outcome.objectives, demands,
           outcome.seconds) = tuple;
  outcome.reason = reason;
  for (const std::optional<std::string>& word : demands) {
    std::optional<Truth> truth;
    for (const Truth one : {Truth::no, Truth::yes, Truth::undecided})
      if (word && *word == to_string(one)) truth = one;
    outcome.demands.push_back(truth);
  }
  if (outcome.objectives.size() != study.objectives.size() ||
      outcome.demands.size() != study.demands.size())
    raise({"an outcome of another study came back",
           "see that all workers have the same version of limn"},
          Fault::other);
  return outcome;
}

/// A study at work in its folder.
class StudySearch {
 public:
  StudySearch(StudyPointer study, const std::string& folder, bool restart)
      : study_(std::move(study)),
        folder_(folder),
        store_(value_of(
            without_gil([&] { return report::open_study_folder(*study_, folder_, restart); }),
            Fault::other)),
        search_(value_of(search::KeptSearch::begin(*study_, *store_), Fault::other)) {}

  /// The missing points of the next generation by their places; nothing at the end.
  std::optional<std::vector<std::pair<std::size_t, Words>>> next() {
    if (!without_gil([&] { return search().next(); })) return std::nullopt;
    std::vector<std::pair<std::size_t, Words>> points;
    for (const std::size_t place : search_->missing())
      points.emplace_back(place, words_of(search_->point(place)));
    return points;
  }

  void keep(std::size_t place, const OutcomeTuple& outcome) {
    const std::vector<std::size_t> missing = search().missing();
    if (std::find(missing.begin(), missing.end(), place) == missing.end())
      raise({"that place has its outcome, or is none of the generation"}, Fault::other);
    check(search_->keep(place, outcome_of(*study_, outcome)), Fault::other);
  }

  void tell() {
    if (!search().missing().empty()) raise({"the generation is not done"}, Fault::other);
    without_gil([&] { search_->tell(); });
  }

  py::dict progress() {
    const search::StudyProgress at = search().progress();
    py::dict dict;
    dict["generation"] = at.generation;
    dict["done"] = at.done;
    dict["most"] = at.most;
    dict["feasible"] = at.feasible;
    dict["seconds_left"] = at.seconds_left;
    return dict;
  }

  /// The files, and what `limn study` prints: JSON and text. The store is closed.
  std::pair<py::object, py::str> conclude(bool all_points, int schemes) {
    report::StudyFiles files{.folder = folder_, .all_points = all_points, .schemes = schemes};
    files.progress = on_progress;
    nlohmann::ordered_json json;
    std::string text;
    check(without_gil([&] {
            const search::StudyRun run = std::move(search()).end();
            search_.reset();
            store_.reset();
            return report::conclude_study(*study_, run, files, text, json);
          }),
          Fault::other);
    return {to_python(json), to_str(text)};
  }

 private:
  search::KeptSearch& search() {
    if (!search_) raise({"the study is concluded"}, Fault::other);
    return *search_;
  }

  StudyPointer study_;
  std::string folder_;
  std::optional<search::Store> store_;
  std::unique_ptr<search::KeptSearch> search_;
};

py::dict forecast(const search::Study& study, int sample) {
  const search::StudyForecast found =
      value_of(without_gil([&] { return search::forecast_study(study, sample); }), Fault::other);
  py::dict dict;
  dict["study"] = to_str(study.title.empty() ? study.file : study.title);
  dict["points"] = found.points;
  dict["measured"] = found.measured;
  dict["seconds_each"] = found.seconds_each;
  dict["threads"] = found.threads;
  dict["seconds"] = found.seconds;
  return dict;
}

}  // namespace

void bind_studies(py::module_& module) {
  py::class_<search::Study, StudyPointer>(module, "StudyData")
      .def(py::init(&read), py::arg("path"), py::arg("text") = py::none())
      .def_property_readonly("text", [](const search::Study& s) { return py::bytes(s.text); })
      .def_property_readonly("file", [](const search::Study& s) { return py::bytes(s.file); })
      .def_property_readonly("title", [](const search::Study& s) { return to_str(s.title); })
      .def_property_readonly("identity",
                             [](const search::Study& s) { return py::bytes(s.identity()); })
      .def_property_readonly("files",
                             [](const search::Study& s) {
                               py::list list;
                               for (const std::string& file : s.files())
                                 list.append(py::bytes(file));
                               return list;
                             })
      .def_property_readonly("coordinates",
                             [](const search::Study& s) {
                               Words labels;
                               for (const search::Coordinate& one : s.coordinates)
                                 labels.push_back(one.label());
                               return labels;
                             })
      .def("evaluate", &evaluate, py::arg("point"))
      .def("forecast", &forecast, py::arg("sample"));
  py::class_<StudySearch>(module, "StudySearch")
      .def(py::init<StudyPointer, const std::string&, bool>(), py::arg("study"), py::arg("folder"),
           py::arg("restart"))
      .def("next", &StudySearch::next)
      .def("keep", &StudySearch::keep, py::arg("place"), py::arg("outcome"))
      .def("tell", &StudySearch::tell)
      .def("progress", &StudySearch::progress)
      .def("conclude", &StudySearch::conclude, py::arg("all_points"), py::arg("schemes"));
  module.def("study_quantities", [] { return to_python(report::quantities_json()); });
}

}  // namespace limn::python
