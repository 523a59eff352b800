// Queues whose samples come from another environment: each is taken out of the ring of its output when it is
// due. In a wall-clock run the ring may have lost some to a reader that stood still; they count as lost by
// the queue.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/links/receive_samples.hpp>
#include <cca/runtime/modes/mode_switch.hpp>
#include <cca/runtime/queue_entries.hpp>

namespace cca::detail {

// The next sample of a way into a queue, and the beat in which the one before was published.
template <class D, int Way, bool IsFree = false>
struct next_by_way {
  std::uint64_t number = 0;
  std::int64_t newest = -1;
};
// Of a set of modes: what was published before the way came is not read. A way has the number that all modes
// share.
template <class D, int E, int Way>
struct next_by_way<modes_in<D, E>, Way, false> {
  std::uint64_t number = 0;
  std::int64_t newest = -1;
  std::int64_t not_before = 0;
};
// From a free-running environment also of what has come in a wall-clock run: its place in the ring, and the
// number that its output gave it.
template <class Key, int Way>
struct next_by_way<Key, Way, true> : next_by_way<Key, Way> {
  static constexpr std::uint64_t unknown = ~std::uint64_t{0};  // it has joined others that ran before
  std::uint64_t gathered = 0, gathered_number = 0;
};
template <class D, int E, int Way>
struct next_of_way {
  using type = next_by_way<D, Way, is_of_free_running<D, input_of<part<D, E>, Way>.writer>>;
};
template <class D, int E, int Way>
struct next_of_shared_way {
  using type =
      next_by_way<modes_in<D, E>, Way, is_of_free_running<D, plan_of<modes_in<D, E>>.inputs[Way].writer>>;
};
template <class D, int I, int E, int Way>
struct next_of_way<deployed_mode<D, I>, E, Way>
    : next_of_shared_way<D, E, queues_of_mode<modes_in<D, E>, I>.ways[array_size(Way)]> {};

// The number of a way that all environments know.
template <class D, int E, int Way>
inline constexpr int number_of_way = Way;
template <class D, int I, int E, int Way>
inline constexpr int number_of_way<deployed_mode<D, I>, E, Way> =
    queues_of_mode<modes_in<D, E>, I>.ways[array_size(Way)];

template <class D, int E, int Way, class State>
  requires(enters<part<D, E>>::holds(std::size_t{Way}))
struct end_of_way<part<D, E>, Way, State> {
  static constexpr const input& in = input_of<part<D, E>, Way>;
  static constexpr int size = size_of_output<D, in.writer>;
  struct sample {
    std::int64_t published_in = -1, origin = 0;  // beat, ns
    Eigen::Matrix<double, size, 1> vector;
  };

  // In a beat come only those of ways without delay.
  end_of_way(State& s, std::int64_t k, bool in_beat) : state(s), is_in_beat(in_beat) { fetch(k); }

  const sample* next(std::int64_t) const { return has_come ? &came : nullptr; }
  void enter(beat_outcome& outcome, std::int64_t k) {
    put_into_queue<part<D, E>, Way>(state, outcome, came.vector, came.origin, k);
    fetch(k);
  }

private:
  static constexpr bool is_from_free = is_of_free_running<D, in.writer>;
  static constexpr int writer = shared_output_of<D, in.writer>;
  using ring_type =
      std::remove_cvref_t<decltype(std::declval<exchange<whole_of<D>>&>().template ring<writer>())>;

  // What was published before this beat has come.
  std::int64_t end_at(std::int64_t k) const {
    if constexpr (is_free_running<D, E>) {
      // A cycle begins with all that is there.
      if (in.delay == 0 && !state.is_exact) return no_position;
      k = state.beat;
    }
    return in.delay > 0 ? k - in.delay + 1 : k + is_in_beat;
  }
  void fetch(std::int64_t k) {
    has_come = false;
    fetch_published(end_at(k));
    if constexpr (is_from_free)
      if (!has_come) fetch_gathered(end_at(k));
  }
  // The number bounds a beat beside a writer that goes on publishing: the rest comes in the next one.
  void fetch_published(std::int64_t end) {
    auto& from = static_cast<typename next_of_way<D, E, Way>::type&>(state);
    const auto& ring = state.shared->template ring<writer>();
    for (typename ring_type::sample one; !has_come && left > 0; --left) {
      const std::uint64_t expected = from.number;
      const bool is_due = take(ring, from.number, end, one);
      lose(from.number - expected - is_due);
      if (!is_due) return;
      from.newest = one.published_in;
      if (!one.is_repeated && !is_older(from, one.published_in))
        come(one.published_in, one.origin, one.vector);
    }
  }
  void fetch_gathered(std::int64_t end)
    requires(is_from_free)
  {
    auto& from = static_cast<typename next_of_way<D, E, Way>::type&>(state);
    const auto& ring = state.shared->template gathered<writer>();
    typename std::remove_cvref_t<decltype(ring)>::sample one;
    do {
      if (left-- <= 0 || !take(ring, from.gathered, end, one)) return;
    } while (is_older(from, one.published_in));
    const auto number = static_cast<std::uint64_t>(one.vector[size]);
    if (from.gathered_number != from.unknown && number > from.gathered_number)
      lose(number - from.gathered_number);
    from.gathered_number = number + 1;
    come(one.published_in, one.origin, one.vector.template head<size>());
  }
  // The next of a ring. Where that has lost some to a reader that stood still, a queue which keeps the first
  // finds these beside it.
  template <class Ring, class Sample>
  bool take(const Ring& ring, std::uint64_t& number, std::int64_t end, Sample& one) {
    if constexpr (keeps_first<D>::holds(std::size_t{Way}) && has_first<Ring>) {
      std::uint64_t next = number;
      const bool is_due = ring.take(next, end, one);
      const auto* const first =
          state.shared->template first_on_way<number_of_way<D, E, Way>>().oldest_from(number);
      if (!first || first->number >= next - is_due) return number = next, is_due;
      if (first->published_in >= end) return false;
      number = first->number + 1;
      one.published_in = first->published_in;
      one.origin = first->origin;
      one.vector = first->vector();
      return true;
    } else {
      return ring.take(number, end, one);
    }
  }
  // They are those of a wall-clock run.
  template <class Ring>
  static constexpr bool has_first = [] {
    constexpr int coordinates = decltype(Ring::sample::vector)::RowsAtCompileTime;
    return coordinates == size + (is_gathered<D, in.writer> ? 1 : 0);
  }();

