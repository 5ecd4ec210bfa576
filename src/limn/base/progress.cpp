#include "limn/base/progress.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>

#include "limn/base/printable.h"

namespace limn::base {
namespace {

std::atomic<bool> none{false};

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : start_(std::chrono::steady_clock::now()), enabled_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(const std::string& text) {
  constexpr std::chrono::seconds kQuiet{1};
  if (std::chrono::steady_clock::now() - start_ >= kQuiet) show_now(text);
}

void ProgressLine::show_none() { none = true; }

void ProgressLine::show_now(const std::string& text) {
  if (!enabled_ || none) return;
  std::fprintf(stderr, "\r\033[K%s", printable(text).c_str());
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace limn::base
