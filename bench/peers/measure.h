#pragma once
/// One piece of work, timed in a process of its own.
///
/// On one thread the time is that of the processor, which other programs on the machine hardly
/// change; on more it is that of the clock, which they do. Compare only within one run.

#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace limn::peers {

/// Work that is prepared once and done once or, where `again` says so, any number of times.
class Trial {
 public:
  Trial() = default;
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  virtual ~Trial() = default;

  virtual void run() = 0;

  /// What `run` made.
  struct Size {
    double vertices = 0;
    double corners = 0;  ///< of all faces; 0 where the trial does not say
  };
  [[nodiscard]] virtual Size size() const = 0;
};

struct Contender {
  std::string name;
  bool ours = true;
  int threads = 1;
  /// Called in the process that measures; nullptr where the library has no such method.
  std::function<std::unique_ptr<Trial>()> prepare;
};

/// Infinite where nothing was measured.
struct Measurement {
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  double preparation = kNever;  ///< ns/vertex
  double run = kNever;          ///< ns/vertex
  double bytes = kNever;        ///< per vertex, at the peak, beyond what the process held before
  Trial::Size size;

  /// The least of each number of both.
  void keep_least(const Measurement& other);
};

enum class Manner {
  cold,   ///< prepared and run once, in a fresh process with the default malloc: page faults count
  warm,   ///< prepared and run several times, in memory that the process keeps: the best
  again,  ///< prepared once, run several times: the best; `bytes` includes the preparation's
};

/// Nothing is measured where the contender has no such method or ends badly, an exception included.
/// To be called by a process with one thread. Throws std::runtime_error where the system has no
/// process to spare.
[[nodiscard]] Measurement measure(const Contender& contender, Manner manner);

}  // namespace limn::peers
