// The state of the loop of an environment.
#pragma once

#include <cca/runtime/environments/links/links.hpp>

namespace cca::detail {

template <class D>
struct told_for_others<part<D, 0>> {
  static constexpr bool holds(std::size_t o) { return leaves_freely<D>::holds(o); }
};
template <class D>
struct told_for_others<modes_in<D, 0>> : told_for_others<part<D, 0>> {};
template <class D>
struct told_earlier<modes_in<D, 0>> : told_earlier<part<D, 0>> {};
template <class D>
struct told_earlier<part<D, 0>> {
  static constexpr int most(std::size_t o) { return gathered_in_a_beat<D>[o]; }
};

// The state of a part has its links, which the beat finds by its context.
template <class D, int E>
struct controller_state<part<D, E>>
    : state_of<part<D, E>,
               chosen<counts_of<part<D, E>>.node_count, is_first_of_type<part<D, E>>>,
               chosen<layout_of<part<D, E>>.array_count, outlives_beat<part<D, E>>>>,
      part_states<parts_kept<part<D, E>>>,
      environment_links<D, E>,
      trace_link<part<D, E>> {};

}  // namespace cca::detail
