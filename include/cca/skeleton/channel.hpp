// A bounded channel from one thread to one other one, without locks: a ring whose two ends are counted up,
// each by its own thread.
//
// Who reads asks `empty()` first; the answer stays true until the asking thread acts on it. Who writes knows
// by the counts of what was ever written and read that less than Capacity is in it. Neither ever waits.
// Source: Lamport, "Specifying concurrent program modules", ACM TOPLAS 5(2), 1983, the ring of one producer
// and one consumer; here with acquire and release, so that what a thread did before it wrote is seen by the
// one that reads. Cost: an atomic load and store.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace cca::detail {

template <class Value, std::size_t Capacity>
class channel {
public:
  channel() = default;
  // Only while neither thread uses the other one.
  channel(const channel& other)
      : written(other.written.load()), taken(other.taken.load()), ring(other.ring) {}
  channel& operator=(const channel&) = delete;

  // For the one that writes.
  void push(const Value& value) {
    const auto at = written.load(std::memory_order_relaxed);
    ring[at % Capacity] = value;
    written.store(at + 1, std::memory_order_release);
  }

  // For the one that reads. What `front` shows is there until `pop`.
  bool empty() const {
    return taken.load(std::memory_order_relaxed) == written.load(std::memory_order_acquire);
  }
  const Value& front() const { return ring[taken.load(std::memory_order_relaxed) % Capacity]; }
  void pop() { taken.store(taken.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  // How many ever.
  std::uint64_t writes() const { return written.load(std::memory_order_acquire); }
  std::uint64_t reads() const { return taken.load(std::memory_order_acquire); }

private:
  // Apart from each other, so that the two threads don't share a line of the cache.
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
  alignas(64) std::array<Value, Capacity> ring{};
};

}  // namespace cca::detail
