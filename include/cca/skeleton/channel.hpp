// A bounded channel from one thread to one other, without locks: a ring with a counter at each end, which
// only that end's thread increments.
//
// The reader calls `empty()` first; the answer "not empty" stays true until the reader pops. The writer must
// know, from `writes()` and `reads()`, that fewer than Capacity values are in the channel. Neither ever
// waits.
// Source: Lamport, "Specifying concurrent program modules", ACM TOPLAS 5(2), 1983, the ring of one producer
// and one consumer; here with acquire and release, so that the reader sees all that the writer did before it
// pushed.
// Cost: one atomic load and one atomic store.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <cca/base/compiler.hpp>

namespace cca::detail {

template <class Value, std::size_t Capacity>
class channel {
public:
  channel() = default;
  // Only while neither thread uses `other`.
  channel(const channel& other)
      : written(other.written.load()), taken(other.taken.load()), ring(other.ring) {}
  channel& operator=(const channel&) = delete;

  // For the writer.
  void push(const Value& value) {
    const auto at = written.load(std::memory_order_relaxed);
    ring[at % Capacity] = value;
    written.store(at + 1, std::memory_order_release);
  }

  // For the reader. `front` stays valid until `pop`.
  bool empty() const {
    return taken.load(std::memory_order_relaxed) == written.load(std::memory_order_acquire);
  }
  const Value& front() const { return ring[taken.load(std::memory_order_relaxed) % Capacity]; }
  void pop() { taken.store(taken.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  // How many since the beginning.
  std::uint64_t writes() const { return written.load(std::memory_order_acquire); }
  std::uint64_t reads() const { return taken.load(std::memory_order_acquire); }

private:
  // On cache lines of their own: otherwise the two threads would slow each other down.
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
  alignas(64) std::array<Value, Capacity> ring{};
};

}  // namespace cca::detail
