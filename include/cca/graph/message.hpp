// What a refused graph is told: the rule's id, both ends, why, and what to do.
#pragma once

#include <cca/component/nearest.hpp>
#include <cca/graph/cycle.hpp>
#include <cca/graph/paths.hpp>
#include <cca/graph/rules.hpp>

namespace cca::detail {

struct report {
  text where{}, message{};
};

struct reporting {
  flat_view g;
  std::string_view unknown_trigger;
  report r{};

  constexpr text& say() { return r.message; }

  constexpr void node_path(text& t, const item_info& item) const {
    add_scope_path(t, g, g.found.scope);
    t << item.from;
  }
  constexpr void node(const item_info& item) {
    say() << "`";
    node_path(say(), item);
    say() << "`";
    if (item.component) say() << " (" << item.component->name << ")";
    if (item.inner) say() << " (" << item.inner->name << ")";
  }
  constexpr void at_node() { node_path(r.where, *g.found.item); }
  constexpr void at_input(int i) { add_port(r.where, g, g.inputs[i]); }
  constexpr void at_output(int o) { add_port(r.where, g, g.outputs[o]); }
  constexpr void at_item() {
    add_scope_path(r.where, g, g.found.scope);
    r.where << g.found.item->from << " -> ";
    add_scope_path(r.where, g, g.found.scope);
    r.where << g.found.item->to;
  }
  constexpr void port(const input& i) {
    say() << "`";
    add_port(say(), g, i);
    say() << "`";
  }
  constexpr void port(const output& o) {
    say() << "`";
    add_port(say(), g, o);
    say() << "`";
  }
  constexpr std::string_view graph_name() const { return g.scopes[g.found.scope].graph->name; }

  // Ports that a wire in the scope of the verdict could name, nearest to a wrong one.
  constexpr void offer_nearest(std::string_view wrong, bool outputs) {
    const auto& graph = *g.scopes[g.found.scope].graph;
    text best;
    std::size_t least = wrong.size() / 3 + 2;
    const auto consider = [&](std::string_view node_name, std::string_view port_name) {
      text candidate;
      candidate << node_name << "." << port_name;
      const auto distance = edit_distance(wrong, candidate.view());
      if (distance < least) {
        least = distance;
        best = candidate;
      }
    };
    for (int i = 0; i < graph.count; ++i) {
      const auto& item = graph.items[i];
      const auto letters = item.from.size() < wrong.size() ? wrong.size() - item.from.size() : item.from.size() - wrong.size();
      if (letters > wrong.size()) continue;
      if (item.kind == item_kind::node)
        for (const half_info* half : {item.component->sense, item.component->process, item.component->act}) {
          if (!half) continue;
          for (int p = 0; p < (outputs ? half->output_count : half->input_count); ++p)
            consider(item.from, (outputs ? half->outputs : half->inputs)[p].name);
        }
      if (item.kind == item_kind::graph)
        for (int e = 0; e < item.inner->count; ++e)
          if (item.inner->items[e].kind == item_kind::expose) consider(item.from, item.inner->items[e].to);
    }
    if (best.size > 0) say() << "; did you mean `" << best.view() << "`?";
    else say() << (outputs ? "; its outputs are named `node.port`" : "; its inputs are named `node.port`");
  }

  constexpr void unknown_port() {
    const auto& item = *g.found.item;
    const bool is_expose = item.kind == item_kind::expose;
    const auto wrong = g.found.a == 1 ? item.to : item.from;
    if (is_expose) say() << "cca::expose<`" << item.from << "`, `" << item.to << "`> in ";
    else say() << "the wire `" << item.from << "` -> `" << item.to << "` in ";
    say() << graph_name() << " names `" << wrong << "`, but there is no such " << (is_expose ? "port" : g.found.a == 1 ? "input" : "output");
    int dots = 0;
    for (const char c : wrong) dots += c == '.';
    if (dots > 1) say() << ": it names ports of its own nodes, or what they expose, not a path into an inner graph";
    offer_nearest(wrong, g.found.a != 1);
  }

