// The first samples on a way to a queue that keeps the first and loses what comes while it is full: for a
// reader that stands still longer than a ring lasts, in a wall-clock run. The ring of the output has the last
// ones, and here are as many of those before them as the queue can hold.
//
// One writer, one reader, wait-free: where it is full the writer drops the sample, which the ring has for a
// while. What was not kept is missing by its number.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>

namespace cca::detail {

template <int Size, int Most>
class alignas(64) first_samples {
public:
  struct sample {
    std::uint64_t number = 0;  // in the ring
    std::int64_t published_in = -1, origin = 0;
    std::array<double, array_size(Size)> coordinates{};

    auto vector() const { return Eigen::Map<const Eigen::Matrix<double, Size, 1>>(coordinates.data()); }
  };

  // The writer's.
  template <class Vector>
  void put(std::uint64_t number, const Vector& v, std::int64_t origin, std::int64_t k) noexcept {
    const std::uint64_t end = written.load(std::memory_order_relaxed);
    if (end - taken.load(std::memory_order_acquire) >= capacity) return;
    sample& to = slots[end % capacity];
    to.number = number;
    to.published_in = k;
    to.origin = origin;
    for (int c = 0; c < Size; ++c) to.coordinates[array_size(c)] = v[c];
    written.store(end + 1, std::memory_order_release);
  }

  // The reader's: the oldest of those from this number on; null: there is none.
  const sample* oldest_from(std::uint64_t number) noexcept {
    std::uint64_t at = taken.load(std::memory_order_relaxed);
    const std::uint64_t end = written.load(std::memory_order_acquire);
    while (at < end && slots[at % capacity].number < number) ++at;
    taken.store(at, std::memory_order_release);
    return at < end ? &slots[at % capacity] : nullptr;
  }

private:
  static constexpr std::uint64_t capacity = std::bit_ceil(static_cast<unsigned>(Most));

  std::array<sample, std::size_t{capacity}> slots{};
  alignas(64) std::atomic<std::uint64_t> written{0};
  alignas(64) std::atomic<std::uint64_t> taken{0};
};

}  // namespace cca::detail
