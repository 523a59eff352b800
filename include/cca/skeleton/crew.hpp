// The threads of a farm. Each worker has a lane: its thread, a channel of tasks to it and a channel of
// results back.
//
// Only the loop's thread calls `hand_out` and `take`; they never wait. A worker's thread looks for a task
// every `rest`, since waking it would be a system call in a beat. At most Capacity tasks of a lane are under
// way (from hand_out to take), so a worker always finds room for its result.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>

#include <cca/skeleton/channel.hpp>

namespace cca::detail {

// Work names the types worker, task and result, and has `static result done(worker&, const task&)`.
template <class Work, std::size_t Count, std::size_t Capacity>
class crew {
public:
  using worker = typename Work::worker;

  // Copies the workers and starts their threads.
  template <class Workers>
  crew(const Workers& workers, std::chrono::nanoseconds rest) : pause(rest) {
    for (std::size_t i = 0; i < Count; ++i) lanes[i].reset(new lane{workers[i], {}, {}, {}});
    start();
  }
  // Waits until the tasks of `other` are done, then copies its workers and the results still to be taken.
  crew(const crew& other) : pause(other.pause) {
    other.wait();
    for (std::size_t i = 0; i < Count; ++i)
      lanes[i].reset(new lane{other.lanes[i]->by, other.lanes[i]->tasks, other.lanes[i]->results, {}});
    start();
  }
  crew& operator=(const crew&) = delete;
  ~crew() { stop(); }

  // Each worker finishes its current task; the tasks after it are lost.
  void stop() {
    stops.store(true, std::memory_order_relaxed);
    for (auto& one : lanes)
      if (one && one->runs.joinable()) one->runs.join();
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
      while (lanes[i]->results.writes() != lanes[i]->tasks.writes()) std::this_thread::sleep_for(pause);
  }
  // After `stop` or `wait`.
  const worker& at(std::size_t i) const { return lanes[i]->by; }

private:
  struct lane {
    worker by;
    channel<typename Work::task, Capacity> tasks;
    channel<typename Work::result, Capacity> results;
    std::thread runs;
  };

  void start() {
    try {
      for (auto& one : lanes) one->runs = std::thread([this, &l = *one] { work(l); });
    } catch (...) {  // the system has no more threads
      stop();
      throw;
    }
  }
  void work(lane& l) {
    while (!stops.load(std::memory_order_relaxed)) {
      if (l.tasks.empty()) {
        std::this_thread::sleep_for(pause);
        continue;
      }
      const auto task = l.tasks.front();
      l.tasks.pop();
      l.results.push(Work::done(l.by, task));
    }
  }

  std::chrono::nanoseconds pause;
  std::atomic<bool> stops{false};
  std::unique_ptr<lane> lanes[Count];
};

}  // namespace cca::detail