  constexpr void mismatch() {
    const auto& from = g.outputs[g.found.a];
    const auto& to = g.inputs[g.found.b];
    const auto &a = *port_of(g, from).space, &b = *port_of(g, to).space;
    port(from);
    say() << " publishes ";
    add_space(say(), a);
    say() << " but ";
    port(to);
    say() << " expects ";
    add_space(say(), b);
    const bool same_domain = a.domain == b.domain;
    bool same_axes = a.axis_count == b.axis_count;
    for (int i = 0; same_axes && i < a.axis_count; ++i) same_axes = a.axes[i] == b.axes[i];
    const auto base = [](std::string_view name) { return name.substr(0, name.find('<')); };
    if (!same_domain && base(a.domain) == base(b.domain)) say() << ": the frames differ; put a transformation between them";
    else if (!same_domain) say() << ": the domain types differ; put a mapping between them, or wire another port";
    else if (!same_axes) say() << ": the axes differ; use a splitter or a collector, or give both ends one space";
    else if (a.hz != b.hz) say() << ": the rates differ; give both spaces one rate, or let one of them state none";
    else say() << ": types of the same name from different places";
  }

  constexpr void cycle() {
    const auto loop = find_cycle(g);
    say() << "every beat of ";
    for (int i = 0; i < loop.length; ++i) {
      say() << "`";
      add_port(say(), g, g.outputs[g.inputs[loop.inputs[static_cast<std::size_t>(i)]].writer]);
      say() << "` -> `";
      add_port(say(), g, g.inputs[loop.inputs[static_cast<std::size_t>(i)]]);
      say() << "`" << (i + 1 < loop.length ? ", " : "");
    }
    if (loop.length == 0) say() << "an observer and what it listens to";
    say() << (loop.backwards ? " would have to come before itself: an act runs after all components, a sense before them"
                             : " waits for itself");
    say() << "; break it where the loop may be one beat late: cca::wire<..., ..., cca::delayed<1>>";
    if (loop.length > 0) {
      const auto& last = g.inputs[loop.inputs[static_cast<std::size_t>(loop.length - 1)]];
      add_port(r.where, g, g.outputs[last.writer]);
      r.where << " -> ";
      add_port(r.where, g, last);
    }
  }

