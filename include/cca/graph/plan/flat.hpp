// The flat graph: every component, input and output of all inner graphs in arrays, depth first in the order
// of declaration. The steps of plan.hpp fill it in. They work on a view of pointers, so they are compiled
// once and not for each graph.
#pragma once

#include <array>
#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/component/strategies.hpp>
#include <cca/graph/plan/finding.hpp>
#include <cca/graph/plan/items.hpp>

namespace cca::detail {

// Facts that a wing hangs on a plan: a type of its own, derived from this.
struct hung_facts {};

// The outermost graph or an inner one; its hash is that of its path.
struct scope {
  int parent = -1;
  ref<item_info> item = nullptr;
  const graph_info* graph = nullptr;
  std::uint64_t hash = 0;
  int part = -1;  // the innermost that may be stopped and has it
};

// A node that may be stopped on its own: a component, or an inner graph as a whole. One around another comes
// first.
struct stoppable_part {
  int parent = -1;  // the next one around it
  const item_info* item = nullptr;
  int scope = 0;              // in which it stands
  std::uint64_t hash = 0;     // of its path
  std::uint64_t members = 0;  // as of a component_node
};

// A component's result that stops or starts a part.
struct part_request {
  int call = 0, part = -1;
  bool starts = false;
};

// A component.
struct component_node {
  const item_info* item = nullptr;
  int scope = 0;
  int first_call = 0, call_count = 0;
  int part = -1;              // the innermost that may be stopped and has it
  int place = -1;             // the loop that runs it, if several run the graph
  std::uint64_t members = 0;  // if the plan is of several graphs: those that have it, a bit for each
};

// One function of a component: `process`, or `sense` and `act` of a resource node.
struct call {
  int node = 0;
  phase_of_beat phase = phase_of_beat::process;
  const function_info* function = nullptr;
  int first_input = 0, first_output = 0;
  int rank = 0;  // its number in the order of a beat
  clock fires{};
  // While its part is started. It differs from `fires` if it is known: a part may be stopped at any time.
  clock own_clock{};
  int first_request = 0;     // of those that stop or start parts
  bool may_miss = false;     // its clock is known, but a beat may end before its turn
  bool tells_taken = false;  // publishes what its inputs take from their queues
  bool stored_seen = false;  // keeps the oldest origin that it saw when it last fired
  bool elsewhere = false;    // another loop runs it
  bool irregular = false;    // nobody knows in which beats it fires
  // If it is known only in a fast run: then it fires by this clock, and in a wall-clock run as its strategy
  // says.
  clock fast_clock = dynamic_clock;
  // Only if the plan is of several graphs, of which one runs at a time:
  bool open_clock = false;    // what it looks at tells no clock that holds after a switch
  bool unsteady = false;      // its clock is known, but another graph has another one, or lacks the node
  bool other_clocks = false;  // another graph has another one
  std::int64_t longest_period = 1;  // in beats, of all graphs
};

// An input, or a further way into one: each wire but the first of those that are merged at an input. The ways
// come after all inputs.
struct input {
  int call = 0, port = 0;
  int writer = -1;  // an output, or -1
  ref<item_info> wire = nullptr;
  ref<item_info> initial = nullptr;  // the wire that states its initial value
  int delay = 0;                     // of its wire, in beats
  int next_of_writer = -1;           // the next input of the same output
  bool wired = false;                // by a wire, an observer, or exposed by the outermost graph
  bool counts = true;                // for the time of origin
  bool in_beat = false;              // surely published in the beat of the reader's firing
  bool known_now = false;            // and also when its strategy is asked
  bool own_initial = false;          // its initial value differs from that of the stored sample
  int queue = -1;                    // number of its queue; that of all ways into an input
  int next_way = -1;                 // the next way into the same input
  int way_of = -1;                   // of a further way: the input
  int shows = -1;  // of an observer without delay: the input whose queue it shows, and takes nothing from it
  int turn = 0;    // of a way: its place among those into one input, by the order of publication
  bool counts_arrivals = false;  // its strategy may ask how many samples came in a beat
  bool counts_vary = false;      // the ways into it differ in whether their samples count for the origin
  int mark = 0;                  // of an observer of such a queue: the bit that tells for it; 0: the reader's
  int mark_count = 0;            // of such a queue: bits of observers
  std::uint64_t counts_for = 0;  // of a way: the bits of the observers for which its samples count
  bool watched = false;          // an `observe` of the graph names it
  ref<item_info> watched_as = nullptr;
  bool outside = false;       // no port: the program reads it, by an `observe` of the graph that has a policy
  std::uint64_t members = 0;  // as of a component_node, of those that have this queue
};

// How a sample is stored; decided in graph/planning/steps/storage.hpp. A queue is an input's own, and so is
// what is on its way into one.
enum class storage_kind : std::uint8_t { none, of_beat, newest, past, arriving, queue, on_the_way };

struct output {
  int call = 0, port = 0;
  // No port of its own, but what the input at this place takes from its queue, for observers with a delay. It
  // stands after the outputs of all ports.
  bool is_taken = false;
  int first_reader = -1;
  bool watched = false;         // an `observe` of the graph names it
  bool watched_newest = false;  // one that has no policy
  ref<item_info> watched_as = nullptr;
  storage_kind storage = storage_kind::none;
  int depth = 0;         // of the past, or of what arrives
  bool leaves = false;   // another loop reads it
  int in_a_beat = 1;     // samples; in a replay what arrived together may be more
  bool by_clock = true;  // its clock tells when its samples were published, also in other graphs
  ref<item_info> initial_of = nullptr;
  std::uint64_t members = 0;  // as of a component_node, if it is_taken
};

// What an observer hears: an output, or what another input shows. It comes by an input of its own, which
// stands after those of all ports: the observer reads it as over a wire. Where the program observes,
// `observer` is that input itself, which belongs to the call of the writer.
struct link {
  int observer = 0;                   // its port
  int output = 0;                     // the writer
  int input = -1;                     // the input that shows it; -1: the output is heard
  ref<item_info> heard_as = nullptr;  // the cca::expose by whose name it is heard; null: its own path
};

struct table_entry {
  std::uint64_t hash = 0;
  int index = -1;
};

struct flat_view {
  scope* scopes;
  component_node* nodes;
  call* calls;
  input* inputs;
  output* outputs;
  link* links;
  int* order;
  stoppable_part* parts;
  part_request* requests;
  int part_count = 0, request_count = 0;
  int scope_count = 0, node_count = 0, call_count = 0, link_count = 0, queue_count = 0;
  int output_count = 0;  // of ports, then of what is taken from queues
  int taken_count = 0;   // the last
  int input_count = 0;   // of ports, then of further ways into them, then one for each link
  int first_link = 0;    // the first of the last
  int order_count = 0;   // calls in a beat
  const hung_facts* hung = nullptr;
  bool is_spread = false;  // several loops run the graph
  double hz = 0;
  std::int64_t period = 0;  // nanoseconds a beat
  int calls_in_part = 0;    // graph/plan/long_beats.hpp
  bool may_fault = false;
  finding found{};
};

template <int Scopes, int Nodes, int Calls, int Inputs, int Outputs, int Links, int Parts, int Requests>
struct flat {
  std::array<scope, array_size(Scopes + 1)> scopes{};
  std::array<component_node, array_size(Nodes + 1)> nodes{};
  std::array<call, array_size(Calls + 1)> calls{};
  std::array<input, array_size(Inputs + 1)> inputs{};
  std::array<output, array_size(Outputs + 1)> outputs{};
  std::array<link, array_size(Links + 1)> links{};
  std::array<int, array_size(Calls + 1)> order{};
  std::array<stoppable_part, array_size(Parts + 1)> parts{};
  std::array<part_request, array_size(Requests + 1)> requests{};
  flat_view counts{};  // its pointers are null: a value must not point into itself

