// What a component has to say after a run, for people. Both members are optional; programs ask for them
// between two beats, never in one, so they may allocate:
//
//   cca::cause cause() const
//       why it has stopped the robot, or made another component fault: which drive, joint or input, with the
//       number, and what to change; empty: it has not
//   std::string summary() const
//       what it has limited, cut or not reached since the start, in one line; empty: nothing of the kind
//
// In a beat a component only counts, in the branch in which it limits. cca/main/end_of_run.hpp collects
// both of a whole controller; cca::robot_main prints them. docs/programs.md.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace cca {

struct cause {
  std::string what{};      // a sentence without a point at its end; empty: nothing
  std::int64_t beat = -1;  // in which it began

  explicit operator bool() const { return !what.empty(); }
};

namespace detail {

template <class C> concept HasCause = requires(const C& c) {
  { c.cause() } -> std::same_as<cca::cause>;
};
template <class C> concept HasSummary = requires(const C& c) {
  { c.summary() } -> std::same_as<std::string>;
};

// As printf.
template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace detail
}  // namespace cca