  constexpr void tell() {
    const auto& f = g.found;
    if (f.broken == rule::none) return;
    say() << rule_ids[static_cast<std::size_t>(f.broken)] << ": ";
    switch (f.broken) {
      case rule::node_duplicate_name:
        at_node();
        if (f.a == 1) say() << "two outputs are exposed as `" << f.item->to << "` by " << graph_name() << ": give one of them another name";
        else say() << "two nodes of " << graph_name() << " are named `" << f.item->from << "`: give one of them another name";
        break;
      case rule::component_no_process:
        at_node();
        node(*f.item);
        say() << " has no `process`: give it one public function, neither overloaded nor a template, as in "
                 "`auto process(cca::in<...>) -> cca::out<...>`; a resource node has `sense` and `act` instead";
        break;
      case rule::component_bad_parameter:
      case rule::component_bad_result: bad_signature(); break;
      case rule::component_hook_signature:
        at_node();
        node(*f.item);
        say() << " has a hook `" << f.item->component->bad_hook << "` that could never be called: write it as a public `void "
              << f.item->component->bad_hook << "()`";
        break;
      case rule::parameters_unsupported_type:
        at_node();
        node(*f.item);
        say() << " has the parameter `" << f.item->component->bad_field << "` of a type that cannot be configured: use a number, bool, "
                 "cca::bounded, cca::quantity, a fixed-size array or Eigen vector of these, or a nested struct described to Hana";
        break;
      case rule::space_duplicate_axis: {
        const auto& space = f.b == 1 ? *port_of(g, g.outputs[f.a]).space : *port_of(g, g.inputs[f.a]).space;
        if (f.b == 1) at_output(f.a);
        else at_input(f.a);
        say() << "the space " << space.name << " of `" << r.where.view() << "` has the axis `" << space.axes[space.duplicate_axis]
              << "` twice: name each axis once in cca::axes<...>";
        break;
      }
      case rule::strategy_unknown_port:
        at_node();
        node(*f.item);
        say() << " is triggered by `" << unknown_trigger << "`, but it has no such input";
        offer_input();
        break;
      case rule::strategy_misplaced:
        at_node();
        node(*f.item);
        if (f.item->inner) say() << " is a graph, and a strategy stands on components: give it to the nodes inside";
        else say() << " is a resource node: it is cca::timed, cca::full_speed or cca::inactive";
        break;
      case rule::wire_unknown_port: at_item(); unknown_port(); break;
      case rule::wire_direction:
        at_item();
        say() << "a wire leads from an output to an input, but `" << (f.a == 0 ? f.item->from : f.item->to) << "` is an "
              << (f.a == 0 ? "input" : "output") << " in the wire `" << f.item->from << "` -> `" << f.item->to << "` in " << graph_name()
              << ": turn it round";
        break;
      case rule::wire_two_writers:
        at_input(f.a);
        port(g.inputs[f.a]);
        say() << " is written by ";
        port(g.outputs[g.inputs[f.a].writer]);
        say() << " and by ";
        port(g.outputs[f.b]);
        say() << ", but an input has one writer: put an arbiter between them that decides, or give each its own input";
        break;
      case rule::wire_bad_initial:
        at_item();
        say() << "cca::initial has " << f.item->initial_count << " numbers, but ";
        port(g.inputs[f.a]);
        say() << " has " << port_of(g, g.inputs[f.a]).space->size << " coordinates: give one for each, or one for all";
        break;
      case rule::space_mismatch: at_item(); mismatch(); break;
      case rule::wire_unconnected_input:
        at_input(f.a);
        port(g.inputs[f.a]);
        say() << " is not connected: wire a ";
        add_space(say(), *port_of(g, g.inputs[f.a]).space);
        say() << " to it, or expose it, or make it a cca::optional_in";
        break;
      case rule::rate_missing:
        r.where << graph_name();
        say() << "neither " << graph_name() << " nor any of its spaces states a rate: add cca::rate<1000> to the graph";
        break;
      case rule::rate_mismatch: rate_mismatch(); break;
      case rule::strategy_never_fires:
        at_node();
        node(*f.item);
        if (f.b == 0) say() << " fires when an input is fresh, but none of its inputs is wired: wire one, or make it cca::timed";
        else say() << " never fires: the clocks under cca::all_of have no beat in common; change a phase or a period";
        break;
      case rule::graph_algebraic_loop: cycle(); break;
      case rule::rate_unstated:
        at_item();
        port(g.outputs[f.a]);
        say() << " is published ";
        add_clock(say(), published(g, g.outputs[f.a]));
        say() << " but ";
        port(g.inputs[f.b]);
        say() << " is read ";
        add_clock(say(), g.turns[g.inputs[f.b].turn].fires);
        say() << ": say what happens between them: cca::wire<..., ..., cca::latest>, or cca::queue, or cca::delayed";
        break;
      case rule::queue_overflow:
        at_item();
        port(g.outputs[f.a]);
        say() << " is published ";
        add_clock(say(), published(g, g.outputs[f.a]));
        say() << " but ";
        port(g.inputs[f.b]);
        say() << " is read ";
        add_clock(say(), g.turns[g.inputs[f.b].turn].fires);
        say() << ": the queue of " << f.item->number << " overflows; read faster, or say what is lost: cca::drop_oldest, cca::drop_newest";
        break;
      case rule::strategy_coordination:
        at_node();
        node(*f.item);
        say() << " is coordinated, but ";
        port(g.inputs[f.a]);
        say() << " and ";
        port(g.inputs[f.b]);
        say() << " never hold samples of one origin at once: feed them from one source at one rate, or use cca::moderate";
        break;
      case rule::space_missing_limits: {
        at_input(f.a);
        const auto& space = *port_of(g, g.inputs[f.a]).space;
        port(g.inputs[f.a]);
        say() << " commands " << space.name << ", but its axis `" << space.axes[space.missing_limits] << "` has no limits for "
              << space.quantity << ": add `static constexpr auto limits = cca::limits{cca::" << space.quantity << "{lower, upper}};` to it";
        break;
      }
      case rule::robot_unlimited_command:
        at_item();
        port(g.outputs[f.a]);
        say() << " reaches the actuator ";
        port(g.inputs[f.b]);
        say() << " without passing a limiter: put a cca::limiter<" << port_of(g, g.inputs[f.b]).space->name << "> in front";
        break;
      case rule::latency_exceeded:
        at_item();
        say() << "a sample of `" << f.item->from << "` can be ";
        if (f.a < 0) say() << "of any age";
        else say() << f.a << " beats old";
        say() << " when `" << f.item->to << "` is read, but " << graph_name() << " requires at most " << f.item->number
              << ": " << (f.a < 0 ? "give the components between them clocks that are known" : "shorten a delay or run what is between them faster");
        break;
      default: break;
    }
  }

