#pragma once
/// What the two ways of `limn tune` share: one name and one requirement, or several.

#include <string>
#include <vector>

#include <fmt/core.h>

#include "command.h"
#include "limn/base/budget.h"
#include "limn/base/files/file.h"
#include "limn/base/progress.h"
#include "options/time_option.h"
#include "options/valences.h"

namespace limn::app {

struct TuneOptions {
  SchemeOptions scheme;
  std::vector<std::string> free;
  std::vector<std::string> require;
  std::string valence = "3..12";
  std::vector<std::string> between;
  std::string output;
  bool range = false;
  bool everywhere = false;
  bool json = false;
  double seconds = kDefaultSeconds;
};

/// Several names, or several requirements.
[[nodiscard]] int tune_system(const TuneOptions& options);

/// Writes the solutions as a scheme file, if it reads back. `text_of(extends)` gives the text as a
/// Result, of a file that extends the scheme by that name.
template <class TextOf>
[[nodiscard]] Status write_tuned(const TuneOptions& options, TextOf text_of) {
  const Result<std::string> extends = extends_name(options.scheme.name, options.output);
  if (!extends) return extends.error();
  const Result<std::string> text = text_of(*extends);
  if (!text) return text.error();
  if (const Result<Scheme> back = parse_scheme(*text, options.output); !back)
    return unwritten(back.error(), options.output);
  return base::write_file(options.output, *text);
}

/// The valences one after the other, with progress, until the time ends.
class Walk {
 public:
  Walk(Valences valences, double seconds)
      : valences_(valences), budget_(time_limit(seconds)), stop_(budget_.stop()) {}

  [[nodiscard]] const Stop& stop() const { return stop_; }
  /// visit(n) says whether it has done valence n.
  template <class Visit>
  Status each(Visit visit) {
    for (int n = valences_.first; n <= valences_.last; ++n) {
      line_.show(fmt::format("valence {} of {}..{}", n, valences_.first, valences_.last));
      if (n > valences_.first && budget_.ended()) break;
      const Result<bool> done = visit(n);
      if (!done) return done.error();
      if (!*done) break;
      last_ = n;
    }
    return Done{};
  }
  [[nodiscard]] bool ended_early() const { return last_ != valences_.last; }
  [[nodiscard]] std::string what_was_reached() const {
    return last_ == 0 ? fmt::format("the time ended before valence {} was done", valences_.first)
                      : fmt::format("the time ended: {}..{} of the valences {}..{} are done",
                                    valences_.first, last_, valences_.first, valences_.last);
  }

 private:
  Valences valences_;
  TimeBudget budget_;
  Stop stop_;
  base::ProgressLine line_;
  int last_ = 0;  // valence that was done
};

inline constexpr const char* kMoreTime = "give more --time, or fewer valences";

}  // namespace limn::app
