// Queues whose samples come from another environment: each is taken out of the ring of its output when it is
// due. In a wall-clock run the ring may have lost some to a reader that stood still; they count as lost by
// the queue.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/queue_entries.hpp>

namespace cca::detail {

// The next sample of a way into a queue, and the beat in which the one before was published.
template <class D, int Way, bool IsFree = false>
struct next_by_way {
  std::uint64_t number = 0;
  std::int64_t newest = -1;
};
// From a free-running environment: also of what has arrived in a wall-clock run.
template <class D, int Way>
struct next_by_way<D, Way, true> : next_by_way<D, Way> {
  std::uint64_t arrived = 0;
};

template <class D, int E, int Way, class State>
  requires(enters<part<D, E>>::holds(std::size_t{Way}))
struct end_of_way<part<D, E>, Way, State> {
  static constexpr const input& in = input_of<part<D, E>, Way>;
  using ring_type = std::remove_cvref_t<decltype(std::declval<exchange<D>&>().template ring<in.writer>())>;

  end_of_way(State& s, std::int64_t k) : state(s) { fetch(k); }

  const typename ring_type::sample* next(std::int64_t) const { return has_come ? &came : nullptr; }
  void enter(beat_outcome& outcome, std::int64_t k) {
    put_into_queue<part<D, E>, Way>(state, outcome, came.vector, came.origin, k);
    fetch(k);
  }

private:
  void fetch(std::int64_t index) {
    std::int64_t k = index;
    if constexpr (is_free_running<D, E>) k = state.beat;
    auto& from = static_cast<next_by_way<D, Way, is_from_free>&>(state);
    has_come = false;
    fetch(state.shared->template ring<in.writer>(), from.number, k);
    if constexpr (is_from_free)
      if (!has_come) fetch(state.shared->template arrived<in.writer>(), from.arrived, k);
  }
  void fetch(const ring_type& ring, std::uint64_t& number, std::int64_t k) {
    // The number bounds a beat beside a writer that goes on publishing: the rest comes in the next one.
    for (; !has_come && left > 0; --left) {
      const std::uint64_t expected = number;
      const bool is_due = ring.take(number, k - in.delay + 1, came);
      const auto lost = static_cast<std::int64_t>(number - expected) - is_due;
      if (lost > 0) queue().lose(lost);
      if (!is_due) return;
      static_cast<next_by_way<D, Way>&>(state).newest = came.published_in;
      has_come = !came.is_repeated;
    }
  }
  auto& queue() const {
    constexpr place at = layout_of<part<D, E>>.sources[Way];
    return sample_in<part<D, E>, at.array>(state, at.index);
  }

  static constexpr bool is_from_free = is_of_free_running<D, in.writer>;

  State& state;
  typename ring_type::sample came;
  bool has_come = false;
  int left = 2 * ring_type::capacity;
};

}  // namespace cca::detail
