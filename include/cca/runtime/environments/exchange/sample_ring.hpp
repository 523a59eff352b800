// The last samples of an output, for readers in other environments: wait-free, with one writer. The writer
// goes on filling the ring; a reader that is too slow finds that the oldest are lost.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>

namespace cca::detail {

// In a wall-clock run each word is atomic, and the number of a slot says which sample it has: one that is
// being overwritten is seen as such. In a fast run the writer waits for its readers, so nobody
// overwrites what somebody reads, and coordinates are copied as a block. A process that dies while it writes
// leaves no broken sample, and no lock.
//
// `Marks`: a reader may ask whether a sample is one that was repeated.
template <bool Marks>
struct repeat_mark {
  void mark(bool) noexcept {}
};
template <>
struct repeat_mark<true> {
  std::atomic<bool> is_repeated{false};
  void mark(bool repeated) noexcept { is_repeated.store(repeated, std::memory_order_release); }
};

template <int Size, int Capacity, bool Marks = false>
class alignas(64) sample_ring {
  static_assert(std::has_single_bit(static_cast<unsigned>(Capacity)));
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  static_assert(std::atomic_ref<double>::is_always_lock_free);
  using vector_type = Eigen::Matrix<double, Size, 1>;

public:
  struct sample {
    std::int64_t published_in = -1, origin = 0;  // beat, ns
    vector_type vector;
    bool is_repeated = false;
  };

  // The writer's. `is_exact`: in a fast run. Returns the number of the sample.
  template <class Vector>
  std::uint64_t put(const Vector& v,
                    std::int64_t origin,
                    std::int64_t k,
                    bool is_exact = false,
                    bool is_repeated = false) noexcept {
    const std::uint64_t number = count.load(std::memory_order_relaxed);
    slot& s = slots[index(number)];
    s.state.store(2 * number + 1, std::memory_order_relaxed);
    s.published_in.store(k, std::memory_order_release);
    s.origin.store(origin, std::memory_order_release);
    s.mark(is_repeated);
    if (is_exact) Eigen::Map<vector_type>(s.coordinates.data()) = v;
    else
      for (int c = 0; c < Size; ++c) s.coordinate(c).store(double(v[c]), std::memory_order_release);
    s.state.store(2 * number + 2, std::memory_order_release);
    count.store(number + 1, std::memory_order_release);
    return number;
  }

  // ---- a reader's ----
  //
  // No writer holds it up: it tries again where samples are lost or overwritten while it reads, but at most
  // `most_attempts` times. Then it gives up, which is as if no further sample had come: its input keeps what
  // it has, and the next call begins with the oldest sample that was left.

  static constexpr int capacity = Capacity, most_attempts = 8;

  // Sample number `next`, or the oldest that is left where that is lost, if it was published before beat `k`.
  // False: there is none, or it has given up. `to` has the members of `sample`.
  template <class Sample>
  bool take(std::uint64_t& next, std::int64_t k, Sample& to) const noexcept {
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      slot& s = slots[index(next)];
      std::uint64_t state = s.state.load(std::memory_order_acquire);
      if (state < 2 * next + 2) return false;
      if (state == 2 * next + 2) {
        to.published_in = s.published_in.load(std::memory_order_acquire);
        to.origin = s.origin.load(std::memory_order_acquire);
        if constexpr (Marks) to.is_repeated = s.is_repeated.load(std::memory_order_acquire);
        for (int c = 0; c < Size; ++c) to.vector[c] = s.coordinate(c).load(std::memory_order_acquire);
        state = s.state.load(std::memory_order_relaxed);
        if (state == 2 * next + 2) {
          if (to.published_in >= k) return false;
          return ++next, true;
        }
      }
      next = oldest_left(state);
    }
    return false;
  }

  // ---- a reader's, in a fast run ----

  // One more than the number of the newest sample published before beat `k`; searches from `from` on. The
  // writer may overwrite older samples meanwhile. `from`: there is none, or it has given up.
  std::uint64_t end_before(const std::uint64_t from, std::int64_t k) const noexcept {
    std::uint64_t next = from;
    for (int attempt = 0; attempt < most_attempts;) {
      const slot& s = slots[index(next)];
      std::uint64_t state = s.state.load(std::memory_order_acquire);
      if (state < 2 * next + 2) return next;
      if (state == 2 * next + 2) {
        const std::int64_t published_in = s.published_in.load(std::memory_order_acquire);
        state = s.state.load(std::memory_order_relaxed);
        if (state == 2 * next + 2) {
          if (published_in >= k) return next;
          ++next;
          if (published_in == k - 1) return next;  // a component publishes at most once in a beat
          continue;
        }
      }
      next = oldest_left(state);
      ++attempt;
    }
    return from;
  }
  // f(coordinates, origin, beat) sees sample number `n` where the writer left it. It must be one of the last
  // before `end_before`, as many as the largest delay and one more: those the writer leaves alone.
  template <class F>
  void show(std::uint64_t n, F f) const noexcept {
    const slot& s = slots[index(n)];
    f(Eigen::Map<const vector_type>(s.coordinates.data()), s.origin.load(std::memory_order_relaxed),
      s.published_in.load(std::memory_order_relaxed));
  }
  // Whether sample number `next`, or one after it, was published in beat `k` or later. All that the reader
  // needs is in the ring then, and it fetches nothing else from the writer's core.
  bool has(std::uint64_t next, std::int64_t k) const noexcept {
    for (const std::uint64_t end = next + Capacity; next < end; ++next) {
      const slot& s = slots[index(next)];
      if (s.state.load(std::memory_order_acquire) != 2 * next + 2) return false;
      if (s.published_in.load(std::memory_order_acquire) >= k) return true;
    }
    return false;
  }

  // The writer's: its last sample once more, as of beat k, unless it is of that beat, or was published before
  // beat `since`.
  void repeat(std::int64_t k, std::int64_t since = std::numeric_limits<std::int64_t>::min()) noexcept {
    const std::uint64_t number = count.load(std::memory_order_relaxed);
    if (number == 0) return;
    sample last;
    std::uint64_t newest = number - 1;
    if (take(newest, k, last) && last.published_in >= since) put(last.vector, last.origin, k, false, true);
  }

private:
  static std::size_t index(std::uint64_t number) {
    return static_cast<std::size_t>(number) & (array_size(Capacity) - 1);
  }
  // The oldest sample that is surely not being written, seen from a slot that has a newer one. The slot alone
  // does not tell how far the writer is; its count is on a cache line that readers fetch only here.
  std::uint64_t oldest_left(std::uint64_t state) const noexcept {
    return std::max(count.load(std::memory_order_acquire), state / 2) - Capacity + 2;
  }
  // On a line of its own: small samples need one transfer between two cores.
  struct alignas(64) slot : repeat_mark<Marks> {
    std::atomic<std::uint64_t> state{0};  // 2 n + 2: it has sample n; 2 n + 1: that is being written
    std::atomic<std::int64_t> published_in{0}, origin{0};
    std::array<double, array_size(Size)> coordinates{};

    std::atomic_ref<double> coordinate(int c) { return std::atomic_ref<double>(coordinates[array_size(c)]); }
  };

  mutable std::array<slot, array_size(Capacity)> slots{};  // an atomic_ref needs a number that may change
  std::atomic<std::uint64_t> count{0};
};

}  // namespace cca::detail
