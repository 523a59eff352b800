// Can the inputs of a function ever hold samples of one time of origin? Where all clocks before it are known,
// the origins are followed through the beats of two common periods; elsewhere the answer is yes.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

struct origin_search {
  const flat_view& g;

  // Marks a function and all functions that feed it; false if one of them can't be followed.
  constexpr bool mark(int call_index, scratch& marked, bool is_last = true) const {
    if (marked[call_index]) return marked[call_index] == 1;
    const auto& t = g.calls[call_index];
    marked[call_index] = is_last ? 2 : 1;  // if the last one is reached again, it feeds itself
    if (!is_last && t.fires.dynamic()) return false;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) {
      const auto& in = g.inputs[i];
      if (!port_of(g, in).space || in.queue >= 0) return false;
      if (in.writer < 0) continue;
      if (port_of(g, g.outputs[in.writer]).maybe || !mark(g.outputs[in.writer].call, marked, false))
        return false;
    }
    return true;
  }

  // Beats to follow, or 0 if that would take too long.
  constexpr int horizon(const scratch& marked) const {
    std::int64_t common = 1, first = 0;
    int functions = 0;
    for (int t = 0; t < g.call_count; ++t) {
      if (marked[t] != 1) continue;
      ++functions;
      const auto& c = g.calls[t].fires;
      if (!c.known()) continue;
      common = common / gcd(common, c.period) * c.period;
      first = c.first > first ? c.first : first;
      for (int i = g.calls[t].first_input; i < g.calls[t].first_input + g.calls[t].function->input_count; ++i)
        first += g.inputs[i].delay;
      if (common > 10'000) return 0;
    }
    const auto beats = first + 2 * common + 64;
    return beats * (functions + 1) > 40'000 ? 0 : static_cast<int>(beats);
  }

  constexpr bool never_shared(int call_index) const {
    const auto& t = g.calls[call_index];
    scratch marked(g.call_count);
    if (!mark(call_index, marked)) return false;
    const int beats = horizon(marked);
    if (beats == 0) return false;

    // For each output and beat: the beat in which its newest sample originates; -1: no sample.
    scratch column(g.output_count, -1);
    int columns = 0;
    for (int o = 0; o < g.output_count; ++o)
      if (marked[g.outputs[o].call] == 1) column[o] = columns++;
    scratch origins(columns * beats, -1);
    const auto seen = [&](const input& in, int k) {
      const int from = k - in.delay;
      return in.writer < 0 || from < 0 ? -1 : origins[column[in.writer] * beats + from];
    };
    for (int k = 0; k < beats; ++k) {
      for (int r = 0; r < g.call_count; ++r) {
        const int index = g.order[r];
        if (marked[index] != 1) continue;
        const auto& from = g.calls[index];
        int origin = -1;
        for (int i = from.first_input; i < from.first_input + from.function->input_count; ++i) {
          const int one = g.inputs[i].counts ? seen(g.inputs[i], k) : -1;
          if (one >= 0 && (origin < 0 || one < origin)) origin = one;
        }
        for (int o = from.first_output; o < from.first_output + from.function->output_count; ++o) {
          auto& newest = origins[column[o] * beats + k];
          if (k > 0) newest = origins[column[o] * beats + k - 1];
          if (ticks(from.fires, k)) newest = origin < 0 ? k : origin;
        }
      }
      int common = -1;
      bool together = true;
      for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) {
        if (g.inputs[i].writer < 0) continue;
        const int one = seen(g.inputs[i], k);
        if (common < 0) common = one;
        together = together && one >= 0 && one == common;
      }
      if (together) return false;
    }
    return true;
  }
};

constexpr bool never_share_origin(const flat_view& g, int call_index) {
  return origin_search{g}.never_shared(call_index);
}

}  // namespace cca::detail
