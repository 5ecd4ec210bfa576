#include "tables.h"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>

#include <fmt/chrono.h>
#include <fmt/core.h>

namespace limn::peers {
namespace {

/// Three significant digits or so; "–" where nothing was measured.
std::string number(double value) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{:.{}f}", value, value < 1 ? 2 : value < 20 ? 1 : 0);
}

std::string ratio(double value, double to) {
  return std::isfinite(value) && std::isfinite(to) ? number(value / to) : "–";
}

bool ran(const Entry& entry) { return std::isfinite(entry.warm.run); }

/// The least of `value(entry)` over the entries that `counts` says; infinite where there is none.
template <class Counts, class Value>
double least(const Outcome& outcome, Counts counts, Value value) {
  double best = Measurement::kNever;
  for (const Entry& entry : outcome.entries)
    if (counts(entry)) best = std::min(best, value(entry));
  return best;
}

double warm(const Entry& entry) { return entry.warm.run; }
double cold(const Entry& entry) { return entry.cold.run; }
/// On one thread: what ratios are to.
bool is_peer(const Entry& entry) { return !entry.ours && entry.threads == 1; }

double vertices(const Outcome& outcome) {
  double most = 0;
  for (const Entry& entry : outcome.entries) most = std::max(most, entry.warm.size.vertices);
  return most;
}

std::string what(const Outcome& outcome) {
  return fmt::format("{} {}, {:.2f} M", outcome.scheme, outcome.steps, vertices(outcome) / 1e6);
}

/// "floor: 36 bytes at 24 GB/s"
std::string floor_name(const Outcome& outcome) {
  const double bytes = outcome.floor_bytes / vertices(outcome);
  return fmt::format("floor: {:.0f} bytes at {:.0f} GB/s", bytes, bytes / outcome.floor.run);
}

/// The quickest entry that `counts` says, or nullptr.
template <class Counts>
const Entry* quickest(const Outcome& outcome, Counts counts) {
  const Entry* best = nullptr;
  for (const Entry& entry : outcome.entries)
    if (counts(entry) && ran(entry) && (best == nullptr || warm(entry) < warm(*best)))
      best = &entry;
  return best;
}

void print_summary(const Outcome& outcome) {
  const auto ours = [&](int threads) {
    return quickest(outcome, [=](const Entry& e) { return e.ours && e.threads == threads; });
  };
  const Entry* one = ours(1);
  const Entry* two = ours(2);
  const Entry* peer = quickest(outcome, is_peer);
  const double time = one == nullptr ? Measurement::kNever : warm(*one);
  const double best = peer == nullptr ? Measurement::kNever : warm(*peer);
  fmt::print("| {} | {} · {} | {} | {}{} | {} | {} | {} |\n", what(outcome), number(time),
             two == nullptr ? "–" : number(warm(*two)), one == nullptr ? "–" : one->name,
             number(best), peer == nullptr ? "" : " " + peer->name, ratio(best, time),
             number(outcome.floor.run), ratio(time, outcome.floor.run));
}

}  // namespace

void print_machine() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line, model = "unknown processor";
  while (std::getline(cpuinfo, line))
    if (line.starts_with("model name")) model = line.substr(line.find(':') + 2);
#if defined(__clang__)
  const char* compiler = "clang " __clang_version__;
#else
  const char* compiler = "g++ " __VERSION__;
#endif
#if defined(NDEBUG)
  const char* warning = "";
#else
  const char* warning = "; NOT OPTIMISED: assertions are on";
#endif
  double load = 0;
  if (getloadavg(&load, 1) != 1) load = std::nan("");
  fmt::print("{:%Y-%m-%d}, {}, {} processors, load {:.1f}; {}{}\n",
             fmt::localtime(std::time(nullptr)), model, sysconf(_SC_NPROCESSORS_ONLN), load,
             compiler, warning);
  fmt::print(
      "One thread: processor time. Two threads: the clock's, worth little where the load is not "
      "small. The other libraries' refinement uses one thread; OpenSubdiv's stencils are cut into "
      "ranges for two. Ratios to the best peer are to one on one thread.\n");
}

void print_full_head(const std::string& mesh) {
  fmt::print(
      "\n### Full refinement: {}\n\n"
      "| scheme, level, vertices | | ns/vertex, cold · warm | bytes/vertex | "
      "÷ best peer, cold · warm | ÷ floor, warm |\n"
      "| --- | --- | --- | --- | --- | --- |\n",
      mesh);
}

void print_full(const Outcome& outcome) {
  const double best_cold = least(outcome, is_peer, cold), best_warm = least(outcome, is_peer, warm);
  std::string first = what(outcome);
  for (const Entry& entry : outcome.entries) {
    if (!ran(entry)) continue;
    fmt::print("| {} | {} | {} · {} | {} | {} · {} | {} |\n", first, entry.name,
               number(cold(entry)), number(warm(entry)), number(entry.cold.bytes),
               ratio(cold(entry), best_cold), ratio(warm(entry), best_warm),
               ratio(warm(entry), outcome.floor.run));
    first.clear();
  }
  fmt::print("| | {} | {} | | | |\n", floor_name(outcome), number(outcome.floor.run));
}

void print_again_head(const std::string& mesh) {
  fmt::print(
      "\n### Positions again, the topology being known: {}\n\n"
      "| scheme, level, vertices | | ns/vertex | preparation, ns/vertex | bytes/vertex with it | "
      "÷ best peer | ÷ floor |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n",
      mesh);
}

void print_again(const Outcome& outcome) {
  const double best = least(outcome, is_peer, warm);
  std::string first = what(outcome);
  for (const Entry& entry : outcome.entries) {
    if (!ran(entry)) continue;
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", first, entry.name, number(warm(entry)),
               number(entry.warm.preparation), number(entry.warm.bytes), ratio(warm(entry), best),
               ratio(warm(entry), outcome.floor.run));
    first.clear();
  }
  fmt::print("| | {} | {} | | | | |\n", floor_name(outcome), number(outcome.floor.run));
}

void print_summaries(const std::vector<Summary>& summaries) {
  fmt::print("\n### In short, ns/vertex, warm\n");
  for (const Summary& summary : summaries) {
    fmt::print(
        "\n{}:\n\n| scheme, level, vertices | limn, one thread · two | by | best peer | "
        "times as fast, one thread | floor | ÷ floor |\n| --- | --- | --- | --- | --- | --- | --- "
        "|\n",
        summary.title);
    for (const Outcome& outcome : summary.outcomes) print_summary(outcome);
  }
}

}  // namespace limn::peers
