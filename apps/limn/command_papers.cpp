#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/progress.h"
#include "limn/report/papers/augsdorfer.h"
#include "limn/report/papers/barthe.h"

namespace limn::app {
namespace {

struct Paper {
  const char* name;
  const char* title;
  Status (*write)(const std::string& directory, const PaperProgress& progress);
};

// One line for each paper.
constexpr Paper kPapers[] = {
    {"augsdorfer", "Artifact analysis on triangular box-spline and subdivision meshes",
     write_augsdorfer},
    {"barthe",
     "Simple computation of the eigencomponents of a subdivision matrix in the Fourier domain",
     write_barthe},
};

struct PapersOptions {
  std::vector<std::string> papers;
  std::string output;
  bool json = false;
};

Result<std::vector<const Paper*>> chosen(const PapersOptions& options) {
  std::vector<const Paper*> papers;
  std::string names;
  for (const Paper& paper : kPapers) names += (names.empty() ? "" : ", ") + std::string(paper.name);
  for (const std::string& name : options.papers) {
    const Paper* found = nullptr;
    for (const Paper& paper : kPapers)
      if (paper.name == name) found = &paper;
    if (found == nullptr)
      return Error{
          fmt::format("there is no paper '{}'", name), "the papers are " + names, {}, 0, 0};
    papers.push_back(found);
  }
  if (papers.empty())
    for (const Paper& paper : kPapers) papers.push_back(&paper);
  return papers;
}

int make_papers(const PapersOptions& options) {
  const Result<std::vector<const Paper*>> papers = chosen(options);
  if (!papers) return report(papers.error());
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  ProgressLine line;
  for (const Paper* paper : *papers) {
    // one paper asked for by name has the folder to itself
    const std::string directory =
        options.papers.size() == 1 ? options.output : options.output + "/" + paper->name;
    const Status status = paper->write(
        directory, [&](const std::string& what) { line.show(paper->name + (": " + what)); });
    if (!status) return report(status.error());
    list.push_back({{"paper", paper->name}, {"index", directory + "/index.html"}});
  }
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"papers", list}}.dump());
  else
    for (const auto& entry : list)
      fmt::print("{}: {}\n", entry["paper"].get<std::string>(), entry["index"].get<std::string>());
  return kDone;
}

}  // namespace

void declare_papers(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand(
      "papers", "the figures and tables of the papers that limn implements, made anew");
  const auto options = std::make_shared<PapersOptions>();
  command->add_option("PAPER", options->papers,
                      "which; without it all of them: augsdorfer, barthe");
  command->add_option("-o,--output", options->output, "the folder they go to")->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer("Example: limn papers -o papers\n         limn papers barthe -o barthe");
  command->callback([&action, options] { action = [options] { return make_papers(*options); }; });
}

}  // namespace limn::app
