// A clock: the beats in which something happens, as far as they are known at compile time.
#pragma once

#include <cstdint>

#include <cca/base/compiler.hpp>

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

// Every `period` beats, where the phase may be any number. Less than one beat is no clock: `never_clock`.
constexpr clock every(std::int64_t period, std::int64_t phase = 0) {
  if (period < 1) return never_clock;
  return {period, ((phase % period) + period) % period};
}

constexpr bool ticks(clock c, std::int64_t k) {
  return c.known() && k >= c.first &&
         static_cast<std::uint64_t>(k - c.first) % static_cast<std::uint64_t>(c.period) == 0;
}

constexpr clock shifted(clock c, std::int64_t beats) {
  if (c.known()) c.first += beats;
  return c;
}

// Is every beat of `part` a beat of `whole`?
constexpr bool contains(clock whole, clock part) {
  if (part.never() || whole.every_beat()) return true;
  if (!whole.known() || !part.known()) return false;
  return part.period % whole.period == 0 && part.first >= whole.first &&
         (part.first - whole.first) % whole.period == 0;
}

// Do two known clocks differ in period or phase?
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

// The beats that both have. The clocks start in their first period (Chinese remainder theorem).
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

}  // namespace cca::detail
