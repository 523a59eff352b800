// What a learned policy expects and promises, as a type: the contract that `cca-policy import` writes.
//
//   struct joint_pos {                                 a term of the observation
//     static constexpr std::string_view name = "joint_pos", is = "joint_angles";
//     static constexpr std::array<cca::policy_number, 2> numbers{{{"hip", 0.1}, {"knee", -1.5}}};
//     static constexpr cca::policy_range clip{-100, 100};
//   };
//   struct contract {
//     static constexpr std::string_view name = "walk";
//     static constexpr double rate = 50;               Hz
//     using number = float;                            of the network
//     using network = walk::network;
//     using terms = cca::policy_terms<gyro, joint_pos, last>;          as the network sees them
//     using action = walk::action;
//     static constexpr int history = 5;                observations that the network sees, the newest among them
//     static constexpr cca::history_layout layout = cca::history_layout::by_term;
//     static constexpr cca::history_order order = cca::history_order::oldest_first;
//     static constexpr cca::history_start start = cca::history_start::repeated;
//     static constexpr double oldest = 0.1;            s; an older observation is `stale`
//     static constexpr std::array<cca::policy_gains, 2> gains{{{"hip", 25, 0.5}, {"knee", 25, 0.5}}};
//     static constexpr std::array<std::string_view, 3> lines{...};     what the file of the weights repeats
//   };
//
// A term's number is  clip(sign (q - rest)) scale,  or  clip(sign (q - rest) scale)  if `clips_scaled`. The
// target of a joint is  rest + sign scale a,  within `clip` (of a before) and `target_clip`.
// Names are those of the robot's axes and coordinates; imported_policy.hpp finds them in its spaces.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace cca {

struct policy_number {
  std::string_view name;
  double rest = 0, scale = 1;
  int sign = 1;  // -1: the policy counts the other way round than the robot
};

struct policy_range {
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
};

struct policy_gains {
  std::string_view name;
  double stiffness, damping;  // N m/rad, N m s/rad
};

template <class... Terms>
struct policy_terms {};

// How the observations of several beats stand in the network's input: all of one term side by side, or all
// terms of one beat.
enum class history_layout : std::uint8_t { by_term, by_time };
enum class history_order : std::uint8_t { oldest_first, newest_first };
// Before the first observation: copies of it, or zeros.
enum class history_start : std::uint8_t { repeated, zero };

namespace detail {

inline constexpr std::string_view last_action = "last_action";  // what such a term `is`; it has no port

template <class Term>
inline constexpr bool observes_action = Term::is == last_action;
template <class Term>
inline constexpr int size_of_term = static_cast<int>(Term::numbers.size());

template <class... Terms>
constexpr int numbers_of_terms(policy_terms<Terms...>) {
  return (size_of_term<Terms> + ... + 0);
}

template <class Term>
constexpr policy_range clip_of() {
  if constexpr (requires { Term::clip.lower; }) return Term::clip;
  else return {};
}
template <class Term>
constexpr policy_range seen_in() {
  if constexpr (requires { Term::seen.lower; }) return Term::seen;
  else return {};
}
template <class Term>
constexpr policy_range target_clip_of() {
  if constexpr (requires { Term::target_clip.lower; }) return Term::target_clip;
  else return {};
}
template <class Term>
constexpr bool clips_scaled() {
  if constexpr (requires { Term::clips_scaled; }) return Term::clips_scaled;
  else return false;
}
constexpr bool bounds(policy_range r) {
  return r.lower > -std::numeric_limits<double>::infinity() ||
         r.upper < std::numeric_limits<double>::infinity();
}

}  // namespace detail
}  // namespace cca