  constexpr flat_view view() {
    flat_view v = counts;
    v.scopes = scopes.data();
    v.nodes = nodes.data();
    v.calls = calls.data();
    v.inputs = inputs.data();
    v.outputs = outputs.data();
    v.links = links.data();
    v.order = order.data();
    v.parts = parts.data();
    v.requests = requests.data();
    return v;
  }
  // Of a finished plan. Whoever has this view must not write; a copy to point into would be made again for
  // each question, of thousands of numbers.
  constexpr flat_view view() const { return const_cast<flat*>(this)->view(); }
  // The same with more room.
  template <class Wider>
  constexpr void widen(Wider& to) const {
    to.scopes = scopes;
    to.nodes = nodes;
    to.calls = calls;
    for (int i = 0; i < counts.input_count; ++i) to.inputs[array_size(i)] = inputs[array_size(i)];
    for (int o = 0; o < counts.output_count; ++o) to.outputs[array_size(o)] = outputs[array_size(o)];
    to.parts = parts;
    to.requests = requests;
    to.counts = counts;
  }
  constexpr void keep(flat_view v) {
    v.scopes = nullptr;
    v.nodes = nullptr;
    v.calls = nullptr;
    v.inputs = nullptr;
    v.outputs = nullptr;
    v.links = nullptr;
    v.order = nullptr;
    v.parts = nullptr;
    v.requests = nullptr;
    counts = v;
  }
};

constexpr std::array<ref<function_info>, 3> functions_of(const component_info& component) {
  return {component.sense, component.process, component.act};
}
constexpr const port_info& port_of(const call& t, const output& o) {
  return o.is_taken ? t.function->inputs[o.port] : t.function->outputs[o.port];
}
constexpr const port_info& port_of(const flat_view& g, const output& o) {
  return port_of(g.calls[o.call], o);
}
constexpr const port_info& port_of(const flat_view& g, const input& i) {
  return i.outside ? port_of(g, g.outputs[i.writer]) : g.calls[i.call].function->inputs[i.port];
}
// Coordinates of what an input reads; an observer reads any space.
constexpr int coordinates_of(const flat_view& g, const input& i) {
  const auto& own = port_of(g, i).space;
  return own ? own->size : port_of(g, g.outputs[i.writer]).space->size;
}
constexpr const item_info& item_of_call(const flat_view& g, const call& t) { return *g.nodes[t.node].item; }
constexpr int scope_of_call(const flat_view& g, const call& t) { return g.nodes[t.node].scope; }

// The strategy of a component while it is started: the stated one, or the default.
constexpr const strategy_info& strategy_of_call(const flat_view& g, const call& t) {
  const auto& item = item_of_call(g, t);
  if (const auto stated = item.strategy_while_started()) return *stated;
  return item.component->resource() || t.function->input_count == 0 ? strategy_of<timed<1>>
                                                                    : strategy_of<restless>;
}

// Does the second part have the first around it, or is it the same? -1: the whole graph.
constexpr bool is_around(const flat_view& g, int part, int other) {
  while (other > part) other = g.parts[other].parent;
  return other == part;
}
constexpr int part_of_call(const flat_view& g, int call) { return g.nodes[g.calls[call].node].part; }

constexpr bool is_queued(const input& i) { return i.queue >= 0; }
// One that surely holds a sample whenever its component fires is watched before that, too.
constexpr bool may_show_initial(const input& i) { return !is_queued(i) && (!i.in_beat || i.watched); }
constexpr bool is_merged(const input& i) { return i.next_way >= 0 || i.way_of >= 0; }

// Calls f(way) for each way into an input; that into an input of one wire is the input itself.
template <class F>
constexpr void for_each_way(const flat_view& g, int input_index, F f) {
  for (int way = input_index; way >= 0; way = g.inputs[way].next_way) f(g.inputs[way]);
}

// What comes by this way waits until it arrives, before it enters the queue.
constexpr bool is_on_the_way(const input& i) { return i.queue >= 0 && i.delay > 0; }

// The loop that runs a call, if several run the graph; else -1.
constexpr int place_of(const flat_view& g, int call) { return g.nodes[g.calls[call].node].place; }

// A way into a queue of which something is kept between two beats: what has not arrived, or how much of
// what another loop publishes has been taken.
constexpr bool is_kept_way(const flat_view& g, const input& in) {
  return is_queued(in) && in.writer >= 0 &&
         (in.delay > 0 || place_of(g, in.call) != place_of(g, g.outputs[in.writer].call));
}

// Do two wires state the same initial value for an input of so many numbers, or both none?
constexpr bool same_initial(ref<item_info> a, ref<item_info> b, int size) {
  const bool has_a = a && a->initial, has_b = b && b->initial;
  if (!has_a || !has_b) return has_a == has_b;
  if (a->initial_count == 1 && b->initial_count == 1) size = 1;  // the same for all
  for (int c = 0; c < size; ++c)
    if (a->initial[a->initial_count == 1 ? 0 : c] != b->initial[b->initial_count == 1 ? 0 : c]) return false;
  return true;
}

// The clock of an output's samples.
constexpr bool is_published_at_times(const call& t, const output& o) {
  return o.is_taken || t.function->outputs[o.port].maybe;
}
constexpr clock published(const call& t, const output& o) {
  if (!is_published_at_times(t, o)) return t.fires;
  return t.fires.never() ? never_clock : dynamic_clock;
}
constexpr clock published(const flat_view& g, const output& o) { return published(g.calls[o.call], o); }
// The same in the beats in which a reader may fire: where it runs, the parts around it are started.
constexpr clock published_to(const flat_view& g, const output& o, int reader_call) {
  const auto& t = g.calls[o.call];
  if (!t.own_clock.known() || is_published_at_times(t, o)) return published(g, o);
  return is_around(g, g.nodes[t.node].part, part_of_call(g, reader_call)) ? t.own_clock : t.fires;
}

// The same for where its samples are stored.
constexpr clock stored_clock(const flat_view& g, const output& o) {
  return o.by_clock ? published(g, o) : dynamic_clock;
}

}  // namespace cca::detail
