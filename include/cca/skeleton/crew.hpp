// The threads of a farm. Each worker has a lane: its thread, a channel of tasks to it and a channel of
// results back.
//
// Only the loop's thread calls `hand_out` and `take`; they never wait. A worker's thread looks for a task
// every `rest`, since waking it would be a system call in a beat. At most Capacity tasks of a lane are under
// way (from hand_out to take), so a worker always finds room for its result.
//
// `stop` does not wait either: a worker at rest is back at once, a busy one finishes its task, stops itself
// in its thread, and is back then. Only the destructor and a copy wait for workers.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>

#include <cca/base/system/polled_thread.hpp>
#include <cca/skeleton/channel.hpp>

namespace cca::detail {

// Work names the types worker, task and result, and has `static result done(worker&, const task&)` and
// `static void stopped(worker&)`.
template <class Work, std::size_t Count, std::size_t Capacity>
class crew {
public:
  using worker = typename Work::worker;

  // Copies the workers and starts their threads.
  template <class Workers>
  crew(const Workers& workers, std::chrono::nanoseconds rest) : pause(rest) {
    for (std::size_t i = 0; i < Count; ++i) lanes[i].reset(new lane{workers[i], {}, {}});
    start();
  }
  // Waits until the tasks of `other` are done, then copies its workers and the results still to be taken.
  crew(const crew& other) : pause(other.pause) {
    other.wait();
    for (std::size_t i = 0; i < Count; ++i)
      lanes[i].reset(new lane{other.lanes[i]->by, other.lanes[i]->tasks, other.lanes[i]->results});
    start();
  }
  crew& operator=(const crew&) = delete;
  ~crew() {
    stop();
    while (!has_ended()) std::this_thread::sleep_for(pause);
  }

  // Each worker finishes its current task; the tasks after it are lost. Does not wait.
  void stop() noexcept {
    for (std::size_t i = 0; i < Count; ++i)
      if (lanes[i]) stop(i);
  }
  // True: this has ended it, at rest. False: it was over, or its thread ends it, and calls `stopped`.
  bool stop(std::size_t i) noexcept {
    lane& one = *lanes[i];
    while (one.now != activity::over && one.now != activity::last_task) {
      if (one.is_now(activity::rest, activity::over)) return true;
      one.is_now(activity::task, activity::last_task);
    }
    return false;
  }
  // Since `stop`: its thread does not touch this worker any more.
  bool is_back(std::size_t i) const noexcept { return lanes[i]->now == activity::over; }
  // Nothing is left of the threads.
  bool has_ended() noexcept {
    bool all = true;
    for (auto& one : lanes) all = (!one || one->runs.has_ended()) && all;
    return all;
  }

  // How many tasks are between hand_out and take.
  std::size_t under_way(std::size_t i) const {
    return static_cast<std::size_t>(lanes[i]->tasks.writes() - lanes[i]->results.reads());
  }
  bool room() const {
    for (std::size_t i = 0; i < Count; ++i)
      if (under_way(i) >= Capacity) return false;
    return true;
  }
  void hand_out(std::size_t i, const typename Work::task& task) { lanes[i]->tasks.push(task); }

  bool ready(std::size_t i) const { return !lanes[i]->results.empty(); }
  typename Work::result take(std::size_t i) {
    const auto result = lanes[i]->results.front();
    lanes[i]->results.pop();
    return result;
  }

  // Waits until all tasks are done. Not in a beat.
  void wait() const {
    for (std::size_t i = 0; i < Count; ++i)
      while (lanes[i]->results.writes() != lanes[i]->tasks.writes() || lanes[i]->now == activity::task)
        std::this_thread::sleep_for(pause);
  }
  // Where it is back, or after `wait`.
  const worker& at(std::size_t i) const { return lanes[i]->by; }

  // Another one, which has been stopped before this.
  std::unique_ptr<crew> before{};

private:
  // Of a worker. Its thread begins and ends tasks; the loop's thread ends it at rest, or makes its task the
  // last.
  enum class activity : int { rest, task, last_task, over };

  struct lane {
    worker by;
    channel<typename Work::task, Capacity> tasks;
    channel<typename Work::result, Capacity> results;
    std::atomic<activity> now{activity::rest};
    polled_thread runs{};

    bool is_now(activity was, activity will) noexcept {
      return now.compare_exchange_strong(was, will, std::memory_order_acq_rel);
    }
  };

  void start() {
    try {
      for (auto& one : lanes) one->runs.start([this, &l = *one] { work(l); });
    } catch (...) {  // the system has no more threads
      stop();
      while (!has_ended()) std::this_thread::sleep_for(pause);
      throw;
    }
  }
  void work(lane& l) {
    while (l.now != activity::over) {
      if (l.tasks.empty()) {
        std::this_thread::sleep_for(pause);
        continue;
      }
      if (!l.is_now(activity::rest, activity::task)) return;
      const auto task = l.tasks.front();
      l.tasks.pop();
      l.results.push(Work::done(l.by, task));
      if (l.is_now(activity::task, activity::rest)) continue;
      Work::stopped(l.by);
      l.now.store(activity::over, std::memory_order_release);
    }
  }

  std::chrono::nanoseconds pause;
  std::unique_ptr<lane> lanes[Count];
};

}  // namespace cca::detail
