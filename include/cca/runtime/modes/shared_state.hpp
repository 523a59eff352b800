// The state of a set of modes: all components once, and what of their samples outlives a beat. Every mode
// works on all of it. It is plain values, so a copy is a snapshot. The frames of a recorded set, too, have
// the outputs of all modes.
#pragma once

#include <cstdint>
#include <type_traits>

#include <cca/graph/layout/layout_of_modes.hpp>
#include <cca/runtime/recording/beat_tap.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// All modes have the same parts.
template <class M, int I>
inline constexpr int parts_kept<mode_part<M, I>> = parts_kept<M>;
template <class M, int I>
inline constexpr const auto& kept_parts<mode_part<M, I>> = kept_parts<M>;

// One object is the state of every mode: each is derived from the one before, and the first from what all
// share.
template <class M, int I>
struct controller_state<mode_part<M, I>> : controller_state<mode_part<M, I - 1>> {};

template <class M>
struct controller_state<mode_part<M, 0>> : controller_state<M> {
  std::int64_t since = 0;  // the beat in which the active mode began
  int requested = -1;      // the mode that a component asks for

  template <fixed_string Mode>
  CCA_INLINE void request(const switch_to<Mode>&) {
    requested = modes_of<M>::value.number_of(Mode.view());
  }
};

template <class M>
using state_of_modes = controller_state<mode_part<M, mode_count<M> - 1>>;

// Of a recordable set the same once more: each mode's second beat finds its state and the frame.
template <class M, int I>
struct controller_state<probed<mode_part<M, I>>> : controller_state<probed<mode_part<M, I - 1>>> {};
template <class M>
struct controller_state<probed<mode_part<M, 0>>>
    : state_of_modes<M>, trace_link<probed<M>>, frame_link<controller_state<probed<mode_part<M, 0>>>, M> {};
template <class M>
using kept_state_of_modes = std::conditional_t<Recordable<M>,
                                               controller_state<probed<mode_part<M, mode_count<M> - 1>>>,
                                               state_of_modes<M>>;

template <class M, int I>
inline constexpr auto frame_layout_of<mode_part<M, I>> = [] {
  constexpr const auto& whole = frame_layout_of<M>;
  constexpr int outputs = counts_of<mode_part<M, I>>.output_count;
  const auto& plan = plan_of<mode_part<M, I>>;
  const auto view = shared_plan_of<M>.view_of(shown_plan<mode_part<M, I>>, shown_plan<M>);
  frame_layout<outputs> frame;
  frame.origins = whole.origins;
  frame.words = whole.words;
  for (std::size_t o = 0; o < array_size(outputs); ++o) {
    const auto shared = array_size(view.shared_output(static_cast<int>(o)));
    const auto& call = plan.calls[array_size(plan.outputs[o].call)];
    frame.origin[o] = whole.origin[shared];
    frame.at[o] = whole.at[shared];
    frame.size[o] = whole.size[shared];
    frame.in_each_beat[o] = published(call.function->outputs[plan.outputs[o].port], call).every_beat() &&
                            !counts_of<mode_part<M, I>>.may_fault;
  }
  return frame;
}();

template <class M, int I, int First>
struct array_of_components<mode_part<M, I>, First> {
  using type = component_array<M, layout_of<M>.components[shared_nodes<M, I>[array_size(First)]].array>;
};
template <class M, int I, int Array>
struct array_of_samples<mode_part<M, I>, Array> {
  using type = stored_array<M, shared_array<M, I, Array>>;
};

}  // namespace cca::detail
