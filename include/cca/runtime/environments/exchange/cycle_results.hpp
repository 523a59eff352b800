// What the cycles of a free-running environment publish, on its way to the beat in a wall-clock run: of each
// output the newest sample, and for queues all of them (gathered_samples.hpp). One writer, its thread; one
// reader, the first environment, when a beat begins. Both are wait-free: each has a slot of its own, and they
// exchange it for the one in between. All samples of a cycle come together, and a sample that a later cycle
// does not publish again is not lost.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>
#include <cca/runtime/environments/exchange/crossing.hpp>
#include <cca/runtime/environments/exchange/gathered_samples.hpp>

namespace cca::detail {

// The outputs of environment E that others read.
template <class D, int E>
struct leaves_from {
  static constexpr bool holds(std::size_t o) {
    const auto& plan = plan_of<D>;
    return crossings_of<D>.largest_delay[o] > 0 && environment_of(plan.view(), plan.outputs[o].call) == E;
  }
};
template <class D, int E>
using outputs_leaving = chosen<counts_of<D>.output_count, leaves_from<D, E>>;

// The outputs of all free-running environments that others read.
template <class D, class Free = free_environments<D>>
struct leaves_freely;
template <class D, int... E>
struct leaves_freely<D, std::integer_sequence<int, E...>> {
  static constexpr bool holds([[maybe_unused]] std::size_t o) { return (leaves_from<D, E>::holds(o) || ...); }
};

// Of a set of modes: the first sample since the component came the last time. What it has published before is
// not read.
template <bool HasModes>
struct stay_of_component {
  static constexpr std::uint64_t first = 0;
};
template <>
struct stay_of_component<true> {
  std::uint64_t first = 0;
};
// Of an output the samples that queues in other environments take; else nothing.
template <class D, int Output>
struct no_gathered_samples {
  void put(std::int64_t, const auto&) {}
  void follow(const no_gathered_samples&, bool, std::uint64_t) {}
  static std::uint64_t end() { return 0; }
  static constexpr stay_of_component<false> stay{};
  void begin_stay() {}
  void keep_stay(std::uint64_t) {}
};
template <class D, int Output>
struct gathered_of_output : gathered_samples<size_of_output<D, Output>, most_waiting<D, Output>> {
  [[no_unique_address]] stay_of_component<DeploymentOfModes<D>> stay;

  void begin_stay() { stay.first = this->end(); }
  void keep_stay(std::uint64_t number) { stay.first = std::max(stay.first, number); }
  void follow(const gathered_of_output& newer, bool is_taken, std::uint64_t taken) {
    stay = newer.stay;
    gathered_samples<size_of_output<D, Output>, most_waiting<D, Output>>::follow(newer, is_taken, taken);
  }
  template <class Vector>
  void put(std::int64_t origin, const Vector& v) {
    this->put_numbered(this->end(), origin, v);
  }
};
template <class D, int Output>
using gathered_or_none =
    std::conditional_t<is_gathered<D, Output>, gathered_of_output<D, Output>, no_gathered_samples<D, Output>>;

// Of a set of modes: the beat in which the cycle began that published it.
template <bool HasModes>
struct beat_of_cycle {
  void begin_in(std::int64_t) {}
};
template <>
struct beat_of_cycle<true> {
  std::int64_t began_in = -1;
  void begin_in(std::int64_t beat) { began_in = beat; }
};

template <class D, int Output>
struct result_of_cycle : beat_of_cycle<DeploymentOfModes<D>> {
  static constexpr int size = size_of_output<D, Output>;

  std::uint64_t cycle = 0;  // in which it was published; 0: never
  std::int64_t origin = 0;
  std::array<double, array_size(size)> coordinates{};

