#include "call.h"

#include <chrono>

namespace limn::python {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kBetweenLooks{50};
thread_local Clock::time_point next_look;

void look_for_signals() {
  if (Clock::now() < next_look) return;
  {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw Interrupted{};
  }
  next_look = Clock::now() + kBetweenLooks;
}

}  // namespace

SignalWatch::SignalWatch() : before_(base::set_interrupt_check(look_for_signals)) {
  next_look = Clock::now() + kBetweenLooks;
}

SignalWatch::~SignalWatch() { base::set_interrupt_check(before_); }

void raise_interrupt() {
  if (PyErr_Occurred() == nullptr) PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw py::error_already_set();
}

}  // namespace limn::python
