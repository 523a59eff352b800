// The threads of the environments after the first in this process, for one run. They begin together, and end
// with this. Nobody waits for a thread without doing its own work meanwhile: until the beats of all of them
// are over, the resource nodes of each environment idle once a period in the thread of that environment.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <iostream>
#include <ranges>
#include <string>
#include <system_error>
#include <type_traits>

#include <cca/base/refused.hpp>
#include <cca/runtime/environments/environment_loops.hpp>
#include <cca/runtime/environments/meeting.hpp>
#include <cca/base/system/polled_thread.hpp>
#include <cca/runtime/environments/realtime.hpp>
#include <cca/runtime/environments/waiting/idle_beats.hpp>

namespace cca::detail {

// What the system refused to threads that are to run in real time: an error where they must, else said once.
template <class D>
class real_time_refusals {
public:
  template <int E>
  void report(const std::string& refusal) {
    if (refusal.empty()) return;
    const std::string text = "cca::deployed: environment `" + std::string(name_of_environment<D>(E)) +
                             "` does not run in real time: " + refusal;
    if (wish_of_environment<D, E>.is_needed) throw refused(text);
    if (!is_told[E]) std::cerr << text << '\n';
    is_told[E] = true;
  }

private:
  std::array<bool, array_size(environment_count<D>)> is_told{};
};

// `First`: the loop of the environment that runs in the thread which makes this.
template <class D, class First>
class environment_threads {
public:
  // `runs(E)`: in a thread, which is scheduled as `scheduling` says: it must not inherit the priority and the
  // core of this thread. `meanwhile()`: once a period while no beat has begun. report.template
  // operator()<E>(text): what the system refused to the thread of environment E; it may throw, then nothing
  // has run. after_beat.template operator()<E>(): in that thread, between two beats.
  template <class Runs, class Meanwhile, class Report, class AfterBeat>
  environment_threads(environment_loops<D>& loops,
                      First& of_this_thread,
                      Runs runs,
                      const terms_of_run& terms,
                      idle_beats& while_waiting,
                      const scheduling_of_caller& scheduling,
                      Meanwhile meanwhile,
                      Report report,
                      AfterBeat after_beat)
      : first(of_this_thread),
        idle(while_waiting),
        not_ready(static_cast<int>(std::ranges::count_if(std::views::iota(0, environment_count<D>), runs))) {
    try {
      loops.for_each([&]<int E>(auto& loop) {
        if (!runs(E)) return;
        threads[E].start(
            [this, &loop, terms, after_beat, own = idle]() mutable {
              const thread_setup setup(wish_of_environment<D, E>);
              refusals[E] = setup.refusal();
              not_ready.fetch_sub(1, std::memory_order_release);
              begins.wait(false);
              const auto goes_on = [&] { return after_beat.template operator()<E>(), true; };
              if (terms.is_exact) loop.follow_exactly(terms.end, goes_on);
              else loop.follow(terms.end, goes_on);
              end(loop, own, [this] { return not_over.load(std::memory_order_acquire) == 0; });
            },
            &scheduling);
        not_over.fetch_add(1, std::memory_order_relaxed);  // it waits for `begins`, so it has not ended yet
      });
      idle.until([this](patience&) { return not_ready.load(std::memory_order_acquire) == 0; }, meanwhile);
      loops.for_each([&]<int E>(auto&) { report.template operator()<E>(refusals[E]); });
    } catch (const std::system_error& no_thread) {
      release();
      throw refused(std::string("cca::deployed: no thread for an environment: ") + no_thread.what());
    } catch (...) {
      release();
      throw;
    }
    begin();
  }
  // Also where `between` or a pace throws.
  ~environment_threads() {
    if (std::uncaught_exceptions() > exceptions) first.stop();
    join();
  }
  environment_threads(const environment_threads&) = delete;
  environment_threads& operator=(const environment_threads&) = delete;

private:
  static constexpr auto count = array_size(environment_count<D>);

  void begin() {
    begins = true;
    begins.notify_all();
  }
  void release() {
    first.stop();
    begin();
    join();
  }
  void join() {
    end(first, idle,
        [this] { return std::ranges::all_of(threads, [](polled_thread& t) { return t.has_ended(); }); });
  }

  // The beats of a loop are over.
  template <class Loop, class IsOver>
  void end(Loop& loop, idle_beats& own, IsOver is_over) {
    loop.handle_fault();
    loop.tell_end();
    own.begin(loop.last_active());
    not_over.fetch_sub(1, std::memory_order_release);
    if constexpr (Loop::has_hooks_of_resources || std::is_same_v<Loop, First>)
      own.until([&](patience&) { return is_over(); }, [&] { loop.idle(); });
  }

  First& first;
  idle_beats& idle;
  int exceptions = std::uncaught_exceptions();
  std::atomic<int> not_ready, not_over{1};  // environments; with the first
  std::atomic<bool> begins{false};
  std::array<std::string, count> refusals{};
  std::array<polled_thread, count> threads{};
};

}  // namespace cca::detail
