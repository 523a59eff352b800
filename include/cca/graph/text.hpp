// Sentences put together at compile time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cca::detail {

struct text {
  std::array<char, 2048> letters{};
  std::size_t size = 0;

  constexpr std::string_view view() const { return {letters.data(), size}; }

  constexpr text& operator<<(std::string_view more) {
    for (const char c : more)
      if (size < letters.size()) letters[size++] = c;
    return *this;
  }
  constexpr text& operator<<(const char* more) { return *this << std::string_view(more); }
  constexpr text& operator<<(std::int64_t number) {
    std::array<char, 20> digits{};
    std::size_t n = 0;
    std::uint64_t rest = number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
    do digits[n++] = static_cast<char>('0' + rest % 10);
    while ((rest /= 10) != 0);
    if (number < 0) *this << "-";
    while (n > 0) *this << std::string_view(&digits[--n], 1);
    return *this;
  }
  constexpr text& operator<<(int number) { return *this << static_cast<std::int64_t>(number); }

  // A rate, with up to three decimals.
  constexpr text& operator<<(double number) {
    const auto thousandths = static_cast<std::int64_t>(number * 1000 + 0.5);
    *this << thousandths / 1000;
    if (const auto rest = thousandths % 1000; rest != 0) {
      *this << ".";
      for (std::int64_t place = 100, left = rest; left != 0; left %= place, place /= 10) *this << left / place;
    }
    return *this;
  }
};

}  // namespace cca::detail
