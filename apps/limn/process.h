#pragma once
/// The command as a process: its signals, its standard streams, and how it ends.

#include "limn/base/error.h"

namespace limn::app {

/// Every signal that ends a process now first removes what is unfinished; then the process dies of
/// it, so that a shell knows. A signal that was ignored on entry stays ignored (nohup, background
/// jobs), and a file that grows beyond `ulimit -f` is an error of writing, not a signal. Call it in
/// the main thread, before there are others.
void handle_signals();

/// Gives closed standard streams to /dev/null, in the direction that fails: else the next file that
/// is opened would take their place, and get what is printed.
void keep_standard_streams();

/// That standard output cannot be written, and why: errno, or 0 where it is not known.
[[nodiscard]] Error no_standard_output(int code);

/// Whether all that was printed has arrived: a full disk or a closed stream must not pass for
/// success.
[[nodiscard]] Status check_standard_output();

}  // namespace limn::app
