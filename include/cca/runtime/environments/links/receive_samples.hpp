// What comes from other environments into the samples that components read: the next of each output, and what
// a free-running environment keeps of time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include <cca/base/inlining.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>

namespace cca::detail {

// The next sample that comes from elsewhere.
template <class D, int Output, bool IsFree = is_of_free_running<D, Output>>
struct next_arrival {
  std::uint64_t number = 0;
  std::int64_t newest = -1;  // the beat in which the one before was published
};
template <class D, int Output>
struct next_arrival<D, Output, true> : next_arrival<D, Output, false> {
  std::uint64_t arrived = 0;  // the same in a wall-clock run
};

// Of a set of modes: what was published before its component came is not read.
template <DeploymentOfModes D, int Output>
struct next_arrival<D, Output, false> {
  std::uint64_t number = 0;
  std::int64_t newest = -1;
  std::int64_t not_before = 0;
};
template <class Next>
CCA_INLINE bool is_older([[maybe_unused]] const Next& next, [[maybe_unused]] std::int64_t published_in) {
  if constexpr (requires { next.not_before; }) return published_in < next.not_before;
  else return false;
}

// What a free-running environment keeps of time.
template <bool IsFree>
struct time_of_cycles {};
template <>
struct time_of_cycles<true> {
  std::int64_t index = 0;        // of the next cycle, and in a fast run of the next beat: none is left out
  std::int64_t beat = 0;         // in which the last one began
  std::int64_t beats_since = 1;  // the one before

  void begin_cycle(std::int64_t in_beat) noexcept {
    beats_since = index == 0 ? 1 : in_beat - beat;
    beat = in_beat;
  }
};

// A part that starts while its environment sleeps asks when the sample came: a fast run has waited for it,
// else it was there as soon as it could be.
inline constexpr std::int64_t arrives_when_published = -1;

// In beat k: what was published before beat `end`, as of index `came`. The state of the part has the links.
template <class D, int E, int Output, class State>
void receive_samples(State& state,
                     next_arrival<whole_of<D>, shared_output_of<D, Output>>& next,
                     std::int64_t k,
                     std::int64_t end,
                     std::int64_t came) noexcept {
  constexpr bool is_free = is_free_running<D, E>;
  constexpr int shared_output = shared_output_of<D, Output>;
  constexpr place at = layout_of<part<D, E>>.outputs[Output];
  auto& samples = sample_in<part<D, E>, at.array>(state, at.index);
  auto& shared = *state.shared;
  const auto& ring = shared.template ring<shared_output>();
  if constexpr (is_free)
    if (end == k) samples.begin(k);
  const auto arrive = [&](const auto& vector, std::int64_t origin, std::int64_t published_in) {
    if (is_older(next, published_in)) return;
    samples.put(vector, origin, published_in, came == arrives_when_published ? published_in : came);
    next.newest = published_in;
  };
  // The number bounds a beat beside a writer that goes on publishing: the rest comes in the next one.
  const auto take_all = [&](const auto& from, std::uint64_t& number, std::int64_t before) {
    using ring_type = std::remove_cvref_t<decltype(from)>;
    typename ring_type::sample one;
    for (int i = 0; i < 2 * ring_type::capacity && from.take(number, before, one); ++i)
      arrive(one.vector, one.origin, one.published_in);
  };
  if (state.is_exact) {
    if constexpr (is_of_free_running<D, Output>)  // of a run before, in a wall-clock run
      take_all(shared.template arrived<shared_output>(), next.arrived, end);
    if (next.newest == end - 1) return;
    const std::uint64_t behind = ring.end_before(next.number, end);
    constexpr std::uint64_t shown =
        crossings_of<whole_of<D>>.largest_delay[shared_output] + 1;  // older ones are not read
    for (std::uint64_t n = std::max(next.number, behind - std::min(behind, shown)); n < behind; ++n)
      ring.show(n, arrive);
    next.number = behind;
    return;
  }
  // A cycle reads what has come. In a beat arrives what a free-running environment has published before it.
  take_all(ring, next.number, is_free ? no_position : end);
  if constexpr (is_of_free_running<D, Output>)
    take_all(shared.template arrived<shared_output>(), next.arrived, is_free ? no_position : end + 1);
}

}  // namespace cca::detail
