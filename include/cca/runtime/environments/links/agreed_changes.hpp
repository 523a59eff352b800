// Changes that have effect in one and the same beat in all environments: parts stop and start, and modes
// switch.
//
//   requests   of components: they leave at the end of a beat and have effect when the next one begins. So
//              they travel like a sample that is delayed by one beat: a fast run waits for them, and in a
//              wall-clock run they may come late.
//   orders     from outside (cca::live_access, switch_to): for a beat that is far enough ahead, so that all
//              environments have them in time. Only for what more than one environment has, or what another
//              process runs.
//
// What comes late does not undo what was asked for later: all environments end with the same, whenever each
// of them hears of it.
//
// In beats that end by a fault nothing is asked. Errors: none. Cost: only environments that ask, or are
// asked, know of it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/live/ordered.hpp>
#include <cca/runtime/publish.hpp>

namespace cca::detail {

// The environments that ask for parts of environment E.
template <class D, int E>
struct asks_here {
  static constexpr bool holds(std::size_t from) { return is_asked_by<D, E>(static_cast<int>(from)); }
};

template <class D, int From>
using request_ring = sample_ring<size_of_request<D>, ring_capacity<D, counts_of<D>.output_count + From>>;
template <class D, int From>
using order_ring = ring_of_output<D, orders_of<D, From>>;

// All give orders to those that obey.
template <class D, int E>
struct gives_orders_to {
  static constexpr bool holds(std::size_t) { return obeys_orders<D, E>; }
};

template <class D,
          int E,
          class From = chosen<environment_count<D>, asks_here<D, E>>,
          class Ordering = chosen<environment_count<D>, gives_orders_to<D, E>>>
class agreed_changes;
template <class D, int E>
class agreed_changes<D, E, std::integer_sequence<int>, std::integer_sequence<int>> {
public:
  template <class Loop>
  void take(exchange<D>&, Loop&, std::int64_t) noexcept {}
  template <class Loop>
  void settle(exchange<D>&, Loop&, std::int64_t, std::int64_t, bool) noexcept {}
  void forget(exchange<D>&) noexcept {}
};
template <class D, int E, int... From, int... Ordering>
class agreed_changes<D, E, std::integer_sequence<int, From...>, std::integer_sequence<int, Ordering...>> {
public:
  // Those of the beats before `beat`, in their order: in each first what components ask for. The loop makes
  // the changes:
  //   make_requested(next)                what has been joined in its state, as of beat `next`
  //   make_ordered(what, number, next)
  template <class Loop>
  [[gnu::noinline]] void take(exchange<D>& shared, Loop& loop, std::int64_t beat) noexcept {
    for (std::int64_t oldest; (oldest = find_oldest(shared, beat)) != no_position;) {
      [[maybe_unused]] const bool is_late = !loop.state.is_exact && oldest + 1 < known;
      const std::int64_t next = is_late ? known : oldest + 1;
      if constexpr (sizeof...(From) > 0) {
        (join<From>(shared, loop.state, oldest), ...);
        loop.make_requested(next);
      }
      (obey<Ordering>(shared, loop, oldest + 1, next, is_late, true), ...);
    }
    known = std::max(known, beat + 1);
  }
  // At the end of a run: what components asked for in the beats before `beat`, and all that is ordered,
  // before beat `next`. After a fault the mode stays.
  template <class Loop>
  [[gnu::noinline]] void settle(exchange<D>& shared,
                                Loop& loop,
                                std::int64_t beat,
                                [[maybe_unused]] std::int64_t next,
                                [[maybe_unused]] bool may_switch) noexcept {
    take(shared, loop, beat);
    for (std::int64_t oldest; (oldest = find_oldest_order(shared, no_position)) != no_position;)
      (obey<Ordering>(shared, loop, oldest + 1, next, false, may_switch), ...);
  }
  // Those that are there are of a run before, or of a beat that a fault has ended.
  void forget(exchange<D>& shared) noexcept {
    [[maybe_unused]] const auto forget_one = [](const auto& ring, std::uint64_t& next) {
      typename std::remove_cvref_t<decltype(ring)>::sample one;
      while (ring.take(next, no_position, one)) {}
    };
    (forget_one(requests<From>(shared), taken[From]), ...);
    (forget_one(orders<Ordering>(shared), obeyed[Ordering]), ...);
    newest = {};
  }

private:
  template <int X>
  static const request_ring<D, X>& requests(exchange<D>& shared) {
    return shared.template ring<counts_of<D>.output_count + X>();
  }
  template <int X>
  static const order_ring<D, X>& orders(exchange<D>& shared) {
    return shared.template ring<orders_of<D, X>>();
  }
  // The beat of the oldest before `beat`.
  std::int64_t find_oldest(exchange<D>& shared, std::int64_t beat) const noexcept {
    std::int64_t oldest = find_oldest_order(shared, beat);
    ((oldest = std::min(oldest, published(requests<From>(shared), taken[From], beat))), ...);
    return oldest;
  }
  std::int64_t find_oldest_order([[maybe_unused]] exchange<D>& shared,
                                 [[maybe_unused]] std::int64_t beat) const noexcept {
    std::int64_t oldest = no_position;
    ((oldest = std::min(oldest, published(orders<Ordering>(shared), obeyed[Ordering], beat))), ...);
    return oldest;
  }
  template <class Ring>
  static std::int64_t published(const Ring& ring, std::uint64_t next, std::int64_t beat) noexcept {
    typename Ring::sample one;
    return ring.take(next, beat, one) ? one.published_in : no_position;
  }
  // Of several requests in one beat that of the last call counts, wherever it ran.
  template <int X, class State>
  void join(exchange<D>& shared, State& state, std::int64_t beat) noexcept {
    typename request_ring<D, X>::sample one;
    std::uint64_t next = taken[X];
    if (!requests<X>(shared).take(next, beat + 1, one) || one.published_in != beat) return;
    taken[X] = next;
    if constexpr (counts_of<D>.part_count > 0)
      for (int p = 0; p < counts_of<D>.part_count; ++p) {
        int& asked = state.parts[array_size(p)].asked;
        const int wanted = static_cast<int>(one.vector[p]);
        if (has_part<D, E>(p) && std::abs(wanted) > std::abs(asked) && is_newest(p, beat, std::abs(wanted)))
          asked = wanted;
      }
    if constexpr (DeploymentOfModes<D>) {
      const int place = static_cast<int>(one.vector[counts_of<D>.part_count]);
      const int mode = static_cast<int>(one.vector[counts_of<D>.part_count + 1]);
      if (mode >= 0 && is_newest(counts_of<D>.part_count, beat, place)) state.join_request(place, mode);
    }
  }
  // Of what is asked for one part, or for the mode (`what`): nothing of a later beat, or of a later call of
  // this one, has been obeyed.
  bool is_newest(int what, std::int64_t beat, int place) noexcept {
    asked_in& last = newest[array_size(what)];
    if (beat < last.beat || (beat == last.beat && place < last.place)) return false;
    last = {beat, place};
    return true;
  }
  // Those for one beat. One that comes after this beat has begun here is late.
  template <int X, class Loop>
  void obey(exchange<D>& shared,
            Loop& loop,
            std::int64_t beat,
            std::int64_t next,
            bool is_late,
            bool may_switch) noexcept {
    typename order_ring<D, X>::sample one;
    for (std::uint64_t number = obeyed[X]; orders<X>(shared).take(number, beat, one);) {
      obeyed[X] = number;
      const auto what = static_cast<ordered>(static_cast<int>(one.vector[0]));
      const int which = static_cast<int>(one.vector[1]);
      if (what == ordered::mode ? !may_switch : !has_part<D, E>(which)) continue;
      if (is_late) loop.count_late_order(X);
      if (!is_newest(what == ordered::mode ? counts_of<D>.part_count : which, one.published_in,
                     after_calls + X))
        continue;
      loop.make_ordered(what, which, next);
    }
  }

