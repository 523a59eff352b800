// The runs of one call that a rank makes, on its threads.
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
  // `run`: a result as bytes. `stops`: asked before and after each run. `wake`: called when a run is over.
  local_runs(std::size_t count,
             unsigned thread_count,
             std::function<std::string(std::size_t)> run_one,
             std::function<bool()> is_to_stop,
             std::function<void()> wake_up)
      : runs(count), run(std::move(run_one)), stops(std::move(is_to_stop)), wake(std::move(wake_up)) {
    try {
      while (threads.size() < thread_count) threads.emplace_back([this] { work(); });
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
  std::size_t idle() {
    const std::lock_guard lock(at_hand);
    return threads.size() - std::min(threads.size(), under_way + queue.size());
  }
  std::size_t thread_count() const { return threads.size(); }
  bool is_stopped() {
    const std::lock_guard lock(at_hand);
    return stopped;
  }

private:
  void drop(std::uint64_t i) { over.push_back({i, finished_run::end::dropped}); }

  void work() {
    std::unique_lock lock(at_hand);
    for (;;) {
      changed.wait(lock, [&] { return ends || !queue.empty(); });
      if (queue.empty()) return;
      const std::uint64_t i = queue.front();
      queue.pop_front();
      ++under_way;
      lock.unlock();
      finished_run one = make(i);
      lock.lock();
      --under_way;
      over.push_back(std::move(one));
      lock.unlock();
      wake();
      lock.lock();
    }
  }
  finished_run make(std::uint64_t i) {
    finished_run one{i, finished_run::end::dropped};
    std::uint64_t to_blame = runs;  // no run
    try {
      if (asks()) return one;
      to_blame = i;
      std::string bytes = run(i);
      to_blame = runs;
      if (asks()) return one;
      return {i, finished_run::end::done, std::move(bytes)};
    } catch (...) {
      const std::lock_guard lock(at_hand);
      if (to_blame != i) over.push_back(one);  // the run itself has not failed
      return {to_blame, finished_run::end::failed, text_of(std::current_exception())};
    }
  }
  bool asks() {
    if (!stops || !stops()) return false;
    const std::lock_guard lock(at_hand);
    return stopped = true;
  }

  const std::size_t runs;
  const std::function<std::string(std::size_t)> run;
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
