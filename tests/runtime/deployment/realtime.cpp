// The thread of an environment in real time: what the system allows it has while it runs, and what the system
// refuses is said.
#include <doctest/doctest.h>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "robot_and_mind.hpp"

using namespace deployment_test;

namespace {

// How the thread runs in which it is called.
struct scheduling {
  int policy = -1, priority = -1, cores = 0;
  bool operator==(const scheduling&) const = default;
};
scheduling scheduling_here() {
  scheduling s;
  sched_param parameter{};
  ::pthread_getschedparam(::pthread_self(), &s.policy, &parameter);
  s.priority = parameter.sched_priority;
  cpu_set_t cores;
  ::pthread_getaffinity_np(::pthread_self(), sizeof cores, &cores);
  s.cores = CPU_COUNT(&cores);
  return s;
}

struct witness {
  scheduling seen;
  auto process(cca::beat) -> cca::out<"y", level> {
    seen = scheduling_here();
    return 0.0;
  }
};
struct witnesses : cca::graph<cca::rate<1000>, cca::node<"a", witness>, cca::node<"b", witness>> {};

template <class Option>
struct spread_with : cca::deployment<witnesses,
                                     cca::environment<"one", cca::nodes<"a">, Option>,
                                     cca::environment<"two", cca::nodes<"b">, Option>> {};
struct only_one
    : cca::deployment<witnesses,
                      cca::environment<"one", cca::nodes<"a">, cca::realtime_if_allowed<7, cca::on_core<0>>>,
                      cca::environment<"two", cca::nodes<"b">>> {};
using urgent = spread_with<cca::realtime<7, cca::on_core<0>>>;
using urgent_if_allowed = spread_with<cca::realtime_if_allowed<7, cca::on_core<0>>>;

template <class D>
std::string refusal_of_run() {
  cca::deployed<D> d;
  d.load();
  d.start();
  try {
    d.run(cca::for_beats<3>{});
  } catch (const cca::refused& refusal) {
    CHECK_EQ(d.state(), cca::state::started);
    CHECK_EQ(d.beat_index(), 0);
    return refusal.what();
  }
  CHECK_EQ(d.template get<"a">().seen, scheduling{SCHED_FIFO, 7, 1});
  CHECK_EQ(d.template get<"b">().seen, scheduling{SCHED_FIFO, 7, 1});
  return "";
}

// A process that may have no priority and only so much locked memory, and what it exits with.
template <class F>
int in_poor_process(F f, rlim_t lockable = 0) {
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit nothing{0, 0}, memory{lockable, lockable};
    ::setrlimit(RLIMIT_RTPRIO, &nothing);
    if (::setrlimit(RLIMIT_MEMLOCK, &memory) != 0) ::_exit(98);
    if (::geteuid() == 0 && ::setuid(65534) != 0) ::_exit(99);
    ::_exit(f());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// Memory of this process that is never paged out.
long locked_kilobytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmLck:")) return std::stol(line.substr(6));
  return -1;
}
// All that it has mapped: the system compares a limit with that (bytes).
rlim_t address_space() {
  std::ifstream pages("/proc/self/statm");
  rlim_t count = 0;
  pages >> count;
  return count * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}
// Whether the system lets this process do so, and really does it: under a sanitizer it does nothing.
bool is_memory_lockable() {
  const bool is_locked = ::mlockall(MCL_CURRENT) == 0 && locked_kilobytes() > 0;
  ::munlockall();
  return is_locked;
}

}  // namespace