  struct asked_in {
    std::int64_t beat = -1;
    int place = 0;
  };
  static constexpr int after_calls = 1 << 20;  // an order comes after all calls of its beat

  std::array<std::uint64_t, array_size(environment_count<D>)> taken{}, obeyed{};
  std::array<asked_in, array_size(counts_of<D>.part_count + 1)> newest{};  // of each part, and of the mode
  std::int64_t known = 0;  // the first beat that a request can still change: those before have begun
};

// What the components of environment E have asked for in beat k.
template <class D, int E, class State>
[[gnu::noinline]] void send_requests(exchange<D>& shared,
                                     State& state,
                                     std::int64_t k,
                                     bool is_exact) noexcept {
  Eigen::Matrix<double, size_of_request<D>, 1> asked;
  if constexpr (counts_of<D>.part_count > 0) {
    for (int p = 0; p < counts_of<D>.part_count; ++p)
      asked[p] = std::exchange(state.parts[array_size(p)].asked, 0);
    state.is_asked = false;
  }
  if constexpr (DeploymentOfModes<D>) {
    asked[counts_of<D>.part_count] = state.requested_at;
    asked[counts_of<D>.part_count + 1] = state.requested;
    state.forget_request();
  }
  shared.template ring<counts_of<D>.output_count + E>().put(asked, 0, k, is_exact);
}

// From outside, by environment E: it has effect when beat `in` begins.
template <class D, int E>
void send_order(exchange<D>& shared, ordered what, int number, std::int64_t in, bool is_exact) noexcept {
  const Eigen::Vector2d order(static_cast<int>(what), number);
  shared.template ring<orders_of<D, E>>().put(order, 0, in - 1, is_exact);
}

// An order that is given before beat k. A fast run waits for it: all environments meet before that beat. In a
// wall-clock run it is for the first beat in which each environment has it or has lost contact. Where a
// deployment tolerates more late beats, an order may be late, and counts as late.
inline constexpr int most_beats_for_order = 100;
template <class D>
constexpr std::int64_t beat_of_order(std::int64_t k, bool is_exact) {
  if (is_exact) return k;
  int longest = 1;
  for (const auto& from : crossings_of<D>.least_delay)
    for (const int delay : from) longest = std::max(longest, delay);
  return k + std::min(environments_of<D>::tolerated, most_beats_for_order) + longest;
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
inline constexpr int place_in_beat<part<D, E>, Call> = 1 + call_of<D, Call>.rank;

}  // namespace cca::detail
