#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/near_word.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "papers/papers.h"

namespace limn::app {
namespace {

struct PapersOptions {
  std::vector<std::string> papers;
  std::string output;
  bool json = false;
};

std::string paper_names() {
  std::string names;
  for (const Paper& paper : papers()) names += (names.empty() ? "" : ", ") + paper.name;
  return names;
}

Result<std::vector<const Paper*>> chosen(const PapersOptions& options) {
  std::vector<const Paper*> list;
  std::vector<std::string> known;
  for (const Paper& paper : papers()) known.push_back(paper.name);
  for (const std::string& name : options.papers) {
    const auto found = std::find_if(papers().begin(), papers().end(),
                                    [&](const Paper& paper) { return paper.name == name; });
    if (found == papers().end())
      return Error{fmt::format("there is no paper '{}'", name),
                   base::did_you_mean(name, known, "the papers are " + paper_names())};
    list.push_back(&*found);
  }
  if (list.empty())
    for (const Paper& paper : papers()) list.push_back(&paper);
  return list;
}

int make_papers(const PapersOptions& options) {
  const Result<std::vector<const Paper*>> list = chosen(options);
  if (!list) return report(list.error());
  const bool alone = options.papers.size() == 1;  // it has the folder to itself
  if (options.output == base::kStandardStream)
    return report({"the pages are a folder, which cannot go to standard output"});
  if (Status status = base::make_folder(options.output); !status) return report(status.error());
  nlohmann::ordered_json made = nlohmann::ordered_json::array();
  base::ProgressLine line;
  for (const Paper* paper : *list) {
    set_step("making " + paper->name + " anew");
    const std::string directory = alone ? options.output : options.output + "/" + paper->name;
    const Status status = paper->write(
        directory, [&](const std::string& what) { line.show(paper->name + ": " + what); });
    if (!status) return report(status.error());
    made.push_back({{"paper", paper->name}, {"index", directory + "/index.html"}});
  }
  if (!alone)
    if (Status status = write_paper_list(options.output, *list); !status)
      return report(status.error());
  const std::string index = options.output + "/index.html";
  if (options.json)
    print_json({{"index", index}, {"papers", made}});
  else
    print_text(base::printable(index) + "\n");
  return kDone;
}

}  // namespace

void declare_papers(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "papers",
                  "figures, tables and main claims of the papers that limn implements, made anew");
  const auto options = std::make_shared<PapersOptions>();
  command->add_option("PAPER", options->papers, "which; without it all of them: " + paper_names());
  command->add_option("-o,--output", options->output, "write the pages to this folder")
      ->type_name("FOLDER")
      ->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer("Example: limn papers -o papers\n         limn papers barthe -o barthe");
  command->callback([&action, options] { action = [options] { return make_papers(*options); }; });
}

}  // namespace limn::app