TEST_SUITE("realtime") {
  TEST_CASE("a process that may not is told what to do") {
    CHECK_EQ(in_poor_process([] {
               const std::string refusal = refusal_of_run<urgent>();
               if (!has(refusal, "environment `one`")) return 1;
               if (!has(refusal, "SCHED_FIFO with priority 7")) return 2;
               if (!has(refusal, "/etc/security/limits.conf")) return 3;
               if (!has(refusal, "rtprio 7")) return 4;
               if (!has(refusal, "setcap")) return 5;
               if (!has(refusal, "realtime_if_allowed")) return 6;
               if (::mlockall(MCL_CURRENT) == 0) return 0;  // nothing is refused: a sanitizer does nothing
               if (!has(refusal, "its memory can't be locked") || !has(refusal, "memlock unlimited"))
                 return 7;
               return 0;
             }),
             0);
  }

  TEST_CASE("or goes on, and says so once for each environment") {
    CHECK_EQ(in_poor_process([] {
               int pipe[2];
               if (::pipe(pipe) != 0) return 1;
               ::dup2(pipe[1], STDERR_FILENO);
               cca::deployed<urgent_if_allowed> d;
               d.load();
               d.start();
               d.run(cca::for_beats<3>{});
               d.run(cca::for_beats<3>{});
               if (d.beat_index() != 6) return 2;
               char said[8192] = {};
               const auto size = ::read(pipe[0], said, sizeof said - 1);
               const std::string text(said, static_cast<std::size_t>(size));
               const auto first = text.find("environment `one` does not run in real time");
               if (first == std::string::npos || !has(text, "environment `two`")) return 3;
               if (text.find("environment `one`", first + 1) != std::string::npos) return 4;
               return 0;
             }),
             0);
  }

  TEST_CASE("or goes on whatever the limit of locked memory is, and is pinned only with its priority") {
    rlimit most{};
    ::getrlimit(RLIMIT_MEMLOCK, &most);
    const rlim_t has = address_space(), mib = 1 << 20;
    bool is_critical_one_tested = false;
    for (const rlim_t limit :
         {rlim_t{64 << 10}, mib, 8 * mib, has + mib, has + 64 * mib, rlim_t{RLIM_INFINITY}}) {
      const int code = in_poor_process(
          [] {
            const scheduling before = scheduling_here();
            cca::deployed<urgent_if_allowed> d;
            d.load();
            d.start();
            std::vector<std::string> log;
            d.run(cca::for_beats<60>{}, {}, [&](auto&) { return log.emplace_back(2 << 20, 'x'), true; });
            if (d.beat_index() != 60) return 1;
            if (d.get<"a">().seen != before || d.get<"b">().seen != before) return 2;
            std::thread([] {}).join();  // it needs a stack
            return 0;
          },
          limit);
      if (code == 98) continue;  // only a privileged process may raise its limit
      CAPTURE(limit);
      CHECK_EQ(code, 0);
      is_critical_one_tested = is_critical_one_tested || (limit > has && limit < RLIM_INFINITY);
    }
    if (!is_critical_one_tested)
      MESSAGE("NOT TESTED HERE with a limit above what the process has: the greatest limit is "
              << most.rlim_max);
  }

  TEST_CASE("where it is allowed, both threads have it during the run, and this one has it no more after") {
    const scheduling before = scheduling_here();
    const std::string refusal = refusal_of_run<urgent>();
    if (!refusal.empty()) MESSAGE("NOT TESTED HERE, this machine allows no real time: " << refusal);
    CHECK((refusal.empty() || has(refusal, "limits.conf") || has(refusal, "cca::on_core")));
    CHECK_EQ(scheduling_here(), before);
  }

  TEST_CASE("an environment that does not ask for it has neither the priority nor the core of the first") {
    const scheduling before = scheduling_here();
    cca::deployed<only_one> d;
    d.load();
    d.start();
    d.run(cca::for_beats<3>{});
    CHECK_EQ(d.get<"b">().seen, before);
  }

  TEST_CASE("where it is allowed, the memory of the process is locked, and stays so") {
    ::munlockall();  // a run before this one may have locked it
    if (!is_memory_lockable()) {
      MESSAGE("NOT TESTED HERE, this machine allows no locked memory: " << refusal_of_run<urgent>());
      return;
    }
    REQUIRE_EQ(locked_kilobytes(), 0);
    CHECK_FALSE(has(refusal_of_run<urgent>(), "memory can't be locked"));
    CHECK_GT(locked_kilobytes(), 0);
    ::munlockall();
  }

  TEST_CASE("a core that the machine does not have") {
    const std::string refusal = refusal_of_run<spread_with<cca::realtime<7, cca::on_core<1000>>>>();
    CHECK(has(refusal, "core 1000 can't be used"));
  }
}
