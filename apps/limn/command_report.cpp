#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/report/page/page_html.h"
#include "limn/report/page/page_record.h"
#include "options/scheme_argument.h"
#include "options/time_option.h"
#include "options/valences.h"
#include "output/page_file.h"

namespace limn::app {
namespace {

constexpr double kSecondsOfAPart = 60;
constexpr int kLeastValence = 3;
constexpr int kMostValence = 200;

struct ReportOptions {
  SchemeOptions scheme;
  std::string output;
  std::string valence = "3..12";
  double seconds = kSecondsOfAPart;
  bool json = false;
};

Status check_arguments(const ReportOptions& options, const Valences& range) {
  if (options.output.empty() && !options.json)
    return Error{"-o is missing: where the page is written", "as -o scheme.html, or give --json"};
  if (options.json && base::is_standard_output(options.output))
    return Error{"standard output cannot have both the page and --json",
                 "write the page to a file"};
  if (range.last > kMostValence)
    return Error{fmt::format("--valence: {} is beyond {}", range.last, kMostValence)};
  return check_outputs({options.output});
}

Result<std::string> html_of(const nlohmann::ordered_json& record) {
  if (page_file().empty()) return report::static_page(record);
  return report::page_with_record(page_file(), record);
}

int make_report(const ReportOptions& options) {
  const Result<Valences> range = read_valences(options.valence, kLeastValence);
  if (!range) return report(range.error());
  if (Status status = check_arguments(options, *range); !status) return report(status.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  base::ProgressLine line;
  report::PageRecordOptions wanted;
  wanted.first_valence = range->first;
  wanted.last_valence = range->last;
  wanted.seconds = time_limit(options.seconds);
  wanted.given = given_parameters(options.scheme.name, options.scheme.parameters);
  wanted.progress = [&line](const std::string& what) { line.show(what); };
  std::string label = scheme_label(options.scheme.name, *scheme);
  for (const std::string& parameter : options.scheme.parameters) label += " " + parameter;
  nlohmann::ordered_json record{{"limn", LIMN_VERSION}};
  record.update(report::page_record_json(label, *scheme, wanted));
  if (!options.output.empty()) {
    const Result<std::string> html = html_of(record);
    if (!html) return report(html.error());
    if (page_file().empty())
      report_warnings(
          {{"this limn was built without its web page: the report is to be read, nothing "
            "in it can be moved",
            "build limn with the page (docs/page.md)"}});
    if (Status status = base::write_file(options.output, *html); !status)
      return report(status.error());
    record["output"] = options.output;
    record["interactive"] = !page_file().empty();
  }
  if (options.json)
    print_json(record);
  else if (!base::is_standard_output(options.output))
    print_text(
        fmt::format("{}: a page of {}\n", base::printable(options.output), base::printable(label)));
  return kDone;
}

}  // namespace

void declare_report(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "report", "a web page of a scheme, to be used and read without limn");
  const auto options = std::make_shared<ReportOptions>();
  command->add_option("SCHEME", options->scheme.name, kSchemeArgumentHelp)->required();
  options->scheme.declare_parameters(*command);
  command
      ->add_option("-o,--output", options->output,
                   "the page, one .html file that needs nothing else")
      ->type_name("FILE");
  command
      ->add_option("--valence", options->valence,
                   "the valences of eigenvalues and proofs, a valence or a range")
      ->type_name("N or A..B")
      ->capture_default_str();
  declare_time(*command, options->seconds,
               "how long to look for each of regularity and proofs; what was reached is given");
  command->add_flag("--json", options->json, "print the record as one JSON object");
  command->footer(
      "Example: limn report loop -o loop.html\n"
      "         limn report laplacian-butterfly -p b=3/16 -o b.html\n"
      "         limn report catmull-clark --json");
  command->callback([&action, options] { action = [options] { return make_report(*options); }; });
}

}  // namespace limn::app
