// The threads of a farm: a lane for each worker, with a channel of tasks to it and one of results back.
//
// Only one thread, that of the loop, hands out and takes back; `hand_out` and `take` never wait. A worker's
// thread looks for a task every `rest`, since waking it would be a system call in a beat. At most Capacity
// tasks of a lane are under way, from being handed out to being taken back, so a worker always finds room for
// its result.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>

#include <cca/skeleton/channel.hpp>

namespace cca::detail {

// Work: worker, task, result, and `static result done(worker&, const task&)`.
template <class Work, std::size_t Count, std::size_t Capacity>
class crew {
public:
  using worker = typename Work::worker;

  // Takes the workers as they are, and starts their threads.
  template <class Workers>
  crew(const Workers& workers, std::chrono::nanoseconds rest) : pause(rest) {
    for (std::size_t i = 0; i < Count; ++i) lanes[i].reset(new lane{workers[i], {}, {}, {}});
    start();
  }
  // Once the other one's tasks are done: the same workers, and the same results to take.
  crew(const crew& other) : pause(other.pause) {
    other.wait();
    for (std::size_t i = 0; i < Count; ++i)
      lanes[i].reset(new lane{other.lanes[i]->by, other.lanes[i]->tasks, other.lanes[i]->results, {}});
    start();
  }
  crew& operator=(const crew&) = delete;
  ~crew() { stop(); }

  // Each worker ends what it is at; the tasks behind that are lost.
  void stop() {
    stops.store(true, std::memory_order_relaxed);
    for (auto& one : lanes)
      if (one && one->runs.joinable()) one->runs.join();
  }

  // From being handed out to being taken back.
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

  // Until all tasks are done. Not in a beat.
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
    } catch (...) {  // the system has no more threads to give
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
