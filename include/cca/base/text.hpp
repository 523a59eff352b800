// Builds sentences at compile time.
#pragma once

#include <cca/base/compiler.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace cca::detail {

// A template, so unused messages are not compiled.
template <std::size_t Capacity>
struct text_of {
  std::array<char, Capacity> letters{};
  std::size_t size = 0;

  constexpr std::string_view view() const { return {letters.data(), size}; }

  constexpr void put(char letter) {
    if (size < letters.size()) letters[size++] = letter;
  }
  constexpr text_of& operator<<(std::string_view more) {
    for (const char c : more) put(c);
    return *this;
  }
  constexpr text_of& operator<<(const char* more) { return *this << std::string_view(more); }
  constexpr text_of& operator<<(std::int64_t number) {
    std::array<char, 20> digits{};
    std::size_t n = 0;
    std::uint64_t rest =
        number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
    do digits[n++] = static_cast<char>('0' + rest % 10);
    while ((rest /= 10) != 0);
    if (number < 0) put('-');
    while (n > 0) put(digits[--n]);
    return *this;
  }
  constexpr text_of& operator<<(int number) { return *this << static_cast<std::int64_t>(number); }

  // With up to three decimals.
  constexpr text_of& operator<<(double number) {
    if (number < 0) {
      put('-');
      number = -number;
    }
    const auto thousandths = static_cast<std::int64_t>(number * 1000 + 0.5);
    *this << thousandths / 1000;
    if (const auto rest = thousandths % 1000; rest != 0) {
      *this << ".";
      for (std::int64_t place = 100, left = rest; left != 0; left %= place, place /= 10)
        *this << left / place;
    }
    return *this;
  }
};
struct text : text_of<2048> {};

}  // namespace cca::detail
