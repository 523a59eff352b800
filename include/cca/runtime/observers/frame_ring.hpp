// Frames on their way from the loop to the thread that writes them: one writer, one reader, wait-free. Where
// the ring is full, the loop writes into a frame that nobody reads: it never waits, and its beats have no
// branch for it. All memory is allocated in the constructor.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cca/base/inlining.hpp>

namespace cca::detail {

template <int Words>  // of a frame
class frame_ring {
public:
  // At least so many frames.
  explicit frame_ring(std::size_t least)
      : frames(std::bit_ceil(least)), memory(((frames + 1) * Words + 7) / 8) {
    find_room();
  }

  // ---- the loop's ----

  CCA_INLINE std::int64_t* frame() const noexcept { return at; }
  // The frame is complete. False: the next one will be lost, unless find_room() finds room after all.
  CCA_INLINE bool commit() noexcept {
    if (--left <= 0) [[unlikely]]
      return commit_last();
    at += Words;
    put.store(put.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    return true;
  }
  bool find_room() noexcept {
    const std::uint64_t written = put.load(std::memory_order_relaxed);
    const std::uint64_t room = frames - (written - taken.load(std::memory_order_acquire));
    const std::uint64_t index = written & (frames - 1);
    is_kept = room > 0;
    at = begin + (is_kept ? index : frames) * Words;
    left = static_cast<std::int64_t>(is_kept ? std::min(room, frames - index) : 1);
    return is_kept;
  }

  // ---- the reader's ----

  // The oldest frame that has not been taken; null: none.
  const std::int64_t* oldest() const noexcept {
    const std::uint64_t n = taken.load(std::memory_order_relaxed);
    return n == put.load(std::memory_order_acquire) ? nullptr : begin + (n & (frames - 1)) * Words;
  }
  bool is_almost_full() const noexcept {
    return put.load(std::memory_order_acquire) - taken.load(std::memory_order_relaxed) > frames - frames / 4;
  }
  void take() noexcept { taken.store(taken.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

private:
  [[gnu::noinline]] bool commit_last() noexcept {
    if (is_kept) put.store(put.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    return find_room();
  }

  struct alignas(64) cache_line {
    std::int64_t words[8];
  };

  std::uint64_t frames;
  std::vector<cache_line> memory;  // written once, so that no beat is the first to touch a page
  std::int64_t* begin = reinterpret_cast<std::int64_t*>(memory.data());
  alignas(64) std::int64_t* at = nullptr;
  std::int64_t left = 0;  // frames up to the end of the room or of the memory, this one included
  bool is_kept = false;   // this one
  alignas(64) std::atomic<std::uint64_t> put{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
};

}  // namespace cca::detail
