// The greatest age, in beats, that a sample of an output can have when a function reads it at an input: over
// all ways that close no loop; unbounded if a clock on a way is known only at run time.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

struct latency_search {
  const flat_view& g;
  int from;         // an output
  scratch way;      // inputs on the way, from the last one back
  scratch visited;  // components on the way
  int length = 0;
  std::int64_t oldest = 0;
  bool unbounded = false;

  constexpr latency_search(const flat_view& graph, int output_index)
      : g(graph), from(output_index), way(graph.node_count), visited(graph.node_count) {}

  // The newest beat, up to k, in which the writer of an input published what the input shows in beat k.
  constexpr std::int64_t published_by(const input& in, std::int64_t k, clock writer, clock reader) const {
    if (is_merged(in)) return waited_longest(in, k, writer, reader);
    const auto newest = k - in.delay;
    auto tick = newest - ((newest - writer.first) % writer.period);
    // A queue that fills faster than it is read is full: the reader takes the oldest sample in it.
    if (in.queue >= 0 && reader.known() && writer.period < reader.period) {
      if (in.wire->full == full_kind::drop_oldest) {
        tick -= (in.wire->capacity - 1) * writer.period;
      } else {
        // The sample arrived right after that.
        const auto taken_before = newest - in.wire->capacity * reader.period;
        tick = taken_before - ((taken_before - writer.first) % writer.period) + writer.period;
      }
    }
    // A queue that is first read late stays as full as it was then: each read takes a sample while another
    // arrives.
    const auto first_arrival = writer.first + in.delay;
    if (in.queue >= 0 && reader.known() && writer.period == reader.period && reader.first > first_arrival) {
      const auto waiting = (reader.first - first_arrival) / writer.period;
      tick -= (in.wire->full == full_kind::drop_oldest && waiting >= in.wire->capacity ? in.wire->capacity - 1
                                                                                       : waiting) *
              writer.period;
    }
    return tick;
  }

  // Where several wires fill a queue: its sample is read at the latest when the queue has been read as often
  // as it has room. So this may be more than the greatest age, but never less.
  constexpr std::int64_t waited_longest(const input& in, std::int64_t k, clock writer, clock reader) const {
    const auto oldest_arrival = k - in.wire->capacity * reader.period + 1;
    const auto earliest = oldest_arrival - in.delay - writer.first;
    return earliest <= 0 ? writer.first
                         : writer.first + (earliest + writer.period - 1) / writer.period * writer.period;
  }

  constexpr clock writer_clock(const input& in) const { return published(g, g.outputs[in.writer]); }

  // The way is complete: `way[0]` is the input in question, `way[length - 1]` reads the output in question.
  constexpr void measure() {
    std::int64_t start = 0, common = 1;
    for (int w = 0; w < length; ++w) {
      const auto& in = g.inputs[way[w]];
      const auto c = writer_clock(in);
      if (c.never()) return;
      if (c.dynamic()) {
        unbounded = true;
        return;
      }
      if (is_merged(in) && !g.calls[in.call].fires.known()) {
        unbounded = true;
        return;
      }
      start += c.first + 2 * c.period + in.delay;
      if (in.queue >= 0) start += in.wire->capacity * (c.period + 2 * g.calls[in.call].fires.period);
      common = common / gcd(common, c.period) * c.period;
    }
    auto last = g.calls[g.inputs[way[0]].call].fires;
    if (last.never()) return;
    if (last.dynamic()) last = {1, 0};  // it may fire in any beat
    common = common / gcd(common, last.period) * last.period;
    for (auto k = last.first + ((start + common) / last.period + 1) * last.period, end = k + common; k < end;
         k += last.period) {
      auto at = k;
      clock reader = last;
      for (int w = 0; w < length; ++w) {
        const auto c = writer_clock(g.inputs[way[w]]);
        at = published_by(g.inputs[way[w]], at, c, reader);
        reader = c;
      }
      oldest = k - at > oldest ? k - at : oldest;
    }
  }

  constexpr void follow(int input_index) {
    for (int i = input_index; i >= 0; i = g.inputs[i].next_way) follow_way(i);
  }
  constexpr void follow_way(int input_index) {
    const auto& in = g.inputs[input_index];
    if (in.writer < 0) return;
    way[length++] = input_index;
    if (in.writer == from) {
      measure();
    } else {
      const auto& t = g.calls[g.outputs[in.writer].call];
      if (!visited[t.node]) {
        visited[t.node] = 1;
        for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) follow(i);
        visited[t.node] = 0;
      }
    }
    --length;
  }
};

struct greatest {
  std::int64_t beats = 0;
  bool unbounded = false;
};

constexpr greatest greatest_age(const flat_view& g, int output_index, int input_index) {
  latency_search search(g, output_index);
  search.visited[g.calls[g.inputs[input_index].call].node] = 1;
  search.follow(input_index);
  return {search.oldest, search.unbounded};
}

}  // namespace cca::detail
