#pragma once
/// How many threads the library uses. Its results have the same bits whatever the number is.

namespace limn {

/// At most `threads` threads for every loop that starts later; 0: as many as the machine has (the
/// default). Safe while loops run in other threads: those keep the limit they started with.
void set_thread_limit(int threads);
/// The limit that was set last; 0: none.
[[nodiscard]] int thread_limit();

}  // namespace limn
