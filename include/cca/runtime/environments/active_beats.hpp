// The beats in which something can fire in an environment; it sleeps through the others.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <cca/runtime/environments/crossing.hpp>

namespace cca::detail {

// The clocks of an environment, each once. In the whole graph the clock of a function is known more often
// than in the part, where a sample may come late.
template <class D>
struct clocks_of_environment {
  std::array<clock, array_size(graph_size<D>.calls) + 1> all{};
  std::size_t count = 0;
};

template <class D, int E>
inline constexpr auto environment_clocks = [] {
  clocks_of_environment<D> clocks;
  auto plan = plan_of<D>;
  const auto g = plan.view();
  for (int c = 0; c < g.call_count; ++c) {
    const clock fires = g.calls[c].own_clock.dynamic() ? every(1) : g.calls[c].own_clock;
    if (environment_of(g, c) != E || fires.never()) continue;
    bool is_new = true;
    for (std::size_t i = 0; i < clocks.count; ++i) is_new = is_new && !(clocks.all[i] == fires);
    if (is_new) clocks.all[clocks.count++] = fires;
  }
  return clocks;
}();

// The first beat from k on in which something can fire; the largest number: none.
template <class D, int E>
constexpr std::int64_t next_active_beat(std::int64_t k) {
  std::int64_t next = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < environment_clocks<D, E>.count; ++i) {
    const clock& c = environment_clocks<D, E>.all[i];
    const std::int64_t behind = k <= c.first ? 0 : (k - c.first + c.period - 1) / c.period;
    next = std::min(next, c.first + behind * c.period);
  }
  return next;
}

}  // namespace cca::detail
