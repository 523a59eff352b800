// What the loop of an environment keeps of the others: where all exchange what they publish, and what of that
// it has taken.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/links/agreed_changes.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>
#include <cca/runtime/environments/links/ways_from_elsewhere.hpp>
#include <cca/runtime/environments/links/receive_samples.hpp>
#include <cca/runtime/environments/waiting/patience.hpp>
#include <cca/runtime/observers/loop_observers.hpp>

namespace cca::detail {

// The graph of a loop, or its set of modes; and what it keeps.
template <class D, int E>
struct key_of_loop {
  using type = part<D, E>;
  using state = kept_state<part<D, E>>;
};
template <DeploymentOfModes D, int E>
struct key_of_loop<D, E> {
  using type = modes_in<D, E>;
  using state = kept_state_of_modes<modes_in<D, E>>;
};
template <class D, int E>
using loop_key = typename key_of_loop<D, E>::type;
template <class D, int E>
using loop_state = typename key_of_loop<D, E>::state;

template <class D, int X>
inline constexpr bool may_fault_in_some_mode = [] {
  bool may = false;
  for_each_deployed_mode<D>([&]<class Mode>() { may |= counts_of<part<Mode, X>>.may_fault; });
  return may;
}();

// The next samples that come, by output and by way into a queue. Of a set of modes those of all modes.
template <class D,
          int E,
          class Arriving = chosen<counts_of<D>.output_count, arrives<loop_key<D, E>>>,
          class Entering = ways_from_elsewhere<loop_key<D, E>>>
struct next_samples;
template <class D, int E, int... Arriving, int... Way>
struct next_samples<D, E, std::integer_sequence<int, Arriving...>, std::integer_sequence<int, Way...>>
    : next_arrival<D, Arriving>..., next_of_way<D, E, Way>::type... {};
template <DeploymentOfModes D, int E, int... Arriving, int... Way>
struct next_samples<D, E, std::integer_sequence<int, Arriving...>, std::integer_sequence<int, Way...>>
    : next_arrival<D, Arriving>..., next_of_shared_way<D, E, Way>::type... {};

template <class D, int E>
struct links_of_environment : next_samples<D, E>, time_of_cycles<is_free_running<D, E>> {
  exchange<D>* shared = nullptr;
  const peers* others = nullptr;   // null: all environments are in this process
  bool is_exact = false;           // in a fast run: waits for whatever a result depends on
  std::int64_t ahead = 0;          // by how many beats at most, then
  bool is_cut = false;             // a fault elsewhere comes before the next call of this beat
  peers::bells* rings = nullptr;   // of a transport with threads of its own
  const peers* courier = nullptr;  // one whose work this thread does
  waiting_habit habit;
  int fault_rank = 0;  // of the call that faulted here, in the order of the whole
  [[no_unique_address]] agreed_changes<D, E> changes;  // of parts and modes

protected:
  std::array<std::int64_t, array_size(environment_count<D>)> seen{};  // how far the others were
  std::array<std::int64_t, array_size(environment_count<D>)> late_in_a_row{};
  std::int64_t received = 0;  // after the last beat before which samples were taken
};

// Each mode has functions of its own on the links of its environment.
template <class D, int E>
struct base_of_links {
  using type = links_of_environment<D, E>;
};

}  // namespace cca::detail
