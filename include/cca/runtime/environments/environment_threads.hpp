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
#include <string>
#include <system_error>

#include <cca/base/separate/function_ref.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/environments/loop/environment_loops.hpp>
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
    report(E, wish_of_environment<D, E>.is_needed, refusal);
  }
  void report(int environment, bool is_needed, const std::string& refusal) {
    if (refusal.empty()) return;
    const std::string text = "cca::deployed: environment `" +
                             std::string(name_of_environment<D>(array_size(environment))) +
                             "` does not run in real time: " + refusal;
    if (is_needed) throw refused(text);
    bool& told = is_told[array_size(environment)];
    if (!told) std::cerr << text << '\n';
    told = true;
  }

private:
  std::array<bool, array_size(environment_count<D>)> is_told{};
};

// What the thread of an environment does between two of its beats; false: the run ends.
struct asked_after_beat {
  function_ref<bool()> ask{};  // none: nothing
  bool operator()() const { return !ask || ask(); }
};

// It takes functions by reference, so that the loops of the other environments are compiled once, and not for
// each pace and each `between` of a run.
template <class D>
class environment_threads {
public:
  // `first`: the environment that runs in the thread which makes this. Each thread is scheduled as
  // `scheduling` says: it must not inherit the priority and the core of this thread. `meanwhile()`: once a
  // period while no beat has begun. `refusals` hears what the system refused to a thread; it may throw, then
  // nothing has run. `after_beat(environment)`, if it is one: in that thread, between two beats.
  environment_threads(environment_loops<D>& all,
                      int first,
                      const environments_here<D>& here,
                      const terms_of_run& terms,
                      idle_beats& while_waiting,
                      const scheduling_of_caller& scheduling,
                      real_time_refusals<D>& refusals,
                      function_ref<void()> meanwhile,
                      function_ref<void(int)> after_beat)
      : loops(all),
        first_here(first),
        idle(while_waiting),
        not_ready(static_cast<int>(std::ranges::count(here, true)) - 1) {
    try {
      loops.for_each([&]<int E>(auto& loop) {
        if (E == first_here || !here[E]) return;
        threads[E].start(
            [this, &loop, terms, after_beat, own = idle]() mutable {
              const thread_setup setup(wish_of_environment<D, E>);
              refused_to[E] = setup.refusal();
              not_ready.fetch_sub(1, std::memory_order_release);
              begins.wait(false);
              follow<E>(loop, terms, after_beat);
              end(
                  loop, own, false, [this] { return not_over.load(std::memory_order_acquire) == 0; },
                  [after_beat] {
                    if (after_beat) after_beat(E);
                  });
            },
            &scheduling);
        not_over.fetch_add(1, std::memory_order_relaxed);  // it waits for `begins`, so it has not ended yet
      });
      idle.until([this](patience&) { return not_ready.load(std::memory_order_acquire) == 0; }, meanwhile);
      loops.for_each([&]<int E>(auto&) { refusals.template report<E>(refused_to[E]); });
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
    if (std::uncaught_exceptions() > exceptions) stop_first();
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
    stop_first();
    begin();
    join();
  }
  void stop_first() {
    loops.for_each([this]<int E>(auto& loop) {
      if (E == first_here) loop.stop();
    });
  }
  void join() {
    const auto all_have_ended = [this] {
      return std::ranges::all_of(threads, [](polled_thread& t) { return t.has_ended(); });
    };
    loops.for_each([&]<int E>(auto& loop) {
      if (E == first_here) end(loop, idle, true, all_have_ended, [] {});
    });
  }

  template <int E, class Loop>
  static void follow(Loop& loop, const terms_of_run& terms, function_ref<void(int)> after_beat) {
    const auto look = [&] { after_beat(E); };
    const auto goes_on = [&] { return after_beat(E), true; };
    asked_after_beat asked;
    function_ref<void()> meanwhile;
    if (after_beat) asked.ask = goes_on, meanwhile = look;
    if (terms.is_exact) loop.follow_exactly(terms.end, asked, asked);
    else loop.follow(terms.end, asked, meanwhile);
  }

  // The beats of a loop are over. `look`: after each time that it idles.
  template <class Loop>
  void end(
      Loop& loop, idle_beats& own, bool is_first, function_ref<bool()> is_over, function_ref<void()> look) {
    loop.handle_fault();
    loop.tell_end();
    own.begin(loop.last_active());
    not_over.fetch_sub(1, std::memory_order_release);
    if (Loop::has_hooks_of_resources || is_first)
      own.until([&](patience&) { return is_over(); }, [&] { loop.idle(), look(); });
  }

  environment_loops<D>& loops;
  int first_here;
  idle_beats& idle;
  int exceptions = std::uncaught_exceptions();
  std::atomic<int> not_ready, not_over{1};  // environments; with the first
  std::atomic<bool> begins{false};
  std::array<std::string, count> refused_to{};
  std::array<polled_thread, count> threads{};
};

}  // namespace cca::detail
