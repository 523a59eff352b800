// The conditions under which a step of a plan may begin (sequence.hpp): each is a type with `holds(heard)`.
//
//   heard.value<"path", axis>()   the observed number; NaN for an unknown path
//   heard.beats()                 since the running step began
//
// NaN fulfils no comparison.
#pragma once

#include <cstdint>

#include <cca/base/fixed_string.hpp>

namespace cca {

template <fixed_string Path, auto State, int Axis = 0>
struct is {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path, Axis>() == static_cast<double>(State);
  }
};
template <fixed_string Path, double Bound>
struct below {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() < Bound;
  }
};
template <fixed_string Path, double Bound>
struct above {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() > Bound;
  }
};
template <std::int64_t Beats>
struct after {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.beats() >= Beats;
  }
};
template <class... Conditions>
struct all {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) && ...);
  }
};
template <class... Conditions>
struct any {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) || ...);
  }
};
template <class Condition>
struct no {
  template <class Heard>
  static bool holds(const Heard& heard) {
    return !Condition::holds(heard);
  }
};

}  // namespace cca
