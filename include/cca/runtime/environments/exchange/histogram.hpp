// How often which duration occurred, in steps of at most an eighth of it. One thread counts, any thread
// reads.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include <cca/base/array_size.hpp>

namespace cca {

class histogram {
public:
  histogram() = default;
  histogram(const histogram& other) { *this = other; }
  histogram& operator=(const histogram& other) {
    for (std::size_t b = 0; b < counts.size(); ++b)
      counts[b] = other.counts[b].load(std::memory_order_relaxed);
    longest = other.longest.load(std::memory_order_relaxed);
    return *this;
  }

  // Nanoseconds; a negative one counts as 0. No lock, no allocation, no instruction that other cores wait
  // for.
  void add(std::int64_t duration) noexcept {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(duration, 0));
    auto& one = counts[std::min(bucket_of(value), counts.size() - 1)];
    one.store(one.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (duration > longest.load(std::memory_order_relaxed))
      longest.store(duration, std::memory_order_relaxed);
  }
  void forget() { *this = histogram(); }

  std::int64_t count() const {
    std::int64_t all = 0;
    for (const auto& one : counts) all += one.load(std::memory_order_relaxed);
    return all;
  }
  // The duration that this part of all does not exceed, rounded up to a step: 0.99 gives p99. 0 if there are
  // none.
  std::int64_t quantile(double part) const {
    const std::int64_t all = count();
    std::int64_t seen = 0;
    for (std::size_t b = 0; b < counts.size() && all > 0; ++b) {
      seen += counts[b].load(std::memory_order_relaxed);
      if (static_cast<double>(seen) >= part * static_cast<double>(all)) return std::min(end_of(b), most());
    }
    return most();
  }
  std::int64_t most() const { return longest.load(std::memory_order_relaxed); }

private:
  // Eight steps for each power of two; below eight one for each number.
  static constexpr std::size_t bucket_of(std::uint64_t value) {
    if (value < 8) return value;
    const auto power = static_cast<std::size_t>(std::bit_width(value)) - 4;
    return 8 * power + static_cast<std::size_t>(value >> power);
  }
  static constexpr std::int64_t end_of(std::size_t bucket) {
    if (bucket < 16) return static_cast<std::int64_t>(bucket);
    const std::size_t power = bucket / 8 - 1;
    return static_cast<std::int64_t>(((bucket - 8 * power + 1) << power) - 1);
  }

  std::array<std::atomic<std::int64_t>, 8 * 38> counts{};  // up to 37 minutes
  std::atomic<std::int64_t> longest{0};
};

}  // namespace cca
