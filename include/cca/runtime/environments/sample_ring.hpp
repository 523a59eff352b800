// The last samples of an output, for readers in other environments: wait-free, with one writer. The writer
// goes on filling the ring; a reader that is too slow finds that the oldest are lost.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>

namespace cca::detail {

// Each word is atomic, and the number of a slot says which sample it has: one that is being overwritten is
// seen as such. So a process that dies while it writes leaves no broken sample, and no lock.
template <int Size, int Capacity>
class sample_ring {
  static_assert(std::has_single_bit(static_cast<unsigned>(Capacity)));
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

public:
  struct sample {
    std::int64_t published_in = -1, origin = 0;  // beat, ns
    Eigen::Matrix<double, Size, 1> vector;
  };

  // The writer's.
  template <class Vector>
  void put(const Vector& v, std::int64_t origin, std::int64_t k) noexcept {
    const std::uint64_t number = count.load(std::memory_order_relaxed);
    slot& s = slots[index(number)];
    s.state.store(2 * number + 1, std::memory_order_relaxed);
    s.words[0].store(static_cast<std::uint64_t>(k), std::memory_order_release);
    s.words[1].store(static_cast<std::uint64_t>(origin), std::memory_order_release);
    for (int c = 0; c < Size; ++c)
      s.words[array_size(2 + c)].store(std::bit_cast<std::uint64_t>(double(v[c])), std::memory_order_release);
    s.state.store(2 * number + 2, std::memory_order_release);
    count.store(number + 1, std::memory_order_relaxed);
  }

  // A reader's: sample number `next`, or the oldest that is left where that is lost, if it was published
  // before beat `k`. False: there is none.
  bool take(std::uint64_t& next, std::int64_t k, sample& to) const noexcept {
    for (;;) {
      const slot& s = slots[index(next)];
      const std::uint64_t before = s.state.load(std::memory_order_acquire);
      if (before < 2 * next + 2) return false;
      if (before == 2 * next + 2) {
        to.published_in = static_cast<std::int64_t>(s.words[0].load(std::memory_order_acquire));
        to.origin = static_cast<std::int64_t>(s.words[1].load(std::memory_order_acquire));
        for (int c = 0; c < Size; ++c)
          to.vector[c] = std::bit_cast<double>(s.words[array_size(2 + c)].load(std::memory_order_acquire));
        if (s.state.load(std::memory_order_relaxed) == before) {
          if (to.published_in >= k) return false;
          return ++next, true;
        }
      }
      next = before / 2 - Capacity + 2;  // the oldest that is surely not being written
    }
  }

  // The writer's: its last sample once more, as of beat k, unless it is of that beat.
  void repeat(std::int64_t k) noexcept {
    const std::uint64_t number = count.load(std::memory_order_relaxed);
    if (number == 0) return;
    sample last;
    std::uint64_t newest = number - 1;
    if (take(newest, k, last)) put(last.vector, last.origin, k);
  }

private:
  static std::size_t index(std::uint64_t number) {
    return static_cast<std::size_t>(number) & (array_size(Capacity) - 1);
  }
  struct slot {
    std::atomic<std::uint64_t> state{0};  // 2 n + 2: it has sample n; 2 n + 1: that is being written
    std::array<std::atomic<std::uint64_t>, array_size(Size + 2)> words{};
  };

  std::array<slot, array_size(Capacity)> slots{};
  std::atomic<std::uint64_t> count{0};
};

}  // namespace cca::detail
