#pragma once
/// Calls of the library from Python: other Python threads run meanwhile, and Ctrl-C ends the call.

#include <pybind11/pybind11.h>

#include <string>

#include "limn/base/budget.h"
#include "limn/base/interrupt.h"

namespace limn::python {

namespace py = pybind11;

/// What the check of a call throws once a signal's handler in Python has raised; its exception is
/// set in that thread.
struct Interrupted {};

/// While it lives, loops of the calling thread look for signals some times a second. To be made and
/// destroyed while the thread holds the interpreter.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  base::InterruptCheck before_;
};

/// Raises in Python what a handler of a signal has raised, or KeyboardInterrupt.
[[noreturn]] void raise_interrupt();

/// work() without the interpreter's lock. It must touch no Python object.
template <class Work>
auto without_gil(Work&& work) {
  const SignalWatch watch;
  try {
    const py::gil_scoped_release release;
    return work();
  } catch (const Interrupted&) {
  }
  raise_interrupt();
}

/// For the library's callbacks that say what is done next: looks for signals.
inline void on_progress(const std::string& /*what*/) { base::check_interrupt(); }

/// A time budget's end, and signals.
[[nodiscard]] inline Stop stop_of(const TimeBudget& budget) {
  return [budget] {
    base::check_interrupt();
    return budget.ended();
  };
}

}  // namespace limn::python
