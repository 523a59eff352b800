// Lets a rank die without the others: mpirun ends a whole job as soon as one of its processes is killed. So
// the process that mpirun has started stays, waits, and leaves the work to a child. If the child of a rank
// but 0 dies, the process says so and goes on waiting, until rank 0 ends the job; of rank 0, it ends with the
// child's exit code, and mpirun then ends the others.
//
// mpirun sends its signals to the group, so to both; the keeper blocks all that can be blocked.
#pragma once

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cca::mpi::detail {

class keeper {
public:
  // Returns in the child only.
  keeper() {
    int ends[2];
    if (::pipe(ends) != 0)
      throw std::runtime_error("cca::mpi: no pipe: " + std::string(std::strerror(errno)));
    std::fflush(nullptr);
    sigset_t all, before;
    ::sigfillset(&all);
    ::sigprocmask(SIG_SETMASK, &all, &before);
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("cca::mpi: no process: " + std::string(std::strerror(errno)));
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (child > 0) {
      ::close(ends[1]);
      keep(child, ends[0]);
    }
    if (::getppid() != parent) ::_exit(128 + SIGKILL);
    ::close(ends[0]);
    to_keeper = ends[1];
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
  }

  // From here on the others can do without this rank, if it isn't 0.
  void is_begun(int rank) const { tell(rank); }
  // From here on its exit code is that of the rank.
  void is_released() const { tell(released); }

private:
  static constexpr int released = -1;

  void tell(int word) const {
    if (::write(to_keeper, &word, sizeof word) != sizeof word)
      std::fputs("cca::mpi: the process that mpirun has started is gone\n", stderr);
  }

  [[noreturn]] static void keep(pid_t child, int from_child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    int rank = -1;
    bool is_begun = false, is_released = false;
    for (int word; ::read(from_child, &word, sizeof word) == sizeof word;) {
      if (word == released) is_released = true;
      else rank = word, is_begun = true;
    }
    const int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    sigset_t pending;
    ::sigpending(&pending);
    const bool job_ends = ::sigismember(&pending, SIGTERM) == 1;
    if (is_begun && WIFSIGNALED(status) && !job_ends) {
      std::fprintf(stderr, "cca::mpi: rank %d was ended by signal %d (%s)%s\n", rank, WTERMSIG(status),
                   ::strsignal(WTERMSIG(status)),
                   rank == 0     ? ": the others can't go on without it"
                   : is_released ? ""
                                 : ": the others make its runs");
    }
    if (is_begun && rank != 0 && !is_released)
      while (true) ::pause();  // all signals that can be are blocked: until mpirun kills it
    ::_exit(code);
  }

  int to_keeper = -1;
};

}  // namespace cca::mpi::detail
