// One request at a time, from any thread to the loops that it concerns. Neither side waits: who finds it
// taken comes again later, and a loop looks at one atomic number between two beats.
#pragma once

#include <array>
#include <atomic>

#include <cca/base/array_size.hpp>

namespace cca::detail {

template <int Loops>
class live_mailbox {
public:
  using loops = std::array<bool, array_size(Loops)>;

  // Any thread: what the request is about is its own from here on until it posts or gives back. False: it is
  // another's, or a loop has not taken the last request yet.
  bool claim() noexcept {
    bool expected = false;
    return is_in_use.compare_exchange_strong(expected, true, std::memory_order_acquire);
  }
  void give_back() noexcept { is_in_use.store(false, std::memory_order_release); }
  void post(const loops& to) noexcept {
    int count = 0;
    for (const bool one : to) count += one;
    if (count == 0) return give_back();
    missing.store(count, std::memory_order_relaxed);
    for (std::size_t loop = 0; loop < to.size(); ++loop)
      if (to[loop]) is_asked[loop].store(true, std::memory_order_release);
  }
  bool is_empty() const noexcept { return !is_in_use.load(std::memory_order_acquire); }

  // A loop's, between two beats: f(), if a request concerns it. False: it has had no effect yet.
  template <class F>
  void take(int loop, F f) {
    auto& asked = is_asked[array_size(loop)];
    if (!asked.load(std::memory_order_acquire) || !f()) return;
    asked.store(false, std::memory_order_relaxed);
    if (missing.fetch_sub(1, std::memory_order_acq_rel) == 1) give_back();
  }

private:
  std::atomic<bool> is_in_use{false};
  std::atomic<int> missing{0};  // loops that have not taken it
  std::array<std::atomic<bool>, array_size(Loops)> is_asked{};
};

}  // namespace cca::detail
