#include "python_module.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "limn/base/printable.h"

namespace limn::app {
namespace {

namespace fs = std::filesystem;

constexpr int kHasNoOther = 3;  // exit code of the trial below

/// Folders that may hold limn, before those that the user names: of the same build as this program.
std::string search_path() {
  std::error_code failed;
  const fs::path folder = fs::read_symlink("/proc/self/exe", failed).parent_path();
  std::string path;
  for (const fs::path& one : {folder.parent_path() / "python",
                              folder.parent_path() / "lib" / "python3" / "dist-packages"})
    if (fs::is_directory(one / "limn", failed)) path += (path.empty() ? "" : ":") + one.string();
  const char* given = std::getenv("PYTHONPATH");
  if (given != nullptr && *given != '\0') path += (path.empty() ? "" : ":") + std::string(given);
  return path;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

/// The exit code of a program that is silent; -1: there is no such program, or it was killed.
int run_silently(std::vector<std::string> words) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int fd : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int fault =
      ::posix_spawnp(&child, words[0].c_str(), &actions, nullptr, pointers(words).data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) return -1;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Error become_python(const std::string& module, const std::string& needed,
                    const std::vector<std::string>& arguments) {
  if (const std::string path = search_path(); !path.empty())
    ::setenv("PYTHONPATH", path.c_str(), 1);
  std::vector<std::string> candidates{"python3", "/usr/bin/python3"};
  if (const char* own = std::getenv("LIMN_PYTHON"); own != nullptr && *own != '\0')
    candidates = {own};
  const std::string trial = fmt::format(
      "import importlib.util, limn; raise SystemExit(0 if importlib.util.find_spec('{}') else {})",
      needed, kHasNoOther);
  bool has_limn = false;
  for (const std::string& python : candidates) {
    const int code = run_silently({python, "-c", trial});
    has_limn = has_limn || code == kHasNoOther;
    if (code != 0) continue;
    std::vector<std::string> words{python, "-m", module};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ::execvp(words[0].c_str(), pointers(words).data());
    return {fmt::format("{} cannot be started: {}", base::printable(python),
                        std::generic_category().message(errno))};
  }
  if (has_limn)
    return {fmt::format("Python has no module {}", needed),
            fmt::format("install python3-{}, or set LIMN_PYTHON to a Python that has it", needed)};
  return {fmt::format("no Python here can import limn, which {} is part of", module),
          "build the module (docs/python.md), and set PYTHONPATH to its folder or LIMN_PYTHON to "
          "the Python that has it"};
}

}  // namespace limn::app
