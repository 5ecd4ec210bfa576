#pragma once
/// Where a figure goes, as commands that draw one take it.

#include <CLI/CLI.hpp>
#include <string>

#include "limn/base/error.h"
#include "limn/figure/figure.h"

namespace limn::app {

struct FigureOutput {
  std::string path;
  std::string format;  ///< pdf, svg or png; empty: by the extension, or PDF on standard output

  /// -o, with what is drawn, and --format.
  CLI::Option* declare(CLI::App& command, const std::string& drawn);

  /// Whether the figure itself is what standard output gets, so that a report must go elsewhere.
  [[nodiscard]] bool is_printed() const;

  /// Whether its format is known; `check_outputs` says whether it can be written.
  [[nodiscard]] Status check(bool json) const;

  /// Precondition: `check` has passed.
  [[nodiscard]] Status write(const figure::Figure& figure) const;

  /// Prints on standard output, or on standard error where the figure has that.
  void print_report(const std::string& text) const;

 private:
  [[nodiscard]] Result<figure::FigureFormat> chosen() const;
};

}  // namespace limn::app
