// Step 3, listen: binds observers to what their patterns name. An observer reads each of them as over a wire
// of its own, by an input after those of all ports, so the steps that follow know nothing of observers. What
// a graph itself observes is marked: it can be read between beats. Where it says how, by a
// policy, the program reads it by an input of its own.
//
// Asks the rules about patterns. Cost: none in a graph that observes nothing.
#pragma once

#include <cca/graph/plan/patterns.hpp>
#include <cca/graph/planning/steps/connect.hpp>

namespace cca::detail {

struct listener {
  flat_view g;
  names_of_ports names{g};

  constexpr void hear(int observer, int writer, int shown, ref<item_info> as) {
    const auto& own = g.inputs[observer];
    const auto& policy = port_of(g, own).policy();
    const int reader = g.input_count++;
    g.inputs[reader] = {.call = own.call, .port = own.port};
    const int heard = read(reader, writer, shown, policy);
    g.links[g.link_count++] = {observer, heard, shown, as};
  }

  // The program hears it, where its writer is, or the queue that shows it.
  constexpr void watch(const item_info& item, int writer, int shown, ref<item_info> as) {
    const int reader = g.input_count++;
    const bool is_queue = shown >= 0 && is_queued(g.inputs[shown]);
    g.inputs[reader] = {.call = is_queue ? g.inputs[shown].call : g.outputs[writer].call, .outside = true};
    const int heard = read(reader, writer, shown, item);
    g.links[g.link_count++] = {reader, heard, shown, as};
  }

  // Returns the output that is read.
  constexpr int read(int reader, int writer, int shown, const item_info& policy) {
    auto& in = g.inputs[reader];
    if (shown < 0) {
      bind_wire(g, writer, reader, policy);
      if (policy.has_queue()) in.queue = g.queue_count++;
      return writer;
    }
    // What another input shows: the same sample, as late as there.
    const auto& from = g.inputs[shown];
    in.initial = from.initial;
    if (!is_queued(from)) {
      bind_wire(g, writer, reader, *from.wire);
      in.delay += policy.delay;
    } else if (policy.delay == 0) {  // what waits in a queue is read from there
      in.writer = writer;
      in.wire = from.wire;
      in.delay = from.delay;
      in.shows = shown;
    } else {  // what was taken from it
      writer = taken_from(shown);
      bind_wire(g, writer, reader, *from.wire);
      in.delay = policy.delay;
    }
    return writer;
  }

  // The output that tells what an input takes from its queue.
  constexpr int taken_from(int shown) {
    const auto& from = g.inputs[shown];
    for (int o = g.output_count - g.taken_count; o < g.output_count; ++o)
      if (g.outputs[o].call == from.call && g.outputs[o].port == from.port) return o;
    g.outputs[g.output_count] = {.call = from.call, .port = from.port, .is_taken = true};
    g.calls[from.call].tells_taken = true;
    ++g.taken_count;
    return g.output_count++;
  }

  constexpr void add_observer(int i) {
    const auto& port = port_of(g, g.inputs[i]);
    const auto& t = g.calls[g.inputs[i].call];
    const finding facts{.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .input = i};
    check<when::observer_policy>(g, facts);
    const int heard =
        for_each_named(g, names, port.name, facts.scope, g.inputs[i].call,
                       [&](int writer, int input, ref<item_info> as) { hear(i, writer, input, as); });
    g.inputs[i].wired = heard > 0;
    if (heard == 0) check<when::unheard_pattern>(g, facts);
  }

  constexpr void add_watch(const item_info& item, int in_scope) {
    const finding facts{.item = &item, .scope = in_scope};
    check<when::observer_policy>(g, facts);
    const auto mark = [](auto& port, ref<item_info> as) {
      if (!port.watched) port.watched_as = as;
      port.watched = true;
    };
    const int heard =
        for_each_named(g, names, item.from, in_scope, -1, [&](int writer, int input, ref<item_info> as) {
          if (item.has_policy()) watch(item, writer, input, as);
          if (input < 0) mark(g.outputs[writer], as);
          else if (!item.has_policy()) mark(g.inputs[input], as);
          if (input < 0) g.outputs[writer].watched_newest |= !item.has_policy();
        });
    if (heard == 0) check<when::unheard_pattern>(g, facts);
  }

  // What it asks for, in the functions that observe.
  constexpr void check_paths(int node) {
    const auto& item = *g.nodes[node].item;
    const auto& component = *item.component;
    const int scope = g.nodes[node].scope;
    for (int c = g.nodes[node].first_call; c < g.nodes[node].first_call + g.nodes[node].call_count; ++c) {
      bool observes = false;
      for_each_observer(g, c, [&](const input&) { observes = true; });
      for (int p = 0; observes && p < component.asked_path_count; ++p) {
        const auto& asked = component.asked_paths[p];
        const int link = link_at(g, c, asked.path, scope);
        check<when::asked_path>(g, {.item = &item,
                                    .scope = scope,
                                    .call = c,
                                    .input = link < 0 ? -1 : g.first_link + link,
                                    .output = link < 0 ? -1 : g.links[link].output,
                                    .axis = asked.axis,
                                    .name = asked.path});
      }
    }
  }

  constexpr void run() {
    for (int s = 0; s < g.scope_count; ++s)
      for (int i = 0; i < g.scopes[s].graph->count; ++i)
        if (const auto& item = g.scopes[s].graph->items[i]; item.kind == item_kind::observe)
          add_watch(item, s);
    for (int i = 0; i < g.first_link; ++i)
      if (!port_of(g, g.inputs[i]).space) add_observer(i);
    for (int n = 0; n < g.node_count; ++n)
      if (g.nodes[n].item->component->asked_path_count > 0) check_paths(n);
  }
};

// How many links the observers of a connected graph have, and at most how many of them hear what was taken
// from a queue.
struct heard_count {
  int links = 0, taken = 0;

  constexpr heard_count& operator+=(const heard_count& other) {
    links += other.links;
    taken += other.taken;
    return *this;
  }
};
constexpr heard_count count_heard(const flat_view& g) {
  heard_count count;
  const names_of_ports names(g);
  const auto counter = [&](bool is_delayed) {
    return [&count, &g, is_delayed](int, int shown, ref<item_info>) {
      ++count.links;
      count.taken += is_delayed && shown >= 0 && is_queued(g.inputs[shown]);
    };
  };
  for (int i = 0; i < g.first_link; ++i) {
    const auto& in = g.inputs[i];
    if (const auto& port = port_of(g, in); !port.space)
      for_each_named(g, names, port.name, scope_of_call(g, g.calls[in.call]), in.call,
                     counter(port.policy().delay > 0));
  }
  for (int s = 0; s < g.scope_count; ++s)
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (const auto& item = g.scopes[s].graph->items[i];
          item.kind == item_kind::observe && item.has_policy())
        for_each_named(g, names, item.from, s, -1, counter(item.delay > 0));
  return count;
}

// The step.
constexpr flat_view listen(flat_view g) {
  listener step{.g = g};
  step.run();
  return step.g;
}

}  // namespace cca::detail
