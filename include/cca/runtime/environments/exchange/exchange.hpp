// What the environments of a deployment share: one block of atomic numbers, in the memory of a process or
// between processes. Each number has one writer. Nobody locks, and a writer never waits for a reader.
//
// A position counts beats and the calls in them: in beat k, after the call of rank r in the whole graph, it
// is k * calls_and_one + r + 1; when beat k is done it is (k + 1) * calls_and_one. Queues that may reject
// what arrives when a beat begins count as calls before the first.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>
#include <string_view>

#include <cca/runtime/environments/exchange/crossing.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>
#include <cca/runtime/environments/exchange/histogram.hpp>
#include <cca/runtime/environments/exchange/first_samples.hpp>
#include <cca/runtime/environments/exchange/sample_ring.hpp>
#include <cca/runtime/environments/exchange/bell.hpp>

namespace cca::detail {

inline constexpr std::int64_t no_position = std::numeric_limits<std::int64_t>::max();

// Which environments this process runs.
template <class D>
using environments_here = std::array<bool, array_size(environment_count<D>)>;

// Enough for the samples of the beats in which the writer is ahead, and for those that are not due; and for
// all that a queue may hold, if its environment stands still in a wall-clock run.
template <class D, int Output>
inline constexpr int ring_capacity = static_cast<int>(std::bit_ceil(
    static_cast<unsigned>(most_ahead<D> + largest_delay_of<D, Output> + 2 + most_waiting<D, Output>)));

template <class D, int Output>
using ring_of_output =
    sample_ring<size_of_leaving<D, Output>, ring_capacity<D, Output>, (most_waiting<D, Output> > 0)>;

template <class D, int Output>
struct leaving_samples {
  ring_of_output<D, Output> ring;
};
// Of a free-running environment also those of a wall-clock run, with the beats in which they arrived. The
// first environment writes them.
template <class D, int Output>
  requires(is_of_free_running<D, Output> && !is_gathered<D, Output>)
struct leaving_samples<D, Output> {
  ring_of_output<D, Output> ring, arrived;
};
// Where a queue takes them, all of them and not only the newest of a beat. Their last coordinate is the
// number that the output gave them: several of one beat may be missing (gathered_samples.hpp).
template <class D, int Output>
inline constexpr int gathered_capacity = static_cast<int>(
    std::bit_ceil(static_cast<unsigned>(2 * most_waiting<D, Output> * (largest_delay_of<D, Output> + 2))));
template <class D, int Output>
  requires(is_gathered<D, Output>)
struct leaving_samples<D, Output> {
  ring_of_output<D, Output> ring, arrived;
  sample_ring<size_of_output<D, Output> + 1, gathered_capacity<D, Output>> gathered;
};
// Of a way into a queue that keeps what came first.
template <class D, int Way>
struct kept_on_way {
  static constexpr int output = input_of<D, Way>.writer;
  first_samples<size_of_output<D, output> + (is_gathered<D, output> ? 1 : 0), input_of<D, Way>.wire->capacity>
      kept;
};
template <class D, int E>
struct leaving_results {
  cycle_results<D, E> results;
};

// Where a beat begins with samples that a full queue must not reject: how many such queues there are. They
// come before all calls.
template <class D>
inline constexpr int rejecting_entries = [] {
  int count = 0;
  for (std::size_t i = 0; i < array_size(counts_of<D>.input_count); ++i)
    count += may_reject_entries(plan_of<D>, static_cast<int>(i));
  return count;
}();

// How many numbers a beat has in a position: of a set of modes enough for each of them.
template <class D>
inline constexpr std::int64_t positions_in_beat = rejecting_entries<D> + counts_of<D>.order_count + 1;
template <DeploymentOfModes D>
inline constexpr std::int64_t positions_in_beat<D> = [] {
  std::int64_t most = 0;
  for_each_deployed_mode<D>([&]<class Mode>() { most = std::max(most, positions_in_beat<Mode>); });
  return most;
}();

// Why an environment ended a run, and where.
struct fault_record {
  static constexpr std::size_t most_letters = 120;
  std::atomic<std::int64_t> position{no_position};
  std::array<char, most_letters> reason{};  // written before the position is
  std::int32_t node = -1;

