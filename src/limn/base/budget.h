#pragma once
/// How long work may take that could go on for minutes, and on how many threads. What was reached
/// is given when a budget ends. Results are the same in every run as long as none does; they have
/// the same bits whatever the number of threads is.

#include <functional>

namespace limn {

/// At most `threads` threads for every loop that starts later; 0: as many as the machine has (the
/// default). Safe while loops run in other threads: those keep the limit they started with.
void set_thread_limit(int threads);
/// The limit that was set last; 0: none.
[[nodiscard]] int thread_limit();

/// Whether long work should end with what it has. Asked often, by several threads at once; no
/// function at all: never.
using Stop = std::function<bool()>;
/// Whether `stop` asks for the end; false where it is empty.
[[nodiscard]] inline bool asked(const Stop& stop) { return stop && stop(); }

[[nodiscard]] double steady_seconds();  ///< since some moment

/// A number of seconds from a start. Copies share the start.
class TimeBudget {
 public:
  using Clock = std::function<double()>;  ///< seconds since some moment; never falls

  /// Without end.
  TimeBudget() = default;
  /// Begins now. Infinite seconds: without end.
  explicit TimeBudget(double seconds, Clock clock = steady_seconds);

  /// Whether it ever ends.
  [[nodiscard]] bool is_limited() const { return clock_ != nullptr; }
  /// Whether that share of it has passed.
  [[nodiscard]] bool ended(double share = 1) const;
  /// Asks for the end of a share of it.
  [[nodiscard]] Stop stop(double share = 1) const;

 private:
  double start_ = 0, seconds_ = 0;
  Clock clock_;
};

}  // namespace limn
