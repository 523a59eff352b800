// A Sequencer: runs the steps of a plan, driven by the statuses of the skills (the source document,
// section 6.3 and chapter 3).
//
//   cca::node<"sequencer", cca::sequencer<"*.status.*", plan>, cca::timed<10>>
//
//   observes the scope    and for `*.status.*` also `*.status`, both in one graph: its own, or the nearest
//                         around it; delayed by one beat, because the skills wait for the sequencer in turn
//   out "step"        step_port              the number of the running step, `plan::at<"reach">`
//   out "running"     step_time              s since the step began
//   out "timed_out"   step_flag              1 if the step began by a timeout
//   out "status"      component_status_port  reached in the last step, converging before
//   starts, stops     of a plan that names parts (needs<...> in sequence.hpp): asked for in each firing
//   origin            the beat of the decision: a part that rests has an old status, and the step is not old
//   fault             if a condition of your own asks for a path without a publisher and does not say so
//
// Paths in conditions are looked up as patterns are: in the graph of the sequencer, then in those around it.
// Errors: observe.nothing; plan.unknown_path, if nobody publishes such a path under the scope;
// plan.unknown_step.
//
// While an observed number is NaN, conditions hold as sequence.hpp says; all outputs stay finite, "status" is
// `converging` or `reached` as before, and there is no fault.
//
// For other outputs (a target, an amplitude) read "step" in your own component, or hold a cca::sequence<plan>
// in it. Timeouts count beats of the controller, whatever the strategy of the sequencer. Cost: that of a
// sequence (sequence.hpp). Example: tests/runtime/adaptive/sequencer.cpp.
#pragma once

#include <tuple>

#include <cca/adaptive/component_status.hpp>
#include <cca/adaptive/sequence.hpp>
#include <cca/component/fault.hpp>
#include <cca/graph/items/graph.hpp>

namespace cca {

struct step_axis : dimension<"step"> {};
struct step_port : space<status, axes<step_axis>> {};
struct running_axis : dimension<"running"> {};
struct step_time : space<number, axes<running_axis>> {};  // s
struct timed_out_axis : dimension<"timed_out"> {};
struct step_flag : space<status, axes<timed_out_axis>> {};

namespace detail {

// "*.status.*|*.status" for "*.status.*": a component that publishes its status itself has no node for it.
template <fixed_string Scope>
consteval auto with_components() {
  constexpr std::size_t size = Scope.view().size();
  if constexpr (!Scope.view().ends_with(".*")) {
    return Scope;
  } else {
    char text[2 * size]{};
    for (std::size_t i = 0; i < size; ++i) text[i] = Scope.text[i];
    text[size] = '|';
    for (std::size_t i = 0; i + 2 < size; ++i) text[size + 1 + i] = Scope.text[i];
    return fixed_string<2 * size>(text);
  }
}

}  // namespace detail

template <fixed_string Scope, class Plan, class Policy = delayed<1>>
struct sequencer {
  static constexpr auto asked_paths = Plan::asked_paths;
  sequence<Plan> steps;

  auto process(observe<detail::with_components<Scope>(), Policy> told, beat now)
      -> detail::with_parts<Plan,
                            out<"step", step_port>,
                            out<"running", step_time>,
                            out<"timed_out", step_flag>,
                            out<"status", component_status_port>,
                            fault> {
    steps.update(now, told);
    const std::int64_t period = now.index() > 0 ? now.time() / now.index() : 0;
    return detail::add_parts<Plan>(
        steps.step(), out<"step", step_port>(steps.step()).with_origin(now.time()),
        out<"running", step_time>(1e-9 * static_cast<double>(steps.beats(now) * period))
            .with_origin(now.time()),
        out<"timed_out", step_flag>(steps.timed_out() ? 1 : 0).with_origin(now.time()),
        out<"status", component_status_port>(
            status_of(steps.finished() ? component_status::reached : component_status::converging))
            .with_origin(now.time()),
        steps.unheard() ? fault("sequencer: a condition names a path that nobody publishes under its scope")
                        : fault());
  }

  void on_start() { steps = {}; }
};

}  // namespace cca
