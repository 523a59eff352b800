// What happens between two beats, on its way from the loop to the thread that writes: one writer, one reader,
// wait-free. An event that does not fit is counted.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace cca::recording::detail {

enum class event_kind : std::uint32_t { state, fault, parameters, mode, part, freely, late, skipped };

struct event {
  event_kind kind{};
  std::int32_t node = -1;
  std::int64_t beat = 0;      // it happened before this one
  std::uint64_t order = 0;    // among the events of all loops
  std::uint64_t payload = 0;  // bytes that follow
};

class event_ring {
public:
  explicit event_ring(std::size_t least_bytes) : memory((least_bytes + 7) / 8 * 8) {}

  bool put(const event& e, std::span<const unsigned char> payload) noexcept {
    const std::uint64_t from = written.load(std::memory_order_relaxed);
    const std::size_t size = rounded(sizeof e + payload.size());
    if (size > memory.size() - (from - taken.load(std::memory_order_acquire))) {
      lost.store(lost.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    event with_size = e;
    with_size.payload = payload.size();
    copy_in(from, &with_size, sizeof with_size);
    copy_in(from + sizeof with_size, payload.data(), payload.size());
    written.store(from + size, std::memory_order_release);
    return true;
  }

  // The oldest; false: there is none.
  bool look(event& e) const noexcept {
    const std::uint64_t from = taken.load(std::memory_order_relaxed);
    if (from == written.load(std::memory_order_acquire)) return false;
    copy_out(from, &e, sizeof e);
    return true;
  }
  // Removes the oldest, of which `look` has told.
  void take(const event& e, std::vector<unsigned char>& payload) {
    const std::uint64_t from = taken.load(std::memory_order_relaxed);
    payload.resize(static_cast<std::size_t>(e.payload));
    copy_out(from + sizeof e, payload.data(), payload.size());
    taken.store(from + rounded(sizeof e + payload.size()), std::memory_order_release);
  }

  std::int64_t lost_events() const noexcept { return lost.load(std::memory_order_relaxed); }

private:
  static std::size_t rounded(std::size_t size) { return (size + 7) / 8 * 8; }
  template <class F>
  void each_part(std::uint64_t from, std::size_t size, F f) const {
    const auto start = static_cast<std::size_t>(from % memory.size());
    const std::size_t first = size < memory.size() - start ? size : memory.size() - start;
    if (first > 0) f(start, std::size_t{0}, first);
    if (size > first) f(std::size_t{0}, first, size - first);
  }
  void copy_in(std::uint64_t to, const void* from, std::size_t size) {
    each_part(to, size, [&](std::size_t at, std::size_t done, std::size_t count) {
      std::memcpy(memory.data() + at, static_cast<const unsigned char*>(from) + done, count);
    });
  }
  void copy_out(std::uint64_t from, void* to, std::size_t size) const {
    each_part(from, size, [&](std::size_t at, std::size_t done, std::size_t count) {
      std::memcpy(static_cast<unsigned char*>(to) + done, memory.data() + at, count);
    });
  }

  std::vector<unsigned char> memory;
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
  std::atomic<std::int64_t> lost{0};
};

}  // namespace cca::recording::detail
