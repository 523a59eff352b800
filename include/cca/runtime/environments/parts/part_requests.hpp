// What components ask for parts of other environments, or of their own: it leaves at the end of a beat and
// has effect when the next one begins, in every environment that has a node of the part. So it travels like a
// sample that is delayed by one beat: a fast run waits for it, and in a wall-clock run it may come late.
//
// In beats that end by a fault nothing is asked. Errors: none. Cost: only environments whose components ask,
// or are asked, know of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/publish.hpp>

namespace cca::detail {

// The environments that ask for parts of environment E.
template <class D, int E>
struct asks_here {
  static constexpr bool holds(std::size_t from) { return is_asked_by<D, E>(static_cast<int>(from)); }
};

template <class D, int From>
using request_ring = sample_ring<counts_of<D>.part_count, ring_capacity<D, counts_of<D>.output_count + From>>;

template <class D, int E, class From = chosen<environment_count<D>, asks_here<D, E>>>
class arriving_requests;
template <class D, int E>
class arriving_requests<D, E, std::integer_sequence<int>> {
public:
  template <class State, class F>
  void take(exchange<D>&, State&, std::int64_t, F) noexcept {}
  void forget(exchange<D>&) noexcept {}
};
template <class D, int E, int... From>
class arriving_requests<D, E, std::integer_sequence<int, From...>> {
public:
  // Those of the beats before `beat`, in their order. f(part, stops, next) for each change.
  template <class State, class F>
  [[gnu::noinline]] void take(exchange<D>& shared, State& state, std::int64_t beat, F f) noexcept {
    for (std::int64_t oldest = 0; oldest != no_position;) {
      oldest = no_position;
      ((oldest = std::min(oldest, published<From>(shared, beat))), ...);
      if (oldest == no_position) break;
      (join<From>(shared, state, oldest), ...);
      const std::int64_t next = std::max(oldest + 1, known);
      std::int64_t from = next;
      if constexpr (is_free_running<D, E>) from = state.index;  // it counts cycles
      take_requests<part<D, E>>(state, from, [&](int number, bool stops) { f(number, stops, next); });
    }
    known = std::max(known, beat + 1);
  }
  // Those that are there are of a run before, or of a beat that a fault has ended.
  void forget(exchange<D>& shared) noexcept {
    const auto forget_one = [](const auto& ring, std::uint64_t& next) {
      typename std::remove_cvref_t<decltype(ring)>::sample one;
      while (ring.take(next, no_position, one)) {}
    };
    (forget_one(ring<From>(shared), taken[From]), ...);
  }

private:
  template <int X>
  static const request_ring<D, X>& ring(exchange<D>& shared) {
    return shared.template ring<counts_of<D>.output_count + X>();
  }
  // The beat of the oldest before `beat`.
  template <int X>
  std::int64_t published(exchange<D>& shared, std::int64_t beat) const noexcept {
    typename request_ring<D, X>::sample one;
    std::uint64_t next = taken[X];
    return ring<X>(shared).take(next, beat, one) ? one.published_in : no_position;
  }
  // Of several requests in one beat that of the last call counts, wherever it ran.
  template <int X, class State>
  void join(exchange<D>& shared, State& state, std::int64_t beat) noexcept {
    typename request_ring<D, X>::sample one;
    std::uint64_t next = taken[X];
    if (!ring<X>(shared).take(next, beat + 1, one) || one.published_in != beat) return;
    taken[X] = next;
    for (int p = 0; p < counts_of<D>.part_count; ++p) {
      int& asked = state.parts[array_size(p)].asked;
      const int wanted = static_cast<int>(one.vector[p]);
      if (has_part<D, E>(p) && std::abs(wanted) > std::abs(asked)) asked = wanted;
    }
  }

  std::array<std::uint64_t, array_size(environment_count<D>)> taken{};
  std::int64_t known = 0;  // the first beat that a request can still change: those before have begun
};

// What the components of environment E have asked for in beat k.
template <class D, int E, class State>
[[gnu::noinline]] void send_requests(exchange<D>& shared,
                                     State& state,
                                     std::int64_t k,
                                     bool is_exact) noexcept {
  Eigen::Matrix<double, counts_of<D>.part_count, 1> asked;
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    asked[p] = std::exchange(state.parts[array_size(p)].asked, 0);
  state.is_asked = false;
  shared.template ring<counts_of<D>.output_count + E>().put(asked, 0, k, is_exact);
}

// The first node of a part: its environment tells a recorder of the part. A free-running one only where no
// other has a node: in a wall-clock run its components are not replayed, so it matters when the others stop.
template <class D>
constexpr int first_node_of_part(int number) {
  int first = -1;
  for (int node = counts_of<D>.node_count; node-- > 0;)
    if (is_in_part<D>(node, number) && (first < 0 || !is_free_node<D>(node) || is_free_node<D>(first)))
      first = node;
  return first < 0 ? 0 : first;
}

template <class D, int E, int Call>
inline constexpr int place_in_beat<part<D, E>, Call> = call_of<D, Call>.rank;

}  // namespace cca::detail
