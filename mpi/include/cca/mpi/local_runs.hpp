// The runs of one call that a rank makes, on its threads. A thread makes up to `at_once` of them at once.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <cca/mpi/packing.hpp>

namespace cca::mpi::detail {

struct finished_run {
  enum class end : std::uint8_t { done, dropped, failed };
  std::uint64_t number = 0;
  end how = end::done;
  std::string bytes{};  // its result, or what went wrong
};

inline std::string text_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const std::exception& e) { return e.what(); } catch (...) {
    return "an exception without a text";
  }
}

class local_runs {
public:
  // What a thread makes its runs by: `next`, `done` and `failed` say how.
  using work = std::function<void(local_runs&)>;

  // `stops`: asked before and after each run. `wake`: called when a run is over.
  local_runs(std::size_t count,
             unsigned thread_count,
             std::size_t at_once_each,
             work on_each_thread,
             std::function<bool()> is_to_stop,
             std::function<void()> wake_up)
      : runs(count),
        at_once(at_once_each),
        make(std::move(on_each_thread)),
        stops(std::move(is_to_stop)),
        wake(std::move(wake_up)) {
    try {
      while (threads.size() < thread_count) threads.emplace_back([this] { make(*this); });
    } catch (const std::system_error&) {
      if (threads.empty()) throw;  // those that there are go on
    }
  }
  ~local_runs() {
    cease();
    {
      const std::lock_guard lock(at_hand);
      ends = true;
    }
    changed.notify_all();
  }
  local_runs(const local_runs&) = delete;
  local_runs& operator=(const local_runs&) = delete;

  void add(const std::vector<std::uint64_t>& numbers) {
    {
      const std::lock_guard lock(at_hand);
      for (const std::uint64_t i : numbers) ceased ? drop(i) : queue.push_back(i);
    }
    changed.notify_all();
  }
  // No further run begins: those that wait are dropped.
  void cease() {
    const std::lock_guard lock(at_hand);
    ceased = true;
    for (const std::uint64_t i : queue) drop(i);
    queue.clear();
  }
  std::vector<finished_run> take_finished() {
    const std::lock_guard lock(at_hand);
    return std::exchange(over, {});
  }
  // How many runs could begin now.
  std::size_t idle() {
    const std::lock_guard lock(at_hand);
    const std::size_t places = threads.size() * at_once;
    return places - std::min(places, under_way + queue.size());
  }
  std::size_t thread_count() const { return threads.size(); }
  bool is_stopped() {
    const std::lock_guard lock(at_hand);
    return stopped;
  }

  // ---- on a thread that makes runs ----

  // The number of a run that begins now, or none. `is_idle`: the thread has no run under way, so this waits
  // for one, and none is its end.
  std::optional<std::size_t> next(bool is_idle) {
    for (;;) {
      std::uint64_t i = 0;
      {
        std::unique_lock lock(at_hand);
        if (is_idle) changed.wait(lock, [&] { return ends || !queue.empty(); });
        if (queue.empty()) return {};
        i = queue.front();
        queue.pop_front();
        ++under_way;
      }
      if (!is_cut_short(i)) return i;
    }
  }
  void done(std::size_t i, std::string result) {
    if (!is_cut_short(i)) end({i, finished_run::end::done, std::move(result)});
  }
  // Within the handler of what the run has thrown.
  void failed(std::size_t i) { end({i, finished_run::end::failed, text_of(std::current_exception())}); }

private:
  void drop(std::uint64_t i) { over.push_back({i, finished_run::end::dropped}); }

  // The run ends here if all are to stop, or if that could not be asked: then it is not the run that failed.
  bool is_cut_short(std::uint64_t i) {
    std::optional<std::string> wrong;
    try {
      if (!asks()) return false;
    } catch (...) { wrong = text_of(std::current_exception()); }
    if (wrong) {
      const std::lock_guard lock(at_hand);
      over.push_back({runs, finished_run::end::failed, *wrong});
    }
    end({i, finished_run::end::dropped});
    return true;
  }
  void end(finished_run one) {
    {
      const std::lock_guard lock(at_hand);
      --under_way;
      over.push_back(std::move(one));
    }
    wake();
  }
  bool asks() {
    if (!stops || !stops()) return false;
    const std::lock_guard lock(at_hand);
    return stopped = true;
  }

  const std::size_t runs, at_once;
  const work make;
  const std::function<bool()> stops;
  const std::function<void()> wake;
  std::mutex at_hand;
  std::condition_variable changed;
  std::deque<std::uint64_t> queue;
  std::vector<finished_run> over;
  std::size_t under_way = 0;
  bool ceased = false, stopped = false, ends = false;
  std::vector<std::jthread> threads;  // the last: they end before the rest is gone
};

}  // namespace cca::mpi::detail
