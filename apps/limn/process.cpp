#include "process.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <system_error>

#include "limn/base/files/unfinished.h"

namespace limn::app {
namespace {

pthread_t main_thread;

/// Faults of the thread that they reach; the others are sent to the process.
constexpr std::array kFaults = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};
/// Signals that do not end a process unless it wants so, and those that nobody can handle.
constexpr std::array kHarmless = {SIGKILL, SIGSTOP, SIGCHLD, SIGURG,  SIGWINCH,
                                  SIGTSTP, SIGTTIN, SIGTTOU, SIGCONT, SIGXFSZ};

template <class List>
bool contains(const List& list, int signal) {
  for (const int one : list)
    if (one == signal) return true;
  return false;
}

/// Async-signal-safe throughout. In the main thread, which makes the files: between the
/// registration of a name and the making of its file nothing else can then happen.
extern "C" void remove_and_die(int signal) {
  const int saved = errno;
  if (!contains(kFaults, signal) && ::gettid() != ::getpid()) {
    ::pthread_kill(main_thread, signal);
    errno = saved;
    return;
  }
  base::remove_unfinished_files();
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(signal, &usual, nullptr);
  sigset_t only;
  ::sigemptyset(&only);
  ::sigaddset(&only, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);  // as a shell would say it
}

/// So that an exhausted stack is handled as well, in the main thread.
void use_other_stack() {
  static std::array<char, 65536> memory;
  stack_t stack{};
  if (::sigaltstack(nullptr, &stack) != 0 || (stack.ss_flags & SS_DISABLE) == 0) return;
  stack = {};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  ::sigaltstack(&stack, nullptr);
}

}  // namespace

void handle_signals() {
  main_thread = ::pthread_self();
  use_other_stack();
  struct sigaction ours {};
  ours.sa_handler = remove_and_die;
  ours.sa_flags = SA_ONSTACK;
  ::sigfillset(&ours.sa_mask);
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    struct sigaction before {};
    if (contains(kHarmless, signal) || ::sigaction(signal, nullptr, &before) != 0) continue;
    if ((before.sa_flags & SA_SIGINFO) != 0 || before.sa_handler != SIG_DFL) continue;
    ::sigaction(signal, &ours, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // then the write fails
}

void keep_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(fd, F_GETFD) < 0 && errno == EBADF)  // the lowest free one is `fd`
      (void)::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

Error no_standard_output(int code) {
  const std::string reason = code != 0 ? ": " + std::generic_category().message(code) : "";
  return {"cannot write to standard output" + reason};
}

Status check_standard_output() {
  errno = 0;
  bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  if (!failed) {  // some file systems report a full disk at the close only
    const int copy = ::dup(STDOUT_FILENO);
    failed = copy >= 0 && ::close(copy) != 0;
  }
  if (!failed) return Done{};
  return no_standard_output(errno);
}

}  // namespace limn::app
