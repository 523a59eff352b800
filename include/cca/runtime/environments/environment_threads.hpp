// The threads of the environments behind the first in this process, for one run. They begin together, and end
// with this.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <latch>
#include <ranges>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/runtime/environments/environment_loops.hpp>
#include <cca/runtime/environments/realtime.hpp>

namespace cca::detail {

template <class D>
class environment_threads {
public:
  // `stop_all()` ends the run, `runs(E)`: in a thread. report.template operator()<E>(text): what the system
  // refused to the thread of environment E; it may throw, then nothing has run. after_beat.template
  // operator()<E>(): in that thread, between two beats.
  template <class Runs, class Report, class AfterBeat>
  environment_threads(environment_loops<D>& loops,
                      std::function<void()> stop_all,
                      Runs runs,
                      std::int64_t end,
                      bool is_exact,
                      Report report,
                      AfterBeat after_beat)
      : stop(std::move(stop_all)),
        ready(std::ranges::count_if(std::views::iota(0, environment_count<D>), runs)) {
    try {
      loops.for_each([&]<int E>(auto& loop) {
        if (!runs(E)) return;
        threads[E] = std::thread([this, &loop, end, is_exact, after_beat] {
          const thread_setup setup(wish_of_environment<D, E>);
          refusals[E] = setup.refusal();
          ready.count_down();
          begins.wait(false);
          const auto goes_on = [&] { return after_beat.template operator()<E>(), true; };
          if (is_exact) loop.follow_exactly(end, goes_on);
          else loop.follow(end, goes_on);
          loop.handle_fault();
        });
      });
      ready.wait();
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
    if (std::uncaught_exceptions() > exceptions) stop();
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
    stop();
    begin();
    join();
  }
  void join() {
    for (auto& t : threads)
      if (t.joinable()) t.join();
  }

  std::function<void()> stop;
  int exceptions = std::uncaught_exceptions();
  std::latch ready;
  std::atomic<bool> begins{false};
  std::array<std::string, count> refusals{};
  std::array<std::thread, count> threads{};
};

}  // namespace cca::detail
