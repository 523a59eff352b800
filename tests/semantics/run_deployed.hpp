// Runs an architecture that is spread over environments, in pieces of different lengths.
#pragma once

#include <pthread.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "run.hpp"

namespace semantics {

struct nothing_outside : in_the_loop {
  static constexpr int acts[] = {beats};     // before these beats somebody does something; `beats`: the end
  static constexpr int at_rest[] = {beats};  // where there are processes, too: only between two runs
};

inline void insist(bool is_taken) {
  if (!is_taken) throw std::runtime_error("an earlier request has not been taken");
}

// Between two beats of a deployment: what has to wait for all environments is asked for by live_access.
template <class Around, class Live, class F>
struct by_live_access {
  Live& live;
  std::int64_t end;
  F in_between;

  template <int Environment, class Deployed>
  void after_beat(Deployed& d) {
    if constexpr (Environment == 0)
      if (d.state() != cca::state::faulted && d.beat_index() < end) {
        if (!live.is_taken()) live.template after_beat<0>(d);  // that of the beat before
        Around::order(live, static_cast<int>(d.beat_index()));
      }
    live.template after_beat<Environment>(d);
  }
  template <class Deployed>
  bool goes_on(Deployed& d) {
    in_between(d, true);
    return live.goes_on(d);
  }
  bool is_over() const { return false; }
};

// All environments meet after each beat; then `in_between(played, by_orders)` is called.
template <class Around, class Played, class F>
void run_and_meet(Played& played, std::int64_t count, bool, F in_between) {
  played.run(cca::for_some_beats{count}, cca::as_fast_as_possible{}, [&](auto& p) { in_between(p, false); });
}
template <class Around, class Deployment, class F>
  requires(Around::gives_orders)
void run_and_meet(cca::deployed<Deployment>& played, std::int64_t count, bool by_orders, F in_between) {
  if (!by_orders)
    return played.run(cca::for_some_beats{count}, cca::as_fast_as_possible{},
                      [&](auto& p) { in_between(p, false); }),
           void();
  cca::live_access live(played);
  played.run(cca::for_some_beats{count}, cca::as_fast_as_possible{},
             by_live_access<Around, decltype(live), F>{live, played.beat_index() + count, in_between});
}

// What was recorded, by whichever thread, with a controller or a deployment that runs until f returns false.
template <class Around, class Played, class F>
log recorded(Played& played, int chance, F goes_on) {
  log all;
  recording = &all;  // of this thread
  auto random = static_cast<unsigned>(chance);
  std::int64_t done = 0;  // what somebody does before the beats up to here
  const auto act = [&](Played& p, bool by_orders) {
    for (; done <= p.beat_index(); ++done) Around::before(p, static_cast<int>(done), by_orders);
  };
  while (played.beat_index() < beats) {
    act(played, false);
    random = random * 1664525u + 1013904223u;
    const auto k = played.beat_index();
    const bool they_meet = random >> 20 & 1;  // after each beat
    const std::int64_t end = they_meet ? *std::ranges::upper_bound(Around::at_rest, k)
                                       : *std::ranges::upper_bound(Around::acts, k);
    const auto count = std::min<std::int64_t>(1 + (random >> 8) % 60, end - k);
    if (they_meet)
      run_and_meet<Around>(played, count, random >> 22 & 1, [&](Played& p, bool by_orders) {
        if (p.state() != cca::state::faulted && p.beat_index() < k + count) act(p, by_orders);
      });
    else played.run(cca::for_some_beats{count});
    if (!goes_on(played, random)) break;
  }
  recording = nullptr;
  const log others = recorded_by_threads();
  all.insert(all.end(), others.begin(), others.end());
  return merged(std::move(all));
}

// What goes on between two pieces: until a fault, or with restarts: stopped and started between some, and
// resumed after the first faults. `all_are_here()` returns when all processes have come as far.
inline constexpr auto until_a_fault = [](auto& played, unsigned, auto&) {
  return played.state() != cca::state::faulted;
};
inline constexpr auto with_restarts = [resumes = 0](
                                          auto& played, unsigned random, auto& all_are_here) mutable {
  if (played.state() == cca::state::faulted) {
    if (++resumes == 5) return false;
    played.resume();
  } else if (random >> 21 & 1) {
    played.stop();
    all_are_here();
    played.start();
    all_are_here();  // else a process that has not yet started stops those that run already
  }
  return true;
};

template <class Around, class Played>
log recorded_with_restarts(int chance) {
  const auto played = std::make_unique<Played>();
  played->load();
  played->start();
  return recorded<Around>(*played, chance, [goes_on = with_restarts](Played& p, unsigned random) mutable {
    constexpr auto alone = [] {};
    return goes_on(p, random, alone);
  });
}

// Where processes wait for each other, in memory that they share since they were forked.
class meeting_place {
public:
  explicit meeting_place(unsigned count)
      : barrier(static_cast<pthread_barrier_t*>(::mmap(
            nullptr, sizeof(pthread_barrier_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {
    if (barrier == MAP_FAILED) throw std::runtime_error("no memory to share");
    pthread_barrierattr_t shared;
    ::pthread_barrierattr_init(&shared);
    ::pthread_barrierattr_setpshared(&shared, PTHREAD_PROCESS_SHARED);
    ::pthread_barrier_init(barrier, &shared, count);
  }
  meeting_place(const meeting_place&) = delete;
  meeting_place& operator=(const meeting_place&) = delete;
  ~meeting_place() { ::munmap(barrier, sizeof(pthread_barrier_t)); }
  void operator()() const { ::pthread_barrier_wait(barrier); }

private:
  pthread_barrier_t* barrier;
};

// The digests of what each environment recorded in a process of its own. `over(name)`: the transport.
template <class Deployment, class Around, class Over, class GoesOn>
std::vector<std::uint64_t> recorded_in_processes(int chance, Over over, GoesOn goes_on) {
  static int number = 0;
  const std::string name = "cca_semantics_" + std::to_string(::getpid()) + "_" + std::to_string(number++);
  constexpr int count = cca::detail::environment_count<Deployment>;
  std::vector<std::uint64_t> all;
  int from[count];
  const meeting_place all_are_here(count);
  for (int e = 0; e < count; ++e) {
    int ends[2];
    if (::pipe(ends) != 0) return {};
    if (::fork() == 0) {
      is_alone = false;
      own_environment = e;
      ::alarm(120);  // no process waits for ever for one that has failed
      const cca::only here{cca::detail::environments_of<Deployment>::all[static_cast<std::size_t>(e)].name};
      const auto d = std::make_unique<cca::deployed<Deployment>>(here, over(name));
      d->load();
      d->start();
      const log own = recorded<Around>(
          *d, chance, [&](auto& p, unsigned random) { return goes_on(p, random, all_are_here); });
      for (const firing& f : own) {
        const std::uint64_t one = digest(f);
        if (::write(ends[1], &one, sizeof one) != sizeof one) ::_exit(1);
      }
      ::_exit(0);
    }
    ::close(ends[1]);
    from[e] = ends[0];
  }
  for (const int end : from) {
    for (std::uint64_t one; ::read(end, &one, sizeof one) == sizeof one;) all.push_back(one);
    ::close(end);
  }
  while (::wait(nullptr) > 0) {}
  std::sort(all.begin(), all.end());
  return all;
}

inline std::vector<std::uint64_t> digests(const log& firings) {
  std::vector<std::uint64_t> all;
  for (const firing& f : firings) all.push_back(digest(f));
  std::sort(all.begin(), all.end());
  return all;
}

// Processes do what threads do, until a fault and with restarts. `until_fault`: what the threads did.
template <class Deployment, class Around, class Over>
bool processes_agree(int chance, const log& until_fault, Over over) {
  return digests(until_fault) == recorded_in_processes<Deployment, Around>(chance, over, until_a_fault) &&
         digests(recorded_with_restarts<Around, cca::deployed<Deployment>>(chance)) ==
             recorded_in_processes<Deployment, Around>(chance, over, with_restarts);
}

// With `Architecture`: restarted it is compared with the controller too. With `InProcesses`: also run by
// processes.
template <class Deployment, class Around, class Architecture = void, bool InProcesses = false>
outcome run_deployed(int chance) {
  outcome o;
  o.is_merged = true;
  const auto d = std::make_unique<cca::deployed<Deployment>>();
  d->load();
  d->start();
  o.firings =
      recorded<Around>(*d, chance, [](const auto& p, unsigned) { return p.state() != cca::state::faulted; });
  o.faulted = d->state() == cca::state::faulted;
  if constexpr (!std::is_void_v<Architecture>)
    o.copy_agrees = agree(recorded_with_restarts<Around, cca::controller<Architecture>>(chance), 0,
                          recorded_with_restarts<Around, cca::deployed<Deployment>>(chance));
  if constexpr (InProcesses)
    o.processes_agree = processes_agree<Deployment, Around>(
        chance, o.firings, [](const std::string& name) { return cca::shared_memory("/" + name); });
  return o;
}

}  // namespace semantics
