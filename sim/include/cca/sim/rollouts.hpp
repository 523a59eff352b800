// Many independent runs on all cores: of other seeds, parameters, grounds, whatever differs.
//
//   const std::vector<double> distances = cca::sim::rollouts(100, [&](std::size_t i) {
//     auto c = start;                    // a controller with its world is a value
//     c.template get<"robot.simulator">().put_down(world_of(i));
//     c.start();
//     c.run(cca::for_<20>{});
//     return distance(c);
//   });
//
// What run(i) has returned stands at i: a value that can be moved. A run that depends on nothing but `i`, and
// on what no run changes, gives the same bits on any number of threads.
//
// run(i) may also return a run that goes in steps (in_steps.hpp); its result stands at i then. A thread makes
// several of them at once, their worlds side by side in the lanes of a vector.
//
// Errors: an exception of a run, or of what the settings have, ends all: no further run begins, those under
// way end, and it is thrown to the caller. If several runs fail, it is the exception of the lowest number.
#pragma once

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/sim/rollouts/in_steps.hpp>

namespace cca::sim {

struct rollout_settings {
  unsigned threads = 0;  // 0: one for each core; where the system refuses one, those that there are go on
  std::function<void(std::size_t)> over{};  // told how many runs are over, from one thread at a time
  std::function<bool()> stops{};            // asked by all threads at once; once true, no further run begins
};

namespace detail {

template <class Run> concept ReturnsValue = std::is_invocable_v<Run&, std::size_t> &&
                                            keeps_result<std::invoke_result_t<Run&, std::size_t>> &&
                                            std::is_object_v<std::invoke_result_t<Run&, std::size_t>> &&
                                            !std::is_const_v<std::invoke_result_t<Run&, std::size_t>>;
// Looks like a run in steps, but a part is missing or returns something else.
template <class Run> concept ReturnsHalfRun = std::is_invocable_v<Run&, std::size_t> &&
                                              LooksLikeRunInSteps<std::invoke_result_t<Run&, std::size_t>> &&
                                              !RunInSteps<std::invoke_result_t<Run&, std::size_t>>;
template <class Run> concept ReturnsRunInSteps =
    std::is_invocable_v<Run&, std::size_t> && RunInSteps<std::invoke_result_t<Run&, std::size_t>>;
template <class Run> concept MakesRollouts = ReturnsValue<Run> && !ReturnsHalfRun<Run>;

// A message for what can not be a run.
template <class Run>
constexpr void check_run() {
  if constexpr (ReturnsHalfRun<Run>)
    static_assert(!ReturnsHalfRun<Run>,
                  "cca::sim::rollouts: what a run returns looks like a run in steps, but is none: one has "
                  "`bool step()`, `result()`, and `world()`, which returns a reference that is not const");
  else if constexpr (ReturnsRunInSteps<Run>)
    static_assert(ReturnsValue<Run>,
                  "cca::sim::rollouts: the `result()` of a run in steps returns what is to be kept of it: a "
                  "value that can be moved");
  else
    static_assert(ReturnsValue<Run>,
                  "cca::sim::rollouts: a run takes its number, and returns what is to be kept of it: a value "
                  "that can be moved");
}

// The runs of one call that no thread has taken yet, and the first that failed.
class shared_rollouts {
public:
  shared_rollouts(std::size_t runs, const rollout_settings& settings) : count(runs), s(settings) {}

  // The runs that a thread makes, up to `at_once` at once. `keep(i, result)`.
  template <class Run, class Keep>
  void work(Run& run, std::size_t at_once, const Keep& keep) {
    make_runs(
        run, at_once, [this](bool) { return taken(); },
        [&](std::size_t i, auto&& result) {
          keep(i, std::forward<decltype(result)>(result));
          tell();
        },
        [this](std::size_t i) { failed(i); });
  }
  // It is to stop: no further run begins. What a run returns that is cut short is not kept.
  bool is_stopped() {
    if (!has_stopped && s.stops && s.stops()) has_stopped = true;
    return has_stopped;
  }
  void rethrow() const {
    if (error) std::rethrow_exception(error);
  }

private:
  std::optional<std::size_t> taken() {
    if (has_failed || next >= count) return {};
    try {
      if (is_stopped()) return {};
    } catch (...) {
      failed(count);
      return {};
    }
    const std::size_t i = next++;
    return i < count ? std::optional(i) : std::nullopt;
  }
  void tell() {
    if (!s.over) return;
    const std::lock_guard lock(telling);
    s.over(++finished);
  }
  void failed(std::size_t i) {
    const std::lock_guard lock(telling);
    if (!error || i < failed_at) error = std::current_exception(), failed_at = i;
    has_failed = true;
  }

  const std::size_t count;
  const rollout_settings& s;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false, has_stopped = false;
  std::mutex telling;
  std::size_t finished = 0, failed_at = 0;
  std::exception_ptr error;
};

// False: the system has no thread left.
template <class Work>
bool begins(std::vector<std::jthread>& threads, const Work& work) {
  try {
    threads.emplace_back(work);
    return true;
  } catch (const std::system_error&) { return false; }
}

}  // namespace detail

// run(0) to run(count - 1), each once, `threads` at a time, this one among them. Returns their results,
// that of run(i) at i. Once `settings.stops`, only the results before the first run that has not ended are
// returned, so the vector is shorter.
template <class Run>
auto rollouts(std::size_t count, Run run, const rollout_settings& settings = {}) {
  if constexpr (!detail::MakesRollouts<Run>) {
    detail::check_run<Run>();
  } else {
    using result = typename detail::result_of_run<std::invoke_result_t<Run&, std::size_t>>::type;
    std::vector<std::optional<result>> kept(count);
    detail::shared_rollouts all(count, settings);
    const auto keep = [&](std::size_t i, result one) {
      if (!all.is_stopped()) kept[i].emplace(std::move(one));
    };
    {
      const std::size_t cores =
          std::max(settings.threads > 0 ? settings.threads : std::thread::hardware_concurrency(), 1u);
      const std::size_t at_once =
          detail::places_of_thread<std::invoke_result_t<Run&, std::size_t>>(count, cores);
      std::vector<std::jthread> others;
      const auto work = [&] { all.work(run, at_once, keep); };
      for (std::size_t t = 1; t < std::min(cores, count) && detail::begins(others, work);) ++t;
      work();
    }
    all.rethrow();
    std::vector<result> over;
    over.reserve(count);
    for (std::size_t i = 0; i < count && kept[i]; ++i) over.push_back(*std::move(kept[i]));
    return over;
  }
}

}  // namespace cca::sim
