// What the environments of a deployment share: one block of atomic numbers, in the memory of a process or
// between processes. Each number has one writer. Nobody locks, and a writer never waits for a reader.
//
// A position counts beats and the calls in them: in beat k, behind the call of rank r in the whole graph, it
// is k * calls_and_one + r + 1; when beat k is done it is (k + 1) * calls_and_one.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>

#include <cca/runtime/environments/crossing.hpp>
#include <cca/runtime/environments/histogram.hpp>
#include <cca/runtime/environments/sample_ring.hpp>

namespace cca::detail {

inline constexpr std::int64_t no_position = std::numeric_limits<std::int64_t>::max();

// How many beats an environment may be ahead of those that read from it, and of the first one, as fast as
// possible.
inline constexpr std::int64_t most_ahead = 16;

// Enough for the samples of the beats in which the writer is ahead, and for those that are not due.
constexpr int ring_capacity(int delay) {
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(most_ahead + delay + 2)));
}

template <class D, int Output>
struct leaving_samples {
  sample_ring<size_of_output<D, Output>, ring_capacity(crossings_of<D>.largest_delay[Output])> ring;
};

// One per environment, in a cache line of its own.
template <int Environments>
struct alignas(64) environment_record {
  std::atomic<std::int64_t> position{0};
  // Of the first environment at wall-clock speed: the newest beat begun, when, and the time to the next (ns).
  std::atomic<std::int64_t> begun{-1}, begun_at{0}, interval{0};

  // At wall-clock speed, since start().
  std::atomic<std::int64_t> overruns{0}, lost_periods{0};
  std::array<std::atomic<std::int64_t>, array_size(Environments)> late{};  // what comes from each
  histogram wake_up{}, beat{};

  void forget() {
    overruns = lost_periods = 0;
    for (auto& channel : late) channel = 0;
    wake_up.forget();
    beat.forget();
  }
};

// The writer's.
inline void add(std::atomic<std::int64_t>& number, std::int64_t some) noexcept {
  number.store(number.load(std::memory_order_relaxed) + some, std::memory_order_relaxed);
}

// The first to state a fault is the cause.
struct alignas(64) fault_record {
  std::atomic<std::int64_t> position{no_position};
  std::atomic<const char*> reason{nullptr};
  std::atomic<int> node{-1};

  void state(std::int64_t at, const char* why, int component) noexcept {
    if (is_stated.exchange(true)) return;
    reason.store(why, std::memory_order_relaxed);
    node.store(component, std::memory_order_relaxed);
    position.store(at, std::memory_order_release);
  }
  void forget() noexcept {
    position.store(no_position);
    is_stated.store(false);
  }

private:
  std::atomic<bool> is_stated{false};
};

template <class D, class Outputs = chosen<counts_of<D>.output_count, leaves_environment<D>>>
struct exchange;
template <class D, int... Output>
struct exchange<D, std::integer_sequence<int, Output...>> : leaving_samples<D, Output>... {
  static constexpr std::int64_t calls_and_one = counts_of<D>.order_count + 1;
  static constexpr std::int64_t position_of(std::int64_t beat, int done = 0) {
    return beat * calls_and_one + done;
  }

  std::array<environment_record<environment_count<D>>, array_size(environment_count<D>)> environments{};
  fault_record fault{};
  std::atomic<bool> should_stop{false};  // no further beat

  template <int Number>
  auto& ring() {
    return static_cast<leaving_samples<D, Number>&>(*this).ring;
  }
  std::int64_t position(int environment) const noexcept {
    return environments[array_size(environment)].position.load(std::memory_order_acquire);
  }
  void move_to(int environment, std::int64_t position) noexcept {
    environments[array_size(environment)].position.store(position, std::memory_order_release);
  }
};

}  // namespace cca::detail
