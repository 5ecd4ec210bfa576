#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include <unistd.h>

#include "command.h"
#include "limn/base/file.h"
#include "limn/base/near_word.h"
#include "limn/base/parallel.h"

namespace limn::app {
namespace {

// One line for each command, in the order of the help.
constexpr Declare kCommands[] = {declare_schemes,    declare_show,      declare_refine,
                                 declare_draw,       declare_artifacts, declare_eigen,
                                 declare_regularity, declare_prescribe, declare_tune,
                                 declare_fairness,   declare_compare,   declare_papers};

extern "C" void leave_nothing_half_written(int signal) {
  remove_unfinished_files();
  _exit(128 + signal);
}

/// CLI11 would only say that a command is missing.
Status check_command(const CLI::App& parser, const std::string& word) {
  std::string known;
  std::vector<std::string> names;
  for (const CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
    if (names.back() == word) return Done{};
    known += (known.empty() ? "" : ", ") + names.back();
  }
  return Error{"there is no command '" + word + "'",
               did_you_mean(word, names, "the commands are " + known),
               {},
               0,
               0};
}

int run(int argc, char** argv) {
  CLI::App parser("limn: define a subdivision scheme in a text file, refine meshes with it",
                  "limn");
  parser.set_version_flag("--version", "limn " LIMN_VERSION);
  parser.require_subcommand(1);
  int threads = 0;
  parser.add_option("--threads", threads, "use at most this many threads; 0 means all")
      ->check(CLI::Range(0, 4096));
  parser.fallthrough();
  parser.footer(
      "Example: limn refine mesh.obj -s loop -n 4 -o fine.ply\n"
      "`limn COMMAND --help` explains a command.");
  Action action;
  for (const Declare declare : kCommands) declare(parser, action);
  if (const std::string word = argc > 1 ? argv[1] : ""; !word.empty() && word[0] != '-')
    if (Status status = check_command(parser, word); !status) return report(status.error());
  try {
    parser.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return parser.exit(success);
  } catch (const CLI::ParseError& error) {
    return report(
        {error.what(), "`limn --help` and `limn COMMAND --help` explain the use", {}, 0, 0});
  }
  set_thread_limit(threads);
  return action();
}

}  // namespace
}  // namespace limn::app

int main(int argc, char** argv) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, limn::app::leave_nothing_half_written);
  try {
    const int code = limn::app::run(argc, argv);
    // a full disk or a closed pipe must not pass for success
    if (std::fflush(stdout) != 0 && code == limn::app::kDone)
      return limn::app::report({"cannot write to standard output", {}, {}, 0, 0});
    return code;
  } catch (const std::bad_alloc&) {
    limn::remove_unfinished_files();
    std::fputs("limn: out of memory (refine fewer levels or a smaller mesh)\n", stderr);
  } catch (const std::exception& failure) {  // printing failed: a full disk, a closed pipe
    limn::remove_unfinished_files();
    std::fprintf(stderr, "limn: %s\n", failure.what());
  }
  return limn::app::kBadInput;
}
