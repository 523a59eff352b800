// Queues whose samples come from another environment: each is taken out of the ring of its output when it is
// due. On a clock the ring may have lost some to a reader that stood still; they count as lost by the queue.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange.hpp>
#include <cca/runtime/queue_entries.hpp>

namespace cca::detail {

// The next sample of a way into a queue, and the beat in which the one before was published.
template <class D, int Way>
struct next_by_way {
  std::uint64_t number = 0;
  std::int64_t newest = -1;
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
  void fetch(std::int64_t k) {
    auto& from = static_cast<next_by_way<D, Way>&>(state);
    const auto& ring = state.shared->template ring<in.writer>();
    // The number bounds a beat beside a writer that goes on publishing: the rest comes in the next one.
    for (has_come = false; !has_come && left > 0; --left) {
      const std::uint64_t expected = from.number;
      const bool is_due = ring.take(from.number, k - in.delay + 1, came);
      const auto lost = static_cast<std::int64_t>(from.number - expected) - is_due;
      if (lost > 0) queue().lose(lost);
      if (!is_due) return;
      from.newest = came.published_in;
      has_come = !came.is_repeated;
    }
  }
  auto& queue() const {
    constexpr place at = layout_of<part<D, E>>.sources[Way];
    return sample_in<part<D, E>, at.array>(state, at.index);
  }

  State& state;
  typename ring_type::sample came;
  bool has_come = false;
  int left = 2 * ring_type::capacity;
};

}  // namespace cca::detail
