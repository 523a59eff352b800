// The threads of the environments behind the first, for one run. They begin together, and end with this.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <latch>
#include <string>
#include <system_error>
#include <thread>

#include <cca/base/refused.hpp>
#include <cca/runtime/environments/environment_loops.hpp>
#include <cca/runtime/environments/realtime.hpp>

namespace cca::detail {

template <class D>
class environment_threads {
public:
  // report.template operator()<E>(text): what the system refused to the thread of environment E; it may
  // throw, then nothing has run.
  template <class Report>
  environment_threads(
      environment_loops<D>& loops, exchange<D>& shared_by_all, std::int64_t end, bool is_exact, Report report)
      : shared(shared_by_all) {
    try {
      loops.for_each_follower([&]<int E>(auto& loop) {
        threads[E] = std::thread([this, &loop, end, is_exact] {
          const thread_setup setup(wish_of_environment<D, E>);
          refusals[E] = setup.refusal();
          ready.count_down();
          begins.wait(false);
          if (is_exact) loop.follow_exactly(end);
          else loop.follow(end);
          loop.handle_fault();
        });
      });
      ready.wait();
      loops.for_each_follower([&]<int E>(auto&) { report.template operator()<E>(refusals[E]); });
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
    if (std::uncaught_exceptions() > exceptions) shared.should_stop = true;
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
    shared.should_stop = true;
    begin();
    join();
  }
  void join() {
    for (auto& t : threads)
      if (t.joinable()) t.join();
  }

  exchange<D>& shared;
  int exceptions = std::uncaught_exceptions();
  std::latch ready{static_cast<std::ptrdiff_t>(count) - 1};
  std::atomic<bool> begins{false};
  std::array<std::string, count> refusals{};
  std::array<std::thread, count> threads{};
};

}  // namespace cca::detail
