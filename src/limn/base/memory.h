#pragma once
/// How much memory there is to work with.

#include <string>

namespace limn::base {

/// Memory that this process can still take, in bytes: the least of what the machine has
/// (MemAvailable), what its control groups allow (cgroup v1 and v2, each level; what the kernel
/// can drop of their file cache counts as free), and what `ulimit -v` and `ulimit -d` leave.
/// Infinity where nothing tells. Reads a few files of /proc and /sys: not for inner loops.
[[nodiscard]] double available_memory();

/// The part of it that files tell, below `root` in place of /: for tests.
[[nodiscard]] double available_memory_of(const std::string& root);

/// "1.5 GiB", "12.0 MiB", "256 KiB".
[[nodiscard]] std::string bytes_text(double bytes);

}  // namespace limn::base
