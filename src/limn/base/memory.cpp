#include "limn/base/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <sstream>

#include <fmt/core.h>

namespace limn::base {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// The number that a file begins with; no bound where there is none, as for "max".
double number_in(const std::string& path) {
  std::ifstream in(path);
  double number = 0;
  return in >> number ? number : kNoBound;
}

/// The number behind `word` in a file of words and numbers; `otherwise` where there is none.
double number_behind(const std::string& path, const std::string& word, double otherwise) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream parts(line);
    std::string name;
    double number = 0;
    if (parts >> name >> number && name == word) return number;
  }
  return otherwise;
}

/// Files of a control group's folder.
struct GroupFiles {
  const char *limit, *usage, *droppable;
};
constexpr GroupFiles kVersion2{"/memory.max", "/memory.current", "inactive_file"};
constexpr GroupFiles kVersion1{"/memory.limit_in_bytes", "/memory.usage_in_bytes",
                               "total_inactive_file"};

double free_in_group(const std::string& folder, const GroupFiles& files) {
  const double limit = number_in(folder + files.limit);
  const double usage = number_in(folder + files.usage);
  if (limit == kNoBound || usage == kNoBound) return kNoBound;
  return std::max(0.0, limit - usage + number_behind(folder + "/memory.stat", files.droppable, 0));
}

/// The least of a group and those above it. In a container the path may be one of outside: what is
/// not there is passed over, and the mount itself is looked at in any case.
double free_in_groups(const std::string& mount, std::string path, const GroupFiles& files) {
  double least = free_in_group(mount, files);
  while (path.size() > 1) {
    least = std::min(least, free_in_group(mount + path, files));
    path.resize(path.rfind('/') == std::string::npos ? 0 : path.rfind('/'));
  }
  return least;
}

/// The least of the groups that /proc/self/cgroup names: lines "NUMBER:CONTROLLERS:PATH".
double free_in_own_groups(const std::string& root) {
  double least = kNoBound;
  std::ifstream in(root + "/proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string path = line.substr(second + 1);
    const std::string mount = root + "/sys/fs/cgroup";
    if (controllers == ",,") {
      for (const char* unified : {"", "/unified"})
        least = std::min(least, free_in_groups(mount + unified, path, kVersion2));
    } else if (controllers.find(",memory,") != std::string::npos) {
      least = std::min(least, free_in_groups(mount + "/memory", path, kVersion1));
    }
  }
  return least;
}

/// What a limit leaves beyond what is used of it, `pages` of memory.
double left_of(const struct rlimit& limit, double pages) {
  if (limit.rlim_cur == RLIM_INFINITY) return kNoBound;
  const double used = pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

}  // namespace

double available_memory_of(const std::string& root) {
  constexpr double kKilobyte = 1024;
  const double machine = number_behind(root + "/proc/meminfo", "MemAvailable:", kNoBound);
  return std::min(machine * kKilobyte, free_in_own_groups(root));
}

double available_memory() {
  // in pages: all, resident, shared, text, library, data and stack
  std::ifstream statm("/proc/self/statm");
  std::array<double, 6> pages{};
  for (double& count : pages) statm >> count;
  struct rlimit addresses {
    RLIM_INFINITY, RLIM_INFINITY
  };
  struct rlimit data = addresses;
  ::getrlimit(RLIMIT_AS, &addresses);
  ::getrlimit(RLIMIT_DATA, &data);
  return std::min({available_memory_of(""), left_of(addresses, pages[0]), left_of(data, pages[5])});
}

std::string bytes_text(double bytes) {
  constexpr double kMiB = 1024.0 * 1024.0;
  if (bytes >= 0.1 * 1024 * kMiB) return fmt::format("{:.1f} GiB", bytes / (1024 * kMiB));
  if (bytes < kMiB) return fmt::format("{:.0f} KiB", bytes / 1024);
  return fmt::format("{:.1f} MiB", bytes / kMiB);
}

}  // namespace limn::base