  constexpr void bad_signature() {
    const auto& f = g.found;
    const bool parameter = f.broken == rule::component_bad_parameter;
    at_node();
    node(*f.item);
    const half_info* half = nullptr;
    std::string_view function;
    const auto& c = *f.item->component;
    const auto look = [&](const half_info* h, std::string_view name) {
      if (h && !half && (f.b == 1 || !(parameter ? h->bad_parameter : h->bad_result).empty())) {
        half = h;
        function = name;
      }
    };
    look(c.process, "process");
    look(c.sense, "sense");
    look(c.act, "act");
    if (f.b == 1) {
      say() << " has two " << (parameter ? "inputs" : "outputs") << " named `" << (parameter ? half->inputs : half->outputs)[f.a].name
            << "`: give one of them another name";
    } else if (parameter) {
      say() << ": `" << function << "` takes `" << half->bad_parameter
            << "`, but it may take only ports (cca::in, cca::optional_in, cca::observe) and the cca::beat, each by value or by reference to const";
    } else {
      say() << ": `" << function << "` returns `" << half->bad_result
            << "`, but it may return only cca::out, cca::maybe, cca::fault, a std::tuple of these, or void";
    }
  }

  constexpr void offer_input() {
    std::string_view best;
    std::size_t least = 64;
    const auto& c = *g.found.item->component;
    for (const half_info* half : {c.sense, c.process, c.act})
      for (int p = 0; half && p < half->input_count; ++p)
        if (const auto distance = edit_distance(unknown_trigger, half->inputs[p].name); distance < least) {
          least = distance;
          best = half->inputs[p].name;
        }
    if (!best.empty()) say() << "; did you mean `" << best << "`?";
  }

  constexpr void rate_mismatch() {
    const auto& f = g.found;
    if (f.item->kind == item_kind::rate) {
      add_scope_path(r.where, g, f.scope);
      say() << "the inner graph " << graph_name() << " states " << f.item->hz << " Hz, but " << g.scopes[0].graph->name << " runs at " << g.hz
            << " Hz: give both one rate, or let the inner one state none";
      return;
    }
    at_output(f.a);
    const auto& out = g.outputs[f.a];
    const auto c = published(g, out);
    port(out);
    say() << " is published ";
    add_clock(say(), c);
    say() << ", that is at " << g.hz / static_cast<double>(c.period) << " Hz, but its space ";
    add_space(say(), *port_of(g, out).space);
    say() << " states another rate: change the strategy of `";
    add_leaf_path(say(), g, g.turns[out.turn].leaf);
    say() << "` or the space";
  }
};

}  // namespace cca::detail
