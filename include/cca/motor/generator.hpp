// A Generator: an adaptive component that oscillates (the source document, chapter 3). It consists of an
// oscillator, a learned periodic shape that follows its phase, and a criterion.
//
//   struct swing : cca::generator<stride, cca::dmp_rhythmic_module<leg_angles, stride, 25>,
//                                 cca::tracking<leg_angles>> {};
//
//   in  "centre"     S                      the centre of the oscillation (the reference of the shape)
//   in  "amplitude"  over<amplitude, Axis>  negative: it comes to rest at the centre
//   in  "phase"      over<phase, Axis>      rad, optional: lead over the oscillator
//   in  "frequency"  over<frequency, Axis>  Hz: of the oscillator and the shape
//   in  "feedback"   S                      the measured value
//   out "command"    S
//   out "ode_status", "module_status", "component_status", "error", and the other ports of the shape
//
// Inputs (input_status.hpp): while "frequency", "phase" or "centre" is NaN or infinite, the pattern publishes
// no new command and "ode_status" is `unreadable`; "frequency" stops the oscillator too, which otherwise goes
// on. While "amplitude" is, the oscillator stands still and the command settles at its phase: only the
// observed status `module.oscillator.status` says so. While "feedback" is, the movement goes on, "error" is
// 1e12 and "component_status" is `diverged`. No fault: unreadable_fault.hpp makes one.
//
// Inside: `module` (a graph of `oscillator`, `shift` and `pattern`), `criterion`, `status`. The oscillator is
// hopf<Axis>, or the fourth argument: a component with inputs "amplitude", "frequency" and outputs "phase",
// "amplitude". Options: those of an adaptive component. Errors, cost: those of its parts.
// Example: tests/runtime/adaptive/kinds.cpp.
#pragma once

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

// Adds a lead to a phase. It has no state: NaN in gives NaN out, which the pattern recognises.
template <class Axis>
struct phase_shift {
  auto process(in<"phase", over<phase, Axis>> at, optional_in<"by", over<phase, Axis>> by)
      -> out<"shifted", over<phase, Axis>> {
    return at[Axis{}] + by[Axis{}];
  }
};

template <class Axis, class Pattern, class Oscillator, class Strategy, class Policies>
struct oscillation : graph<node<"oscillator", Oscillator, Strategy>,
                           node<"shift", phase_shift<Axis>, Strategy>,
                           node<"pattern", Pattern, Strategy>,
                           detail::wire_inside<"oscillator.phase", "shift.phase", Policies>,
                           detail::wire_inside<"shift.shifted", "pattern.phase", Policies>,
                           detail::wire_inside<"oscillator.amplitude", "pattern.amplitude", Policies>,
                           expose<"oscillator.amplitude", "amplitude">,
                           expose<"oscillator.frequency", "frequency">,
                           expose<"pattern.frequency", "frequency">,
                           expose<"shift.by", "phase">,
                           expose<"pattern.reference", "centre">,
                           expose<"pattern.start", "start">,
                           expose<"pattern.demonstration", "demonstration">,
                           expose<"pattern.learn", "learn">,
                           expose<"pattern.command", "command">,
                           expose<"pattern.velocity", "velocity">,
                           expose<"pattern.ode", "ode">,
                           expose<"pattern.module", "module">> {
  static constexpr auto inner_wires_of = detail::wires_of::the_one_around;
};

template <class Axis, class Pattern, Criterion Measure, class Oscillator = hopf<Axis>, class... Options>
struct generator
    : adaptive_component<oscillation<Axis,
                                     Pattern,
                                     Oscillator,
                                     typename detail::strategy_option<Options...>::type,
                                     typename detail::inner_policies<detail::list<latest>, Options...>::type>,
                         Measure,
                         Options...> {};

}  // namespace cca