  template <class Vector>
  void come(std::int64_t published_in, std::int64_t origin, const Vector& v) {
    came.published_in = published_in;
    came.origin = origin;
    came.vector = v;
    has_come = true;
  }
  void lose(std::uint64_t samples) {
    constexpr place at = layout_of<part<D, E>>.sources[Way];
    if (samples > 0)
      sample_in<part<D, E>, at.array>(state, at.index).lose(static_cast<std::int64_t>(samples));
  }

  static constexpr int most_at_once = [] {
    if constexpr (is_from_free) return 2 * (ring_type::capacity + gathered_capacity<whole_of<D>, writer>);
    else return 2 * ring_type::capacity;
  }();

  State& state;
  sample came;
  bool is_in_beat, has_come = false;
  int left = most_at_once;
};

// What an environment does with its ways. `Links` is environment_links, which keeps the next of each.
template <class Links, class D, int E, class Ways = ways_from_elsewhere<part<D, E>>>
class ways_of;
template <class Links, class D, int E, int... Way>
class ways_of<Links, D, E, std::integer_sequence<int, Way...>> {
public:
  // The queues of this environment begin with what arrives in beat k or later. Only in an environment that
  // joins others which have been running is there anything older.
  void begin_queues([[maybe_unused]] std::int64_t k) noexcept { (skip_arrived<Way>(k), ...); }

private:
  template <int One>
  void skip_arrived(std::int64_t k) noexcept {
    constexpr const input& in = input_of<part<D, E>, One>;
    auto& shared = *static_cast<Links&>(*this).shared;
    auto& next = static_cast<typename next_of_way<D, E, One>::type&>(static_cast<Links&>(*this));
    if (next.newest < 0)
      skip(shared.template ring<shared_output_of<D, in.writer>>(), next.number, k - in.delay);
    if constexpr (is_of_free_running<D, in.writer>) {
      if (next.gathered_number > 0 || k == 0) return;
      skip(shared.template gathered<shared_output_of<D, in.writer>>(), next.gathered, k - in.delay);
      next.gathered_number = next.unknown;
    }
  }
  template <class Ring>
  static void skip(const Ring& ring, std::uint64_t& number, std::int64_t end) noexcept {
    typename Ring::sample old;
    while (ring.take(number, end, old)) {}
  }
};

// The ways without delay into the queue of an input whose writers come before a call of this environment in
// the order of the whole.
template <class D, int E, int Input, int Rank>
struct leads_at_once {
  static constexpr bool holds(std::size_t way) {
    if (!leads_into<part<D, E>, Input>::holds(way)) return false;
    const auto& plan = plan_of<D>;
    const flat_view g = plan.view();
    return crosses_at_once(g, g.inputs[way]) && g.calls[g.outputs[g.inputs[way].writer].call].rank < Rank;
  }
};

// The queues that such a way leads into.
template <class D, int E>
struct is_entered_at_once {
  static constexpr bool holds(std::size_t i) {
    const auto& plan = plan_of<D>;
    const flat_view g = plan.view();
    bool found = false;
    if (is_queued(g.inputs[i]) && g.inputs[i].way_of < 0 && environment_of(g, g.inputs[i].call) == E)
      for_each_way(g, static_cast<int>(i), [&](const input& way) { found |= crosses_at_once(g, way); });
    return found;
  }
};
template <class D, int E>
using queues_entered_at_once =
    chosen<counts_of<D>.queue_count == 0 ? 0 : counts_of<D>.input_count, is_entered_at_once<D, E>>;

// What was published in beat k by calls before `Rank` of the whole enters one of them.
template <class D, int E, int Input, int Rank, class State>
void enter_at_once(State& state, beat_outcome& outcome, std::int64_t k) {
  entries_of_queue<part<D, E>, State, chosen<counts_of<D>.input_count, leads_at_once<D, E, Input, Rank>>>(
      state, k, true)
      .enter(outcome, k);
}

}  // namespace cca::detail
