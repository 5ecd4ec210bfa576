#include "output/figure_output.h"

#include <cstdio>

#include <fmt/core.h>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"

namespace limn::app {

CLI::Option* FigureOutput::declare(CLI::App& command, const std::string& drawn) {
  CLI::Option* const output =
      command
          .add_option("-o,--output", path,
                      fmt::format("{} into FILE ({}; - is standard output)", drawn, kFigureFiles))
          ->type_name("FILE");
  command
      .add_option("--format", format,
                  "pdf, svg or png, whatever the output is called (default: its extension, or pdf "
                  "on standard output)")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pdf", "svg", "png"}))
      ->needs(output);
  return output;
}

bool FigureOutput::is_printed() const { return base::is_standard_output(path); }

Result<figure::FigureFormat> FigureOutput::chosen() const {
  if (!format.empty()) return figure::figure_format("figure." + format);
  Result<figure::FigureFormat> by_name = figure::figure_format(path);
  if (!by_name && is_printed()) return figure::FigureFormat::pdf;
  return by_name;
}

Status FigureOutput::check(bool json) const {
  if (is_printed() && json)
    return Error{"the figure and the JSON object cannot both go to standard output",
                 "leave out --json, or name a file after -o"};
  const Result<figure::FigureFormat> known = chosen();
  return known ? Status(Done{}) : known.error();
}

Status FigureOutput::write(const figure::Figure& figure) const {
  return figure.write(path, *chosen());
}

void FigureOutput::print_report(const std::string& text) const {
  if (!is_printed())
    print_text(text);
  else if (!is_quiet())
    fmt::print(stderr, "{}", base::printable_lines(text));
}

}  // namespace limn::app
