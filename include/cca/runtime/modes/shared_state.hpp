// The state of a set of modes: all components once, and what of their samples outlives a beat. Every mode
// works on all of it. It is plain values, so a copy is a snapshot.
#pragma once

#include <cstdint>

#include <cca/graph/layout/layout_of_modes.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

template <class M, int I>
inline constexpr bool has_trace_hooks<mode_part<M, I>> = Traceable<M>;

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

template <class M, int I, int First>
struct array_of_components<mode_part<M, I>, First> {
  using type = component_array<M, layout_of<M>.components[shared_nodes<M, I>[array_size(First)]].array>;
};
template <class M, int I, int Array>
struct array_of_samples<mode_part<M, I>, Array> {
  using type = stored_array<M, shared_array<M, I, Array>>;
};

}  // namespace cca::detail
