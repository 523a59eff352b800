// Clocks: when something happens, as far as it is settled at compile time.
#pragma once

#include <cstdint>

#include <cca/component/strategy.hpp>

namespace cca::detail {

// Beats first, first + period, first + 2 period, ...; period 0: never; period -1: known only at run time.
struct clock {
  std::int64_t period = -1;
  std::int64_t first = 0;

  constexpr bool known() const { return period > 0; }
  constexpr bool never() const { return period == 0; }
  constexpr bool dynamic() const { return period < 0; }
  constexpr bool every_beat() const { return period == 1 && first == 0; }
  constexpr std::int64_t phase() const { return first % period; }
  constexpr bool operator==(const clock&) const = default;
};

inline constexpr clock dynamic_clock{-1, 0};
inline constexpr clock never_clock{0, 0};

constexpr clock shifted(clock c, std::int64_t beats) {
  if (c.known()) c.first += beats;
  return c;
}

// Every beat of `part` is one of `whole`.
constexpr bool contains(clock whole, clock part) {
  if (part.never() || whole.every_beat()) return true;
  if (!whole.known() || !part.known()) return false;
  return part.period % whole.period == 0 && part.first >= whole.first &&
         (part.first - whole.first) % whole.period == 0;
}

// The clocks of two ends of a wire differ: other periods, or other phases.
constexpr bool differ(clock a, clock b) {
  return a.known() && b.known() && (a.period != b.period || a.phase() != b.phase());
}

constexpr clock union_of(clock a, clock b) {
  if (contains(a, b)) return a;
  if (contains(b, a)) return b;
  return dynamic_clock;
}

constexpr std::int64_t gcd(std::int64_t a, std::int64_t b) {
  while (b != 0) {
    const auto r = a % b;
    a = b;
    b = r;
  }
  return a;
}

// The beats of both, for clocks that start in their first period (Chinese remainder theorem).
constexpr clock intersection_of(clock a, clock b) {
  if (a.never() || b.never()) return never_clock;
  if (a.dynamic() || b.dynamic()) return dynamic_clock;
  const auto common = gcd(a.period, b.period);
  if ((a.first - b.first) % common != 0) return never_clock;
  if (contains(a, b)) return b;
  if (contains(b, a)) return a;
  const auto period = a.period / common * b.period;
  auto beat = a.first;
  while ((beat - b.first) % b.period != 0) beat += a.period;
  return {period, beat};
}

constexpr clock clock_of_strategy(const strategy_info& strategy, bool inside = false) {
  switch (strategy.kind) {
    case strategy_kind::timed:
      return {strategy.n, ((strategy.phase % strategy.n) + strategy.n) % strategy.n};
    case strategy_kind::full_speed:
      return {1, 0};
    case strategy_kind::inactive:
      return never_clock;
    // Alone it counts from its own last firing; with others it depends on them.
    case strategy_kind::timeout:
      return inside ? dynamic_clock : clock{strategy.n, strategy.n};
    case strategy_kind::any_of: {
      clock any = never_clock;
      for (int i = 0; i < strategy.count; ++i)
        any = union_of(any, clock_of_strategy(*strategy.parts[i], true));
      return any;
    }
    case strategy_kind::all_of: {
      clock all{1, 0};
      for (int i = 0; i < strategy.count; ++i) {
        const auto part = clock_of_strategy(*strategy.parts[i], true);
        if (part.never()) return never_clock;
        all = intersection_of(all, part);
      }
      return all;
    }
    default:
      return dynamic_clock;
  }
}

// Clocks under `all_of` that exclude each other: it never fires, whatever comes.
// Every so many beats, but none.
constexpr bool counts_no_beats(const strategy_info& strategy) {
  if (strategy.kind == strategy_kind::timed || strategy.kind == strategy_kind::timeout) return strategy.n < 1;
  for (int i = 0; is_combined(strategy) && i < strategy.count; ++i)
    if (counts_no_beats(*strategy.parts[i])) return true;
  return false;
}

constexpr bool excludes_itself(const strategy_info& strategy) {
  if (strategy.kind != strategy_kind::all_of && strategy.kind != strategy_kind::any_of) return false;
  for (int i = 0; i < strategy.count; ++i)
    if (excludes_itself(*strategy.parts[i])) return true;
  if (strategy.kind == strategy_kind::any_of) return false;
  for (int i = 0; i < strategy.count; ++i)
    for (int j = 0; j < i; ++j) {
      const auto a = clock_of_strategy(*strategy.parts[i], true),
                 b = clock_of_strategy(*strategy.parts[j], true);
      if (a.known() && b.known() && intersection_of(a, b).never()) return true;
    }
  return false;
}

}  // namespace cca::detail
