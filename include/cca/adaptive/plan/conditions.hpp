// The conditions under which a step of a plan may begin (sequence.hpp): each is a type with `holds(heard)`.
//
//   heard.value<"path", axis>()   the observed number; NaN for an unknown path, and before anything is published
//   heard.beats()                 since the running step began
//
// One that asks for a path says so, and the compiler refuses a path that nobody publishes
// (plan.unknown_path):
//
//   static constexpr std::array asked_paths{cca::asked_path{"arm.status.component"}};
//
// NaN fulfils no comparison.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/base/fixed_string.hpp>
#include <cca/component/ports/observation.hpp>

namespace cca {
namespace detail {

// The paths for which conditions ask.
template <class Condition>
inline constexpr std::array<asked_path, 0> paths_asked_by{};
template <class Condition>
  requires requires { Condition::asked_paths.size(); }
inline constexpr auto paths_asked_by<Condition> = Condition::asked_paths;

template <class... Conditions>
constexpr auto all_paths_asked() {
  std::array<asked_path, (std::size_t{0} + ... + paths_asked_by<Conditions>.size())> all{};
  [[maybe_unused]] std::size_t count = 0;
  [[maybe_unused]] const auto add = [&](const auto& some) {
    for (const auto& one : some) all[count++] = one;
  };
  (add(paths_asked_by<Conditions>), ...);
  return all;
}

}  // namespace detail

template <fixed_string Path, auto State, int Axis = 0>
struct is {
  static constexpr std::array asked_paths{asked_path{Path.view(), Axis}};
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path, Axis>() == static_cast<double>(State);
  }
};
// `Bound` is any number: 10 or 0.3.
template <fixed_string Path, auto Bound>
struct below {
  static constexpr std::array asked_paths{asked_path{Path.view()}};
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() < static_cast<double>(Bound);
  }
};
template <fixed_string Path, auto Bound>
struct above {
  static constexpr std::array asked_paths{asked_path{Path.view()}};
  template <class Heard>
  static bool holds(const Heard& heard) {
    return heard.template value<Path>() > static_cast<double>(Bound);
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
  static constexpr auto asked_paths = detail::all_paths_asked<Conditions...>();
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) && ...);
  }
};
template <class... Conditions>
struct any {
  static constexpr auto asked_paths = detail::all_paths_asked<Conditions...>();
  template <class Heard>
  static bool holds(const Heard& heard) {
    return (Conditions::holds(heard) || ...);
  }
};
template <class Condition>
struct no {
  static constexpr auto asked_paths = detail::all_paths_asked<Condition>();
  template <class Heard>
  static bool holds(const Heard& heard) {
    return !Condition::holds(heard);
  }
};

}  // namespace cca