  // The first one of a run counts.
  void state(std::int64_t at, std::string_view why, int component) noexcept {
    if (position.load(std::memory_order_relaxed) != no_position) return;
    reason = {};
    std::ranges::copy(why.substr(0, most_letters - 1), reason.begin());
    node = component;
    position.store(at, std::memory_order_release);
  }
};

// The beat in which an environment needed most time in this run, in a wall-clock run. One that hangs is in
// it.
struct slowest_beat {
  std::atomic<std::int64_t> beat{-1}, needed{0};    // ns
  std::atomic<std::int64_t> running{-1}, since{0};  // since: 0, between two beats

  void forget() noexcept { beat = running = -1, needed = since = 0; }
  void begin(std::int64_t k, std::int64_t now) noexcept {
    running.store(k, std::memory_order_relaxed);
    since.store(now, std::memory_order_relaxed);
  }
  void end(std::int64_t k, std::int64_t took) noexcept {
    since.store(0, std::memory_order_relaxed);
    if (took <= needed.load(std::memory_order_relaxed)) return;
    needed.store(took, std::memory_order_relaxed);
    beat.store(k, std::memory_order_relaxed);
  }
};

// The numbers of an environment: written by it, read by all.
template <int Environments>
struct alignas(64) environment_record {
  std::atomic<std::int64_t> position{0};

  // The clock of the first environment in a wall-clock run: the newest beat begun, when, and the time to the
  // next (ns). `begun_at` is of the even and of the odd beats: who reads `begun` finds the time of that beat.
  std::atomic<std::int64_t> begun{-1}, interval{0};
  std::array<std::atomic<std::int64_t>, 2> begun_at{};
  static std::size_t slot_of(std::int64_t beat) { return static_cast<std::size_t>(beat & 1); }

  // On a cache line of its own: all poll it while they wait, and it is not written meanwhile.
  alignas(64) fault_record fault{};
  std::atomic<std::int64_t> stop_at{no_position};  // no environment begins this beat, or a later one

  // How a run begins and ends together (meeting.hpp): numbers of runs, and what it wants of the run.
  std::atomic<std::int64_t> arrived{0}, ready{0}, finished{0};
  std::atomic<std::int64_t> beat{0}, length{0};
  std::atomic<bool> is_exact{true}, all_meet{false};
  std::atomic<std::int64_t> stopped{0};  // by stop(), which was the n-th since its last run; 0: it is not
  std::atomic<bool> is_paused{false};    // of the first: it begins no beat for now

  // In a wall-clock run, since start().
  std::atomic<std::int64_t> overruns{0}, lost_periods{0};
  std::array<std::atomic<std::int64_t>, array_size(Environments)> late{};  // what comes from each
  histogram wake_up{}, duration{};
  slowest_beat slowest{};

