// The events of a set of modes, at which its rules are asked (graph/diagnosis/rule.hpp), the facts that these
// add, and who writes their messages.
#pragma once

#include <array>

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/modes/mode_info.hpp>

namespace cca::detail {

struct rules_of_modes;

// Of a finding: a mode, another one, and an output there.
constexpr int in_mode(const finding& f) { return f.numbers[0]; }
constexpr int other_mode(const finding& f) { return f.numbers[1]; }
constexpr int other_output(const finding& f) { return f.numbers[2]; }
constexpr std::array<int, 3> modes_at_fault(int mode, int other = -1, int output_of_other = -1) {
  return {mode, other, output_of_other};
}

struct writer_of_modes : message_writer {
  // mode `trot`
  constexpr void mode(int number) { say() << "mode `" << modes_in_plan(g).modes[number].name << "`"; }
  constexpr double rate_of(int mode) const { return modes_in_plan(g).modes[mode].plan->hz; }
};

namespace when {

struct of_modes {
  using asked = rules_of_modes;
};

// No item is set, unless it says so.
struct stated_modes : of_modes {};        // []
struct stated_mode : of_modes {};         // [mode]
struct known_rate_of_mode : of_modes {};  // [mode, other_mode]
// Two modes have a component at one path [item of the second, component, mode, other_mode].
struct shared_path : of_modes {};
// A component that not all modes have [item, component, mode, other_mode: has it, lacks it].
struct missing_node : of_modes {};
struct requested_mode : of_modes {};  // by a component [item, name]
// An input on the way to an actuator is fed in two ways
// [item, component, name, mode, other_mode, output, other_output].
struct parting_commands : of_modes {};

}  // namespace when

}  // namespace cca::detail
