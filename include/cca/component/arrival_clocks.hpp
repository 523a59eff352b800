// Clocks of strategies that fire when samples arrive.
#pragma once

#include <string_view>

#include <cca/component/strategy.hpp>

namespace cca::detail {

// The beats in which any of the chosen inputs is fresh. Samples wait in an input until the component fires,
// so the beats of arrival are those of firing.
template <class IsChosen>
constexpr clock any_arrival(const arrivals& inputs, IsChosen is_chosen) {
  clock any = never_clock;
  bool queued = false, all_equal = true, first = true;
  for (const auto& input : inputs) {
    if (!is_chosen(input.input)) continue;
    if (input.when.every_beat() && !input.queued) return input.when;
    all_equal &= first || input.when == any;
    any = first ? input.when : union_of(any, input.when);
    queued |= input.queued;
    first = false;
  }
  return queued && !all_equal ? dynamic_clock : any;
}

constexpr clock any_arrival(const arrivals& inputs) {
  return any_arrival(inputs, [](std::string_view) { return true; });
}

// The beats in which all inputs are fresh. If the slowest input is also the last in its first round, the
// component fires with that one.
constexpr clock every_arrival(const arrivals& inputs) {
  clock slowest = never_clock;
  bool queued = false, all_equal = true, known = true;
  std::int64_t last_start = 0;
  for (const auto& input : inputs) {
    const clock arrival = input.when;
    if (arrival.never()) return never_clock;
    known &= arrival.known();
    if (slowest.known()) all_equal &= arrival == slowest;
    queued |= input.queued;
    last_start = arrival.first > last_start ? arrival.first : last_start;
    if (arrival.period > slowest.period ||
        (arrival.period == slowest.period && arrival.first > slowest.first))
      slowest = arrival;
  }
  return known && slowest.first == last_start && (!queued || all_equal) ? slowest : dynamic_clock;
}

}  // namespace cca::detail
