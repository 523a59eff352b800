// Frames on their way from the loop to the thread that writes them: one writer, one reader, wait-free. All
// memory is allocated in the constructor.
//
// Both sides see one cursor, the frame that the loop writes; all up to it can be read. So where the ring is
// full, the loop goes on writing into the frame that it has: it never waits, and its beats have no branch for
// it. The words 1 to `Marks` are `never` in a frame that the loop gets: the reader resets them, not the beat.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cca/base/inlining.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

template <int Words, int Marks>  // of a frame
class frame_ring {
public:
  // For so many frames that have not been taken.
  explicit frame_ring(std::size_t most) : memory((most + 1) * Words / 8) {
    for (std::int64_t* one = begin; one != end; one += Words) forget(one);
  }

  // ---- the loop's ----

  CCA_INLINE std::int64_t* frame() const noexcept { return at.load(std::memory_order_relaxed); }
  // The frame is complete. False: there is no room for another one, so it can't be read yet: call
  // commit_last() later, or drop().
  CCA_INLINE bool commit(std::int64_t* frame) noexcept {
    if (frame + Words == end_of_room) [[unlikely]]
      return commit_last();
    at.store(frame + Words, std::memory_order_release);
    return true;
  }
  // The same where the room known so far ends, or the memory.
  [[gnu::noinline]] bool commit_last() noexcept {
    std::int64_t* const next = after(frame());
    std::int64_t* const oldest = taken.load(std::memory_order_acquire);
    if (next == oldest) return false;
    end_of_room = oldest > next ? oldest : end;
    at.store(next, std::memory_order_release);
    return true;
  }
  // The frame is lost.
  void drop() noexcept { forget(frame()); }

  // ---- the reader's ----

  // The oldest frame that has not been taken; null: none.
  const std::int64_t* oldest() const noexcept {
    std::int64_t* const one = taken.load(std::memory_order_relaxed);
    return one == at.load(std::memory_order_acquire) ? nullptr : one;
  }
  bool is_almost_full() const noexcept {
    const auto untaken = at.load(std::memory_order_acquire) - taken.load(std::memory_order_relaxed);
    const auto all = end - begin - Words;
    return (untaken < 0 ? untaken + (end - begin) : untaken) > all - all / 4;
  }
  void take() noexcept {
    std::int64_t* const one = taken.load(std::memory_order_relaxed);
    forget(one);
    taken.store(after(one), std::memory_order_release);
  }

private:
  static_assert(Words % 8 == 0);
  struct alignas(64) cache_line {
    std::int64_t words[8];
  };

  static void forget(std::int64_t* frame) noexcept { std::fill_n(frame + 1, Marks, never); }
  std::int64_t* after(std::int64_t* frame) const noexcept {
    return frame + Words == end ? begin : frame + Words;
  }

  std::vector<cache_line> memory;  // written once, so that no beat is the first to touch a page
  std::int64_t* begin = reinterpret_cast<std::int64_t*>(memory.data());
  std::int64_t* end = begin + 8 * memory.size();
  alignas(64) std::atomic<std::int64_t*> at{begin};
  std::int64_t* end_of_room = end;  // the loop's
  alignas(64) std::atomic<std::int64_t*> taken{begin};
};

}  // namespace cca::detail
