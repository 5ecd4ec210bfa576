/// Signals: they leave nothing behind, and end the process as a shell expects.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>

#include "run_command.h"
#include "support/sanitized.h"

namespace limn::test {
namespace {

const std::string kBracket = LIMN_EXAMPLES "/bracket.obj";

/// Starts limn with a signal in the state `handler`, sends the signal after so long, and returns
/// the status that wait gives. Signal 0 only waits.
int status_after(const Folder& folder, int signal, useconds_t microseconds, int levels,
                 sighandler_t handler = SIG_DFL) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (signal != 0) ::signal(signal, handler);
    if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
    const std::string count = std::to_string(levels);
    // not into the test's own streams
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(99);
    ::execl(LIMN_COMMAND, LIMN_COMMAND, "refine", kBracket.c_str(), "-s", "loop", "-n",
            count.c_str(), "-o", "fine.obj", "--curvatures", "fine.csv", nullptr);
    ::_exit(99);
  }
  ::usleep(microseconds);
  ::kill(child, signal);
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

/// Both outputs or none, and nothing else.
void expect_whole(const Folder& folder, bool done) {
  const bool mesh = std::filesystem::exists(folder.file("fine.obj"));
  const bool table = std::filesystem::exists(folder.file("fine.csv"));
  EXPECT_EQ(mesh, table);
  EXPECT_EQ(folder.count(), mesh ? 2 : 0);
  if (done) EXPECT_TRUE(mesh);
}

class Signals : public testing::TestWithParam<int> {};

TEST_P(Signals, EndTheProcessAndLeaveNothing) {
  const int signal = GetParam();
  if (kSanitized && signal == SIGSEGV) GTEST_SKIP() << "sanitizers take this signal";
  const auto start = std::chrono::steady_clock::now();
  {
    const Folder folder;
    (void)status_after(folder, 0, 0, 5);
  }
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  // most of them while files are written, which is the last part
  for (const double part : {0.1, 0.3, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95}) {
    const Folder folder;
    const auto after = static_cast<useconds_t>(part * static_cast<double>(whole.count()));
    const int status = status_after(folder, signal, after, 5);
    // what takes less time than before may be done
    const bool done = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    EXPECT_TRUE(done || (WIFSIGNALED(status) && WTERMSIG(status) == signal)) << status;
    expect_whole(folder, done);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Signals,
                         testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM,
                                         SIGUSR1, SIGUSR2, SIGVTALRM, SIGPIPE, SIGSEGV, SIGABRT,
                                         SIGRTMIN));

TEST(Signal, ThatWasIgnoredStaysIgnored) {  // nohup, and background jobs of a shell
  for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1}) {
    const Folder folder;
    const int status = status_after(folder, signal, 50'000, 3, SIG_IGN);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << signal << " " << status;
    expect_whole(folder, true);
  }
}

TEST(Signal, InterruptsTheLoopOfAShellToo) {
  const Folder folder;
  // bash goes on after a command that exits by itself; here the command dies of the interrupt
  folder.write("loop.sh", "for i in 1 2 3; do '" LIMN_COMMAND "' refine '" + kBracket +
                              "' -s loop -n 7 -o x.obj --curvatures x.csv; echo after; done\n");
  if (std::system("command -v bash setsid timeout >/dev/null") != 0) GTEST_SKIP() << "no bash";
  const Outcome outcome = folder.shell("timeout --signal=INT 0.4 bash loop.sh");
  EXPECT_EQ(outcome.out.find("after"), std::string::npos) << outcome.out;
  EXPECT_EQ(folder.count(), 1);
}

TEST(Signal, OfAFileThatIsTooLargeIsAnErrorOfWriting) {
  for (const std::string file : {"fine.obj", "fine.ply"}) {
    const Folder folder;
    const std::string job = "\"$LIMN\" refine '" + kBracket + "' -s loop -n 4 -o " + file;
    expect_refused(folder.shell("ulimit -f 8; " + job), {file, "cannot write", "ulimit -f"});
    EXPECT_EQ(folder.count(), 0);
    EXPECT_EQ(folder.shell(job).code, 0);
  }
}

TEST(Signal, LeavesNothingOfAMeshThatIsWrittenWhileItIsMade) {
  const std::string job = "\"$LIMN\" refine '" + kBracket + "' -s loop -n 8 -o fine.ply";
  const Folder whole;
  ASSERT_EQ(whole.shell(job).code, 0);
  const auto size_of = [](const Folder& folder) {
    return std::filesystem::file_size(folder.file("fine.ply"));
  };
  bool some = false;
  for (const std::string after : {"0.02", "0.05", "0.1", "0.2", "0.4"}) {
    const Folder folder;
    const Outcome outcome = folder.shell("timeout --signal=TERM " + after + " " + job);
    some = some || outcome.code == 124;
    // the signal may come when all is written, just before the end
    if (outcome.code != 0 && folder.count() == 0) continue;
    EXPECT_EQ(folder.count(), 1) << after;
    EXPECT_EQ(size_of(folder), size_of(whole)) << after;
  }
  EXPECT_TRUE(some);
}

}  // namespace
}  // namespace limn::test
