// Names built at compile time: of numbered nodes and axes ("leg" and 2), and of paths ("dmp" and "phase").
#pragma once

#include <cstddef>

#include <cca/base/fixed_string.hpp>

namespace cca::detail {

template <fixed_string Before, std::size_t Number>
consteval auto numbered_text() {
  constexpr std::size_t digits = Number < 10 ? 1 : Number < 100 ? 2 : Number < 1000 ? 3 : 4;
  char all[sizeof(Before.text) + digits]{};
  std::size_t rest = Number, end = sizeof(all) - 1;
  for (std::size_t i = 0; i < digits; ++i, rest /= 10) all[--end] = static_cast<char>('0' + rest % 10);
  for (std::size_t i = 0; i < end; ++i) all[i] = Before.text[i];
  return fixed_string(all);
}
template <fixed_string Before, fixed_string After>
consteval auto joined_text() {
  char all[sizeof(Before.text) + sizeof(After.text)]{};
  std::size_t end = 0;
  for (const char c : Before.view()) all[end++] = c;
  all[end++] = '.';
  for (const char c : After.view()) all[end++] = c;
  return fixed_string(all);
}

// numbered<"stage", 2> is "stage2"; joined_name<"stage2", "x"> is "stage2.x".
template <fixed_string Before, std::size_t Number>
inline constexpr auto numbered = numbered_text<Before, Number>();
template <fixed_string Before, fixed_string After>
inline constexpr auto joined_name = joined_text<Before, After>();

}  // namespace cca::detail
