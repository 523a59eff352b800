// Step 8, choose the storage: how the samples of each output are stored. It is decided here, once;
// runtime/samples/stored_samples.hpp has a type for each way.
//
//   none      they have no readers except queues
//   of_beat   only read in the beat in which they were published: where the component returned them
//   newest    some reader may come in a later beat: the newest one
//   past      some reader has a delay of more than a beat: the last ones
//   arriving  another loop runs its writer: the last ones that came
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/long_beats.hpp>

namespace cca::detail {

struct storage_step {
  flat_view g;

  // The component fires only when this input has just arrived: it is the only one, and no sample waits.
  constexpr bool fires_with(const input& i) const {
    const auto& c = g.calls[i.call];
    if (!strategy_of_call(g, c).fires_on_arrival || !port_of(g, i).space) return false;
    int wired = 0;
    for (int other = c.first_input; other < c.first_input + c.function->input_count; ++other)
      wired += g.inputs[other].wired;
    return wired == 1;
  }

  // How many samples a reader with a delay needs: one less if it comes before the writer in a beat.
  constexpr int samples_needed(int delay, int reader_call, int writer_call) const {
    return g.calls[reader_call].rank < g.calls[writer_call].rank ? delay : delay + 1;
  }

  // A stored sample begins with the initial value of its first reader; other readers may have their own.
  constexpr void choose_initial(output& out) {
    bool first = true;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      auto& in = g.inputs[i];
      if (!may_show_initial(in) || g.calls[in.call].elsewhere) continue;
      if (first) out.initial_of = in.initial;
      first = false;
      in.own_initial = !same_initial(out.initial_of, in.initial, port_of(g, out).space->size);
    }
  }

  constexpr void choose_storage(int o) {
    auto& out = g.outputs[o];
    int depth = 0;
    bool outlives_beat = out.watched, is_read = out.watched;
    const bool comes_from_elsewhere = g.calls[out.call].elsewhere;
    const auto read_later = [&](int delay, int reader_call) {
      const int needed = comes_from_elsewhere ? delay + 1 : samples_needed(delay, reader_call, out.call);
      depth = needed > depth ? needed : depth;
      outlives_beat = is_read = true;
    };
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      auto& in = g.inputs[i];
      if (in.queue >= 0 || g.calls[in.call].elsewhere) continue;
      is_read = true;
      if (in.watched) {  // it is looked at when the beat is over
        depth = in.delay + 1 > depth ? in.delay + 1 : depth;
        outlives_beat = true;
      }
      if (in.delay > 0 || in.outside) {
        read_later(in.delay, in.call);
      } else {
        const clock published_at = published_to(g, out, in.call);
        const bool is_contained = contains(published_at, g.calls[in.call].own_clock);
        in.known_now = is_contained && published_at.known();
        in.in_beat = is_contained || fires_with(in);
        if (!in.in_beat || !in_one_part(g, in.call, out.call)) outlives_beat = true;
      }
    }

    out.storage = !is_read               ? storage_kind::none
                  : comes_from_elsewhere ? storage_kind::arriving
                  : !outlives_beat       ? storage_kind::of_beat
                  : depth > 1            ? storage_kind::past
                                         : storage_kind::newest;
    if (out.storage == storage_kind::past || out.storage == storage_kind::arriving)
      for (out.depth = 1; out.depth < depth;) out.depth *= 2;
    if (out.storage == storage_kind::newest || out.storage == storage_kind::past) choose_initial(out);
  }
};

// Before the step is made once more, for other clocks or for a part of the graph.
constexpr void forget_storage(flat_view& g) {
  for (int i = 0; i < g.input_count; ++i)
    g.inputs[i].in_beat = g.inputs[i].known_now = g.inputs[i].own_initial = false;
  for (int o = 0; o < g.output_count; ++o) {
    g.outputs[o].storage = storage_kind::none;
    g.outputs[o].depth = 0;
    g.outputs[o].initial_of = nullptr;
  }
}

// The step.
constexpr flat_view choose_storage(flat_view g) {
  storage_step step{g};
  for (int c = 0; c < g.call_count; ++c)
    g.calls[c].stored_seen = uses_coordination(strategy_of_call(g, g.calls[c]));
  for (int i = 0; g.queue_count > 0 && i < g.input_count; ++i)
    g.inputs[i].counts_arrivals = strategy_of_call(g, g.calls[g.inputs[i].call]).counts_arrivals;
  for (int o = 0; o < g.output_count; ++o) step.choose_storage(o);
  return step.g;
}

}  // namespace cca::detail