  void forget_figures() {
    overruns = lost_periods = 0;
    for (auto& channel : late) channel = 0;
    wake_up.forget();
    duration.forget();
  }
};

// By the only writer.
inline void add(std::atomic<std::int64_t>& number, std::int64_t some) noexcept {
  number.store(number.load(std::memory_order_relaxed) + some, std::memory_order_relaxed);
}

// Of a set of modes: the active mode of each environment between two runs, and how many switches there were.
// The environment with most of them knows the mode of all.
template <class D>
struct modes_between_runs {};
template <DeploymentOfModes D>
struct modes_between_runs<D> {
  struct record {
    std::atomic<std::int64_t> mode{0}, switches{0};
  };
  std::array<record, array_size(environment_count<D>)> modes{};
};

// What was asked of parts between two runs, by each environment, where other processes run them: it has
// effect when the next run begins. A part that is stopped and started begins anew.
enum wish_for_part : std::int64_t {
  no_wish,
  wish_to_start,
  wish_to_stop,
  wish_to_stop_and_start,
  wish_to_start_and_stop
};
template <class D, bool HasParts = (counts_of<D>.part_count > 0 && environment_count<D> > 1)>
struct parts_between_runs {};
template <class D>
struct parts_between_runs<D, true> {
  using record = std::array<std::atomic<std::int64_t>, array_size(counts_of<D>.part_count)>;
  std::array<record, array_size(environment_count<D>)> wishes{};
};

template <class D,
          class Outputs = all_that_leaves<D>,
          class Free = free_environments<D>,
          class Keeping = ways_that_keep<D>>
struct exchange;
template <class D, int... Output, int... Free, int... Way>
struct exchange<D,
                std::integer_sequence<int, Output...>,
                std::integer_sequence<int, Free...>,
                std::integer_sequence<int, Way...>> : leaving_samples<D, Output>...,
                                                      leaving_results<D, Free>...,
                                                      kept_on_way<D, Way>...,
                                                      modes_between_runs<D>,
                                                      parts_between_runs<D> {
  static constexpr std::int64_t calls_and_one = positions_in_beat<D>;
  static constexpr std::int64_t position_of(std::int64_t beat, int done = 0) {
    return beat * calls_and_one + done;
  }

  std::array<environment_record<environment_count<D>>, array_size(environment_count<D>)> environments{};
  // Rings when an environment makes no further beats, and when a transport brings such news: a follower that
  // sleeps until its next beat wakes.
  alignas(64) bell_between_processes ends{};

  template <int Number>
  auto& ring() {
    return static_cast<leaving_samples<D, Number>&>(*this).ring;
  }
  // What came first on a way into a queue.
  template <int Number>
  auto& first_on_way() {
    return static_cast<kept_on_way<D, Number>&>(*this).kept;
  }
  // An output is published in beat k.
  template <int Number, class Vector>
  CCA_INLINE void put(const Vector& v, std::int64_t origin, std::int64_t k, bool is_exact) noexcept {
    const std::uint64_t number = ring<Number>().put(v, origin, k, is_exact);
    if constexpr (!is_gathered<D, Number>)
      if (!is_exact) keep<Number>(number, v, origin, k);
  }
  // The same of a free-running environment, with its number as last coordinate.
  template <int Number, class Vector>
  void put_gathered(const Vector& v, std::int64_t origin, std::int64_t k) noexcept {
    keep<Number>(gathered<Number>().put(v, origin, k), v, origin, k);
  }
  template <int Number, class Vector>
  CCA_INLINE void keep([[maybe_unused]] std::uint64_t number,
                       [[maybe_unused]] const Vector& v,
                       [[maybe_unused]] std::int64_t origin,
                       [[maybe_unused]] std::int64_t k) noexcept {
    (keep_on_way<Number, Way>(number, v, origin, k), ...);
  }
  template <int Number, int OneWay, class Vector>
  CCA_INLINE void keep_on_way([[maybe_unused]] std::uint64_t number,
                              [[maybe_unused]] const Vector& v,
                              [[maybe_unused]] std::int64_t origin,
                              [[maybe_unused]] std::int64_t k) noexcept {
    if constexpr (kept_on_way<D, OneWay>::output == Number) first_on_way<OneWay>().put(number, v, origin, k);
  }
  template <int Number>
  auto& gathered() {
    return static_cast<leaving_samples<D, Number>&>(*this).gathered;
  }
  // Of a free-running environment, in a wall-clock run: what has arrived, and what its cycles publish.
  template <int Number>
  auto& arrived() {
    return static_cast<leaving_samples<D, Number>&>(*this).arrived;
  }
  template <int E>
  auto& results() {
    return static_cast<leaving_results<D, E>&>(*this).results;
  }
  std::int64_t position(int environment) const noexcept {
    return environments[array_size(environment)].position.load(std::memory_order_acquire);
  }
  // The record with the first fault of this run; without one, any.
  const auto& first_to_fail() const noexcept {
    return *std::ranges::min_element(
        environments, {}, [](const auto& e) { return e.fault.position.load(std::memory_order_acquire); });
  }
  // The first fault of this run; `no_position`: none.
  std::int64_t fault_position() const noexcept {
    std::int64_t first = no_position;
    for (const auto& e : environments)
      first = std::min(first, e.fault.position.load(std::memory_order_acquire));
    return first;
  }
  std::int64_t stop_at() const noexcept {
    std::int64_t first = no_position;
    for (const auto& e : environments) first = std::min(first, e.stop_at.load(std::memory_order_acquire));
    return first;
  }
  void move_to(int environment, std::int64_t position) noexcept {
    environments[array_size(environment)].position.store(position, std::memory_order_release);
  }
};

}  // namespace cca::detail
