// The refusal of a number that a world can't have: what it is of, the number, and what it must be.
//
//   need(run >= 0.01, "the run of the steps", run, "m", "at least 0.01 m")
//   "cca::sim: the run of the steps is 0 m: it must be at least 0.01 m"
//
// Throws std::invalid_argument, so it is for where a world is made, not for a beat. `numbered` does the
// same for the number of a box, a part, a sensor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cca::sim {

inline void need(
    bool good, const std::string& what, double value, std::string_view unit, std::string_view must) {
  if (good) return;
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.6g", value);
  throw std::invalid_argument("cca::sim: " + what + " is " + number.data() + (unit.empty() ? "" : " ") +
                              std::string(unit) + ": it must be " + std::string(must));
}

// Out of line: no beat holds what it takes to write the sentence.
[[noreturn, gnu::noinline]] inline void refuse_number(std::size_t i, std::size_t count, const char* of) {
  const std::string has = count == 0 ? "none"
                          : count == 1
                              ? "one, number 0"
                              : std::to_string(count) + ", numbers 0 to " + std::to_string(count - 1);
  throw std::out_of_range("cca::sim: there is no " + std::string(of) + " " + std::to_string(i) +
                          ": this world has " + has);
}

// Throws std::out_of_range for the number of something that isn't there.
inline std::size_t numbered(std::size_t i, std::size_t count, const char* of) {
  if (i >= count) refuse_number(i, count, of);
  return i;
}

}  // namespace cca::sim
