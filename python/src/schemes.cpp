/// Schemes: read, described, made anew with other parameters.

#include <pybind11/stl.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/certify/certify.h"
#include "limn/mesh/lattice.h"
#include "limn/report/scheme_report.h"
#include "limn/report/stencil_report.h"
#include "limn/scheme/file/scheme_files.h"
#include "limn/scheme/scheme.h"
#include "limn/tune/prescribe.h"
#include "module.h"

namespace limn::python {
namespace {

using Assignments = std::vector<std::string>;
using SchemePointer = std::shared_ptr<Scheme>;

SchemePointer with_parameters(Result<Scheme> scheme, const Assignments& assignments) {
  if (scheme && !assignments.empty())
    if (Status set = set_parameters(*scheme, assignments); !set)
      raise(in_file(set.error(), scheme->file), Fault::scheme);
  return std::make_shared<Scheme>(value_of(std::move(scheme), Fault::scheme));
}

/// A shipped name or a path, or where it has a line feed the text itself.
SchemePointer read(const std::string& source, const Assignments& assignments) {
  return with_parameters(without_gil([&] {
                           return source.find('\n') == std::string::npos
                                      ? find_scheme(source)
                                      : parse_scheme(source, "text");
                         }),
                         assignments);
}

py::tuple state_of(const Scheme& scheme) {
  py::list texts;
  for (const SourceText& text : scheme.texts)
    texts.append(py::make_tuple(py::bytes(text.name), py::bytes(text.text)));
  return py::make_tuple(texts, certify::set_parameters_of(scheme), py::bytes(scheme.file));
}

SchemePointer of_state(const py::tuple& state) {
  std::vector<SourceText> texts;
  for (const py::handle item : state[0]) {
    const auto pair = item.cast<std::pair<std::string, std::string>>();
    texts.push_back({pair.first, pair.second});
  }
  const auto assignments = state[1].cast<Assignments>();
  SchemePointer scheme =
      with_parameters(without_gil([&] { return parse_texts(texts); }), assignments);
  scheme->file = state[2].cast<std::string>();
  return scheme;
}

py::dict parameters_of(const Scheme& scheme) {
  py::dict parameters;
  for (const Parameter& parameter : scheme.parameters)
    parameters[to_str(parameter.name)] = to_str(parameter.value.expression.text());
  return parameters;
}

py::object show(const Scheme& scheme, bool stencils) {
  const nlohmann::ordered_json json = without_gil([&] {
    nlohmann::ordered_json described = report::describe_json(scheme);
    if (stencils)
      if (const auto pictures = study::rule_pictures(scheme))
        described["stencils"] = report::stencils_json(*pictures);
    return described;
  });
  return to_python(json);
}

std::string prescribe(const Scheme& scheme, const std::string& base, int valence,
                      const std::vector<std::string>& eigenvalues) {
  if (eigenvalues.empty())
    raise({"no eigenvalues", "give the cup's, then those of frequency 1, 2, …"}, Fault::scheme);
  const tune::Prescription wanted{
      valence, eigenvalues.front(), {eigenvalues.begin() + 1, eigenvalues.end()}};
  tune::Prescribed made = value_of(without_gil([&] {
                                     return tune::prescribed_scheme(
                                         scheme, base, scheme.name + "-prescribed.toml", wanted);
                                   }),
                                   Fault::scheme);
  warn(made.unmet);
  return std::move(made.text);
}

}  // namespace

void bind_schemes(py::module_& module) {
  py::class_<Scheme, SchemePointer>(module, "SchemeData")
      .def(py::init(&read), py::arg("source"), py::arg("assignments"))
      .def(py::pickle(&state_of, &of_state))
      .def_property_readonly("name", [](const Scheme& s) { return to_str(s.name); })
      .def_property_readonly("title", [](const Scheme& s) { return to_str(s.title); })
      .def_property_readonly("source", [](const Scheme& s) { return to_str(s.source); })
      .def_property_readonly("notes", [](const Scheme& s) { return to_str(s.notes); })
      .def_property_readonly("file", [](const Scheme& s) { return to_str(s.file); })
      .def_property_readonly("split", [](const Scheme& s) { return to_str(s.split->name); })
      .def_property_readonly("is_dual", [](const Scheme& s) { return s.split->is_dual(); })
      .def_property_readonly(
          "corners", [](const Scheme& s) { return s.split->lattice == Lattice::triangle ? 3 : 4; })
      .def_property_readonly("text", [](const Scheme& s) { return to_str(s.texts.front().text); })
      .def_property_readonly("parameters", &parameters_of)
      .def_property_readonly("set_parameters", &certify::set_parameters_of)
      .def(
          "with_parameters",
          [](const Scheme& s, const Assignments& assignments) {
            return with_parameters(s, assignments);
          },
          py::arg("assignments"))
      .def("show", &show, py::arg("stencils"))
      .def("summary", [](const Scheme& s) { return to_python(report::summary_json(s)); })
      .def("describe",
           [](const Scheme& s) { return to_str(without_gil([&] { return report::describe(s); })); })
      .def("latex",
           [](const Scheme& s) {
             return to_str(
                 value_of(without_gil([&] { return report::describe_latex(s); }), Fault::scheme));
           })
      .def("prescribe", &prescribe, py::arg("base"), py::arg("valence"), py::arg("eigenvalues"));
  module.def("shipped_schemes", &shipped_schemes);
  module.def("error_text", [](const std::string& message, const std::string& hint,
                              const std::string& file, int line, int column) {
    return to_str(Error{message, hint, file, line, column}.text());
  });
}

}  // namespace limn::python
