// All samples of an output of a free-running environment since a beat has taken some, for queues in other
// environments, in a wall-clock run. Any number of cycles may pass in a beat, so not all of them are kept:
// the first and the last, of each as many as the longest of these queues holds. For any policy a queue that
// takes these, and counts the others as lost, is then what it would be if it had taken all.
//
// Plain memory, of one slot of the cycles' results (cycle_results.hpp). Cost: twice the longest queue.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>

namespace cca::detail {

template <int Size, int Most>
class gathered_samples {
public:
  struct sample {
    std::uint64_t number = ~std::uint64_t{0};
    std::int64_t origin = 0;
    std::array<double, array_size(Size)> coordinates{};

    auto vector() const { return Eigen::Map<const Eigen::Matrix<double, Size, 1>>(coordinates.data()); }
  };
  static constexpr int most = 2 * Most;  // samples that it keeps

  // The number of the next sample.
  std::uint64_t end() const { return next; }

  template <class Vector>
  void put_numbered(std::uint64_t number, std::int64_t origin, const Vector& v) {
    if (number < next || is_empty()) begin_at(number);
    sample& to =
        number - first_number < Most ? first[index(number - first_number)] : last[index(number % Most)];
    to.number = number;
    to.origin = origin;
    Eigen::Map<Eigen::Matrix<double, Size, 1>>(to.coordinates.data()) = v;
    next = number + 1;
  }
  // f(sample) for those from a number on, in their order.
  template <class F>
  void for_each_from(std::uint64_t from, F f) const {
    for (std::uint64_t n = std::max(from, first_number); n < next; ++n) {
      const bool is_first = n - first_number < Most;
      if (!is_first && next - n > Most) n = next - Most;
      if (const sample& one = is_first ? first[index(n - first_number)] : last[index(n % Most)];
          one.number == n)
        f(one);
    }
  }

  // Becomes what `newer` is; that began with the same number, or has few samples. `is_taken`: of those before
  // `taken` nobody needs one any more.
  void follow(const gathered_samples& newer, bool is_taken, std::uint64_t taken) {
    const std::uint64_t begin = is_taken ? taken : newer.first_number;
    if (first_number != begin || next < begin || next > newer.next) begin_at(begin);
    newer.for_each_from(next,
                        [this](const sample& one) { put_numbered(one.number, one.origin, one.vector()); });
    next = newer.next;
  }

private:
  bool is_empty() const { return next == first_number; }
  void begin_at(std::uint64_t number) { first_number = next = number; }
  static std::size_t index(std::uint64_t n) { return static_cast<std::size_t>(n); }

  std::uint64_t first_number = 0, next = 0;
  std::array<sample, array_size(Most)> first{}, last{};
};

}  // namespace cca::detail