  auto vector() const { return Eigen::Map<const Eigen::Matrix<double, size, 1>>(coordinates.data()); }
  template <class Vector>
  void put(std::uint64_t in, std::int64_t from, const Vector& v) {
    cycle = in;
    origin = from;
    Eigen::Map<Eigen::Matrix<double, size, 1>>(coordinates.data()) = v;
  }
};

template <class D, int E, class Outputs = outputs_leaving<D, E>>
class cycle_results;
template <class D, int E, int... Output>
class cycle_results<D, E, std::integer_sequence<int, Output...>> {
public:
  struct slot : result_of_cycle<D, Output>..., gathered_or_none<D, Output>... {
    template <int Number>
    auto& gathered() {
      return static_cast<gathered_or_none<D, Number>&>(*this);
    }
    template <int Number>
    const auto& gathered() const {
      return static_cast<const gathered_or_none<D, Number>&>(*this);
    }
    template <int Number>
    auto& at() {
      return static_cast<result_of_cycle<D, Number>&>(*this);
    }
    template <int Number>
    const auto& at() const {
      return static_cast<const result_of_cycle<D, Number>&>(*this);
    }
  };

  // ---- the writer's ----

  // A run begins. What a process that died in a cycle has left in its slot is forgotten; but not which
  // components have come since the last run.
  void begin_run() noexcept {
    [[maybe_unused]] const std::array<std::uint64_t, sizeof...(Output) + 1> stays{
        slots[own].template gathered<Output>().stay.first..., 0};
    slots[own] = slots[newest];
    if constexpr (DeploymentOfModes<D>) {
      [[maybe_unused]] auto stay = stays.begin();
      (slots[own].template gathered<Output>().keep_stay(*stay++), ...);
    }
  }

  // In a cycle that began in this beat.
  template <int Number, class Vector>
  void put(const Vector& v, std::int64_t origin, std::int64_t beat) noexcept {
    slots[own].template at<Number>().put(cycles.load(std::memory_order_relaxed) + 1, origin, v);
    slots[own].template at<Number>().begin_in(beat);
    slots[own].template gathered<Number>().put(origin, v);
    has_news.store(true, std::memory_order_relaxed);
  }
  // Of a set of modes: the component of this output comes.
  template <int Number>
  void begin_stay() noexcept {
    slots[own].template gathered<Number>().begin_stay();
  }
  void end_cycle() noexcept {
    const std::uint64_t cycle = cycles.load(std::memory_order_relaxed) + 1;
    cycles.store(cycle, std::memory_order_relaxed);
    if (!has_news.exchange(false, std::memory_order_relaxed)) return;
    (keep<Output>(cycle), ...);
    hand_over();
  }
  // What came from another process: `fill(slot)` writes all of it.
  template <class F>
  void put_all(F fill) noexcept {
    fill(slots[own]);
    hand_over();
  }

  // ---- the reader's ----

  // The newest results; null: those that it has. They stay until the next call.
  const slot* take() noexcept {
    if (!(between.load(std::memory_order_relaxed) & fresh)) return nullptr;
    taken = between.exchange(taken, std::memory_order_acq_rel) & number;
    return &slots[taken];
  }

private:
  static constexpr std::uint32_t number = 3, fresh = 4;

  void hand_over() noexcept {
    [[maybe_unused]] const std::uint32_t before = newest;
    newest = std::uint32_t{own};
    const std::uint32_t got = between.exchange(own | fresh, std::memory_order_acq_rel);
    own = got & number;
    // Nobody changes what was handed over, so it can still be read, also beside the reader.
    (follow<Output>(!(got & fresh), slots[before]), ...);
  }
  // What the reader has not taken yet is in the next slot, too. It has taken what was handed over before the
  // newest.
  template <int Number>
  void follow(bool is_taken, const slot& before) noexcept {
    if constexpr (is_gathered<D, Number>)
      slots[own].template gathered<Number>().follow(slots[newest].template gathered<Number>(), is_taken,
                                                    before.template gathered<Number>().end());
  }

  // An output that this cycle did not publish: its newest sample is in the slot of an earlier one. Nobody
  // changes that one: only the writer fills slots.
  template <int Number>
  void keep(std::uint64_t cycle) noexcept {
    auto& here = slots[own].template at<Number>();
    const auto& last = slots[newest].template at<Number>();
    if (here.cycle != cycle && here.cycle != last.cycle) here = last;
  }

  std::array<slot, 3> slots{};
  std::atomic<std::uint64_t> cycles{0};
  std::atomic<std::uint32_t> own{0}, newest{1}, taken{2};  // slots; atomic only because processes share them
  alignas(64) std::atomic<std::uint32_t> between{1};
  std::atomic<bool> has_news{false};
};

}  // namespace cca::detail
