// The beats in which something can happen in an environment; it sleeps through the others.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <cca/runtime/environments/exchange/crossing.hpp>

namespace cca::detail {

// Clocks of an environment, each once.
template <class D>
struct clocks_of_environment {
  std::array<clock, array_size(graph_size<D>.calls + input_count_of<D>) + 1> all{};
  std::size_t count = 0;

  // A clock that is not known may tick in every beat.
  template <class Others>
  constexpr void add_all(const Others& others) {
    for (std::size_t i = 0; i < others.count; ++i) add(others.all[i]);
  }
  constexpr void add(clock c) {
    if (c.never()) return;
    if (c.dynamic()) c = every(1);
    for (std::size_t i = 0; i < count; ++i)
      if (all[i] == c) return;
    all[count++] = c;
  }
  // The first beat from k on in which one ticks; the largest number: none.
  constexpr std::int64_t next(std::int64_t k) const {
    std::int64_t first = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < count; ++i) {
      const clock& c = all[i];
      const std::int64_t behind = k <= c.first ? 0 : (k - c.first + c.period - 1) / c.period;
      first = std::min(first, c.first + behind * c.period);
    }
    return first;
  }
};

// When its components fire. In the whole graph the clock of a function is known more often than in the part,
// where a sample may come late.
template <class D, int E>
inline constexpr auto environment_clocks = [] {
  clocks_of_environment<D> clocks;
  auto plan = [] {
    if constexpr (has_free_running<D>) return plan_at_wall_clock<D>;
    else return plan_of<D>;
  }();
  const auto g = plan.view();
  for (int c = 0; c < g.call_count; ++c)
    if (environment_of(g, c) == E) clocks.add(g.calls[c].own_clock);
  return clocks;
}();

// In any mode: it does not know before such a beat which one is active then.
template <DeploymentOfModes D, int E>
inline constexpr auto environment_clocks<D, E> = [] {
  clocks_of_environment<D> clocks;
  for_each_deployed_mode<D>([&]<class Mode>() { clocks.add_all(environment_clocks<Mode, E>); });
  return clocks;
}();

// When samples enter its queues that must not wait for it elsewhere, or may be rejected, or that a program
// sees between two runs.
template <class D, int E>
inline constexpr auto entry_clocks = [] {
  clocks_of_environment<D> clocks;
  const auto& plan = plan_of<D>;
  const auto g = plan.view();
  for (int i = 0; i < g.input_count; ++i) {
    const input& in = g.inputs[i];
    if (!is_queued(in) || environment_of(g, in.call) != E) continue;
    const output& from = g.outputs[in.writer];
    if (environment_of(g, from.call) != E || may_fault_at_begin(in) || in.outside)
      clocks.add(shifted(published(g, from), in.delay));
  }
  return clocks;
}();

template <DeploymentOfModes D, int E>
inline constexpr auto entry_clocks<D, E> = [] {
  clocks_of_environment<D> clocks;
  for_each_deployed_mode<D>([&]<class Mode>() { clocks.add_all(entry_clocks<Mode, E>); });
  return clocks;
}();

// The first beat from k on in which something can fire; the largest number: none.
template <class D, int E>
constexpr std::int64_t next_firing_beat(std::int64_t k) {
  return environment_clocks<D, E>.next(k);
}
// Or in which something enters a queue.
template <class D, int E>
constexpr std::int64_t next_active_beat(std::int64_t k) {
  if constexpr (entry_clocks<D, E>.count == 0) return next_firing_beat<D, E>(k);
  else return std::min(next_firing_beat<D, E>(k), entry_clocks<D, E>.next(k));
}

}  // namespace cca::detail
