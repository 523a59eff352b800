// The state of a set of modes: all components once, and what of their samples outlives a beat. Every mode
// works on all of it. It is plain values, so a copy is a snapshot. The frames of a recorded set, too, have
// the outputs of all modes.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/graph/modes/layout_of_modes.hpp>
#include <cca/runtime/observers/beat_tap.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// All modes have the same parts.
template <ModeKey Mode>
inline constexpr int parts_kept<Mode> = parts_kept<set_of_key<Mode>>;
template <ModeKey Mode>
inline constexpr const auto& kept_parts<Mode> = kept_parts<set_of_key<Mode>>;

// The strategies that have a state: one object for all modes in which a component has the same one. It is
// that of the first of these modes.
template <Modes M>
struct keeps_strategy<M> {
  static constexpr bool holds(std::size_t) { return false; }
};
template <class M, int I>
constexpr int shared_call_of(int call) {
  return shared_plan_of<M>.view_of(shown_plan<mode_key<M, I>>, shown_plan<M>).shared_call(call);
}
struct place_in_mode {
  int mode = -1, call = -1;
};
template <class M, int I, int Call>
inline constexpr place_in_mode owner_of_strategy = [] {
  constexpr int shared = shared_call_of<M, I>(Call);
  constexpr auto key = plan_of<mode_key<M, I>>.nodes[call_of<mode_key<M, I>, Call>.node].item->strategy_key;
  place_in_mode first;
  [&]<int... J>(std::integer_sequence<int, J...>) {
    const auto look = [&]<int Mode>(std::integral_constant<int, Mode>) {
      for (int c = 0; first.mode < 0 && c < counts_of<mode_key<M, Mode>>.call_count; ++c)
        if (shared_call_of<M, Mode>(c) == shared && keeps_strategy<mode_key<M, Mode>>::holds(array_size(c)) &&
            plan_of<mode_key<M, Mode>>.nodes[array_size(plan_of<mode_key<M, Mode>>.calls[array_size(c)].node)]
                    .item->strategy_key == key)
          first = {Mode, c};
    };
    (look(std::integral_constant<int, J>{}), ...);
  }(std::make_integer_sequence<int, I + 1>{});
  return first;
}();
template <ModeKey Mode, int Call>
struct place_of_strategy<Mode, Call> {
  static constexpr place_in_mode owner = owner_of_strategy<set_of_key<Mode>, mode_number_of<Mode>, Call>;
  using type = kept_strategy<mode_key<set_of_key<Mode>, owner.mode>, owner.call>;
};

template <class M,
          int I,
          class Calls = chosen<counts_of<mode_key<M, I>>.call_count, keeps_strategy<mode_key<M, I>>>>
struct own_strategies;
template <class M, int I, int... Call>
struct own_strategies<M, I, std::integer_sequence<int, Call...>> {
  static constexpr std::array<bool, sizeof...(Call) + 1> are_own{owner_of_strategy<M, I, Call>.mode == I...,
                                                                 false};
  static constexpr std::array<int, sizeof...(Call) + 1> calls{Call..., -1};
  struct is_own {
    static constexpr bool holds(std::size_t c) {
      for (std::size_t n = 0; n < sizeof...(Call); ++n)
        if (calls[n] == static_cast<int>(c)) return are_own[n];
      return false;
    }
  };
  using type = kept_strategies<mode_key<M, I>, chosen<counts_of<mode_key<M, I>>.call_count, is_own>>;
};

struct active_mode {
  std::int64_t since = 0;  // the beat in which it began
  int requested = -1;      // the mode that a component asks for
};

// One object is the state of every mode: each is derived from the one before, and the first from what all
// share.
template <class M, int I>
struct controller_state<mode_part<M, I>> : controller_state<mode_part<M, I - 1>>,
                                           own_strategies<M, I>::type {};

template <class M>
struct controller_state<mode_part<M, 0>> : controller_state<M>, own_strategies<M, 0>::type, active_mode {
  template <fixed_string Mode>
  CCA_INLINE void request(const switch_to<Mode>&, int) {
    requested = modes_of<M>::value.number_of(Mode.view());
  }
};

template <class M>
using state_of_modes = controller_state<mode_key<M, mode_count<M> - 1>>;

// Of a recordable set the same once more: each mode's second beat finds its state and the frame.
template <class M, int I>
struct controller_state<probed<mode_part<M, I>>> : controller_state<probed<mode_part<M, I - 1>>> {};
template <class M>
struct controller_state<probed<mode_part<M, 0>>>
    : state_of_modes<M>, trace_link<probed<M>>, frame_link<controller_state<probed<mode_part<M, 0>>>, M> {};
template <class M>
using kept_state_of_modes = std::
    conditional_t<Recordable<M>, controller_state<probed<mode_key<M, mode_count<M> - 1>>>, state_of_modes<M>>;

template <ModeKey Mode>
inline constexpr auto frame_layout_of<Mode> = [] {
  using M = set_of_key<Mode>;
  constexpr const auto& whole = frame_layout_of<M>;
  constexpr int outputs = counts_of<Mode>.output_count;
  const auto view = shared_plan_of<M>.view_of(shown_plan<Mode>, shown_plan<M>);
  frame_layout<outputs> frame;
  frame.origins = whole.origins;
  frame.words = whole.words;
  for (std::size_t o = 0; o < array_size(outputs); ++o) {
    const auto shared = array_size(view.shared_output(static_cast<int>(o)));
    frame.origin[o] = whole.origin[shared];
    frame.at[o] = whole.at[shared];
    frame.size[o] = whole.size[shared];
  }
  return frame;
}();

template <ModeKey Mode, int First>
struct array_of_components<Mode, First> {
  using M = set_of_key<Mode>;
  using type = component_array<
      M,
      layout_of<M>.components[shared_nodes<M, mode_number_of<Mode>>[array_size(First)]].array>;
};
template <ModeKey Mode, int Array>
struct array_of_samples<Mode, Array> {
  using type = stored_array<set_of_key<Mode>, shared_array<set_of_key<Mode>, mode_number_of<Mode>, Array>>;
};

}  // namespace cca::detail
