// A queue that several wires fill: whether it overflows, where clocks prove it. It is followed beat by beat
// through two common periods; what arrives at beats known only at run time can only fill it more.
#pragma once

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

struct merged_queue {
  const flat_view& g;
  int input_index;

  static constexpr std::int64_t longest = 40'000;  // beats that a compiler follows in reasonable time

  template <class F>
  constexpr void for_each_arrival(F f) const {
    for_each_way(g, input_index, [&](const input& way) {
      if (const clock c = published(g, g.outputs[way.writer]); c.known()) f(shifted(c, way.delay));
    });
  }

  constexpr bool overflows() const {
    const auto& in = g.inputs[input_index];
    clock reader = g.calls[in.call].fires;
    if (reader.dynamic()) reader = {1, 0};  // at best
    std::int64_t common = reader.never() ? 1 : reader.period, first = reader.never() ? 0 : reader.first;
    int known = 0;
    double come = 0;  // in a beat
    for_each_arrival([&](clock c) {
      ++known;
      come += 1.0 / static_cast<double>(c.period);
      common = common > longest ? common : common / gcd(common, c.period) * c.period;
      first = c.first > first ? c.first : first;
    });
    if (known == 0) return false;
    if (reader.never() || come > 1.0 / static_cast<double>(reader.period) + 1e-9) return true;
    if (common > longest || (first + 2 * common) * known > longest) return false;
    std::int64_t waiting = 0;
    for (std::int64_t k = 0; k < first + 2 * common; ++k) {
      for_each_arrival([&](clock c) { waiting += ticks(c, k); });
      if (waiting > in.wire->capacity) return true;
      if (waiting > 0 && ticks(reader, k)) --waiting;
    }
    return false;
  }
};

}  // namespace cca::detail
