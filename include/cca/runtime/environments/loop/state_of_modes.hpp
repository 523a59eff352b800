// The state of an environment of a deployment of modes: what all modes keep, its links, and the chain of its
// modes as of one loop (runtime/modes/shared_state.hpp). Each mode has functions of its own on the links.
#pragma once

#include <array>
#include <cstdint>

#include <cca/runtime/environments/loop/state_of_part.hpp>
#include <cca/runtime/modes/mode_switch.hpp>

namespace cca::detail {

template <class D, int E>
struct state_of_all_modes : controller_state<modes_in<D, E>>, links_of_environment<D, E>, active_mode {
  int requested_at = 0;  // the place in the beat of the component that asks for a mode; 0: none does
  int active = 0;
  // Of each output that leaves: the beat in which its component came. What it has published before is not
  // repeated where a beat is cut.
  std::array<std::int64_t, array_size(counts_of<D>.output_count + 1)> came_in{};

  template <fixed_string Mode>
  CCA_INLINE void request(const switch_to<Mode>&, int place) {
    requested = modes_of<D>::value.number_of(Mode.view());
    requested_at = place;
  }
  // From any environment: the later call wins.
  void join_request(int place, int mode) noexcept {
    if (place <= requested_at) return;
    requested = mode;
    requested_at = place;
  }
  void forget_request() noexcept {
    requested = -1;
    requested_at = 0;
  }

  // A component of this environment comes before beat k.
  template <int Output>
  void note_coming(std::int64_t k) noexcept {
    came_in[array_size(Output)] = k;
    if constexpr (is_free_running<D, E>)
      if (this->shared) this->shared->template results<E>().template begin_stay<Output>();
  }
  // The component of an output comes before beat k: what it has published before is not read.
  template <int Output>
  void forget_output(std::int64_t k) noexcept {
    pass<Output>(static_cast<next_arrival<D, Output>&>(*this), k);
  }
  template <int Way>
  void forget_way(std::int64_t k) noexcept {
    constexpr int output = plan_of<modes_in<D, E>>.inputs[Way].writer;
    pass<output>(static_cast<typename next_of_shared_way<D, E, Way>::type&>(*this), k);
  }

private:
  template <int Output, class Next>
  void pass(Next& next, std::int64_t k) noexcept {
    next.not_before = k;
    if constexpr (requires { next.gathered_number; }) next.gathered_number = next.unknown;
    if (this->shared)  // not before the first run
      next.number = this->shared->template ring<Output>().end_before(next.number, k);
  }
};

template <class D, int E>
struct base_of_links<deployed_mode<D, 0>, E> {
  using type = state_of_all_modes<D, E>;
};
template <class D, int I, int E>
struct base_of_links<deployed_mode<D, I>, E> {
  using type = controller_state<part<deployed_mode<D, I - 1>, E>>;
};
template <class D, int I, int E>
struct controller_state<part<deployed_mode<D, I>, E>> : environment_links<deployed_mode<D, I>, E>,
                                                        own_strategies<modes_in<D, E>, I>::type {};

// ---- of a recordable deployment: the same chain once more ----

// The functions of a mode on the links, where those of other modes are nearer.
template <class Base, class Mode, int E>
struct links_of_mode : Base {
  template <int Output, class Vector>
  CCA_INLINE void send(const Vector& v, std::int64_t origin, std::int64_t k) {
    links().template send<Output>(v, origin, k);
  }
  template <int Rank>
  CCA_INLINE bool is_due(std::int64_t k, beat_outcome& outcome, trace_track* track) noexcept {
    return links().template is_due<Rank>(k, outcome, track);
  }
  template <int Rank>
  CCA_INLINE bool is_done(std::int64_t k) noexcept {
    return links().template is_done<Rank>(k);
  }
  template <int Rank>
  CCA_INLINE bool is_faulted() noexcept {
    return links().template is_faulted<Rank>();
  }
  CCA_INLINE bool have_entered(std::int64_t k, const beat_outcome& outcome, int input) noexcept {
    return links().have_entered(k, outcome, input);
  }

private:
  CCA_INLINE auto& links() { return static_cast<environment_links<Mode, E>&>(*this); }
};

template <class D, int E>
struct recorded_state : state_of_modes<modes_in<D, E>>,
                        trace_link<probed<modes_in<D, E>>>,
                        frame_link<controller_state<probed<part<deployed_mode<D, 0>, E>>>, modes_in<D, E>> {};

template <class D, int I, int E>
struct controller_state<probed<part<deployed_mode<D, I>, E>>>
    : links_of_mode<controller_state<probed<part<deployed_mode<D, I - 1>, E>>>, deployed_mode<D, I>, E> {};
template <class D, int E>
struct controller_state<probed<part<deployed_mode<D, 0>, E>>>
    : links_of_mode<recorded_state<D, E>, deployed_mode<D, 0>, E> {};

}  // namespace cca::detail
