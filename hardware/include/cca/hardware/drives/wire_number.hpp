// Numbers as bytes of a frame, without reading past the payload.
//
// `steps`: a range in so many bits, as unsigned steps from its lower to its upper end.
//   to_step    the nearest step. Half-way between two it is the lower one, so zero in the middle of a range
//              gives the same frame (7FFF, 7FF) as drivers that round down. Beyond the range it is the end,
//              and `cut` says so. The caller must refuse NaN
//   from_step  the number of a step
// Also: little-endian integers and floats of fixed size, and floats from doubles without overflow. All
// constexpr. tests/runtime/hardware/wire_numbers.cpp tests every step of 12 and 16 bits.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace cca::hardware::detail {

constexpr bool is_finite(double x) { return x - x == 0; }

struct steps {
  double lower, upper;
  int bits;

  constexpr double count() const { return static_cast<double>((std::uint32_t{1} << bits) - 1); }
  constexpr double from_step(std::uint32_t step) const {
    return lower + static_cast<double>(step) * ((upper - lower) / count());
  }
  constexpr std::uint32_t to_step(double number, bool& cut) const {
    if (!(number > lower)) {
      cut |= number < lower;
      return 0;
    }
    if (!(number < upper)) {
      cut |= number > upper;
      return (std::uint32_t{1} << bits) - 1;
    }
    // Divided first: the middle of a symmetric range is then half-way exactly, whatever the range.
    const double exact = (number - lower) / (upper - lower) * count();
    const auto below = static_cast<std::uint32_t>(exact);
    return exact - static_cast<double>(below) > 0.5 ? below + 1 : below;
  }
  constexpr bool is_end(std::uint32_t step) const {
    return step == 0 || step == (std::uint32_t{1} << bits) - 1;
  }
};

// The nearest integer within +-(2^(bits-1) - 1): on most buses the most negative one means something else.
constexpr std::int64_t nearest_integer(double number, int bits, bool& cut) {
  const std::int64_t most = (std::int64_t{1} << (bits - 1)) - 1;
  if (!(number < static_cast<double>(most) + 0.5)) return cut = true, most;
  if (!(number > -static_cast<double>(most) - 0.5)) return cut = true, -most;
  return static_cast<std::int64_t>(number < 0 ? number - 0.5 : number + 0.5);
}

// A finite double as a float; beyond the range it is the range's end.
constexpr float to_float(double number, bool& cut) {
  constexpr double most = static_cast<double>(std::numeric_limits<float>::max());
  if (number > most) return cut = true, std::numeric_limits<float>::max();
  if (number < -most) return cut = true, -std::numeric_limits<float>::max();
  return static_cast<float>(number);
}

template <class Unsigned>
constexpr void put(std::span<std::uint8_t> bytes, std::size_t at, Unsigned number) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    if (at + i < bytes.size()) bytes[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
}
constexpr void put_float(std::span<std::uint8_t> bytes, std::size_t at, float number) {
  put(bytes, at, std::bit_cast<std::uint32_t>(number));
}

// Missing bytes count as zero.
template <class Unsigned>
constexpr Unsigned got(std::span<const std::uint8_t> bytes, std::size_t at) {
  Unsigned number = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    if (at + i < bytes.size())
      number = static_cast<Unsigned>(number | static_cast<Unsigned>(Unsigned{bytes[at + i]} << (8 * i)));
  return number;
}
constexpr float got_float(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::bit_cast<float>(got<std::uint32_t>(bytes, at));
}

// What a drive reports; infinity becomes NaN.
constexpr double number_or_nan(double x) {
  return is_finite(x) ? x : std::numeric_limits<double>::quiet_NaN();
}

inline constexpr double radians_in_turn = 6.283185307179586476925286766559;

}  // namespace cca::hardware::detail
