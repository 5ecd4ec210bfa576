#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "command.h"
#include "limn/base/files/file_transaction.h"
#include "limn/base/near_word.h"
#include "limn/base/parallel.h"
#include "output/bundled_fonts.h"
#include "process.h"

namespace limn::app {
namespace {

// One line for each command, in the order of the help.
constexpr Declare kCommands[] = {
    declare_schemes,   declare_show,  declare_refine,     declare_check,   declare_draw,
    declare_artifacts, declare_eigen, declare_regularity, declare_certify, declare_prescribe,
    declare_tune,      declare_study, declare_fairness,   declare_compare, declare_papers,
    declare_report,    declare_man,   declare_completion};

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
               base::did_you_mean(word, names, "the commands are " + known)};
}

int run(int argc, char** argv) {
  CLI::App parser("limn: define a subdivision scheme in a text file, refine meshes with it",
                  "limn");
  parser.set_version_flag("--version", "limn " LIMN_VERSION);
  parser.require_subcommand(1);
  int threads = 0;
  parser.add_option("--threads", threads, "use at most this many threads; 0 means all")
      ->check(CLI::Range(0, 4096));
  parser.add_flag_function(
      "--quiet", [](std::int64_t) { be_quiet(); },
      "no progress, remarks and warnings on standard error, only errors");
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
    return report({error.what(), "`limn --help` and `limn COMMAND --help` explain the use"});
  }
  // more than there are processors are no faster
  set_thread_limit(
      std::min(threads, std::max(1, static_cast<int>(std::thread::hardware_concurrency()))));
  set_step("limn " + parser.get_subcommands().front()->get_name());
  return action();
}

/// The outputs of a command are all or none: they take their names once it is done and all that it
/// prints has arrived.
int run_whole(int argc, char** argv) {
  base::FileTransaction outputs;
  const int code = run(argc, argv);
  if (code == kBadInput) return code;
  if (Status status = check_standard_output(); !status) return report(status.error());
  if (Status status = outputs.commit(); !status) return report(status.error());
  return code;
}

int report_out_of_memory() {
  std::fprintf(stderr, "limn: out of memory: %s (%s)\n", step().c_str(),
               "a smaller input or fewer levels need less");
  return kBadInput;
}

}  // namespace
}  // namespace limn::app

int main(int argc, char** argv) {
  using namespace limn::app;
  keep_standard_streams();
  handle_signals();
  try {
    use_bundled_fonts();
    return run_whole(argc, argv);
  } catch (const std::bad_alloc&) {
    return report_out_of_memory();
  } catch (const std::length_error&) {  // more than a container can hold
    return report_out_of_memory();
  } catch (const std::system_error& failure) {
    if (std::ferror(stdout) != 0) return report(no_standard_output(failure.code().value()));
    std::fprintf(stderr, "limn: %s: %s\n", step().c_str(), failure.what());
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "limn: %s: %s\n", step().c_str(), failure.what());
  }
  return kBadInput;
}
