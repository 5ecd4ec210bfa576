/// The papers made anew.

#include "papers/papers.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "module.h"

namespace limn::python {
namespace {

const Paper& paper_named(const std::string& name) {
  std::string known;
  for (const Paper& paper : papers()) {
    if (paper.name == name) return paper;
    known += (known.empty() ? "" : ", ") + paper.name;
  }
  raise({"there is no paper '" + name + "'", "the papers are " + known}, Fault::other);
}

/// Makes a paper's folder, with index.html.
void write_paper(const std::string& name, const std::string& folder) {
  const Paper& paper = paper_named(name);
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) raise({"the folder cannot be made: " + failed.message(), {}, folder}, Fault::other);
  check(without_gil([&] { return paper.write(folder, on_progress); }), Fault::other);
}

/// folder/index.html, which leads to each paper's own page in folder/NAME.
void write_list(const std::string& folder, const std::vector<std::string>& names) {
  std::vector<const Paper*> list;
  for (const std::string& name : names) list.push_back(&paper_named(name));
  check(write_paper_list(folder, list), Fault::other);
}

}  // namespace

void bind_papers(py::module_& module) {
  module.def("paper_names", [] {
    std::vector<std::string> names;
    for (const Paper& paper : papers()) names.push_back(paper.name);
    return names;
  });
  module.def("write_paper", &write_paper, py::arg("name"), py::arg("folder"));
  module.def("write_paper_list", &write_list, py::arg("folder"), py::arg("names"));
}

}  // namespace limn::python
