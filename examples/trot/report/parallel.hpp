#pragma once
// Independent jobs on all cores.
#include <atomic>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace trot {

// Runs job(0) to job(count - 1). Calls done(n), from one thread at a time, when n jobs are finished.
template <class Job, class Done>
void on_all_cores(std::size_t count, Job job, Done done) {
  std::atomic<std::size_t> next = 0;
  std::mutex reporting;
  std::size_t finished = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < count;) {
      job(i);
      const std::lock_guard lock(reporting);
      done(++finished);
    }
  };
  std::vector<std::jthread> others;
  for (unsigned core = 1; core < std::thread::hardware_concurrency(); ++core) others.emplace_back(work);
  work();
}

}  // namespace trot
