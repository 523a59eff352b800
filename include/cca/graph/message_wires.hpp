// Messages about wires and what they join: names, directions, spaces, writers, and commands on their way to
// actuators.
#pragma once

#include <cca/graph/telling.hpp>

namespace cca::detail {

// Does a graph show an output under this name, or else an input?
constexpr bool shows_output(const graph_info& graph, std::string_view shown) {
  const auto node = shown.substr(0, shown.find('.')), port = shown.substr(shown.find('.') + 1);
  for (int i = 0; i < graph.count; ++i) {
    const auto& item = graph.items[i];
    if (item.from != node) continue;
    for (int which = 0; item.component && which < 3; ++which) {
      const auto function = telling::function(*item.component, which);
      for (int p = 0; function && p < function->output_count; ++p)
        if (function->outputs[p].name == port) return true;
    }
    for (int e = 0; item.inner && e < item.inner->count; ++e)
      if (const auto& inner = item.inner->items[e];
          inner.kind == item_kind::expose && inner.to == port && shows_output(*item.inner, inner.from))
        return true;
  }
  return false;
}

// Of the ports that a wire in this graph can name, the one nearest to a wrong name.
constexpr text nearest_port(const graph_info& graph, std::string_view wrong, bool outputs) {
  text best;
  std::size_t least = wrong.size() / 3 + 2;
  const auto consider = [&](std::string_view node, std::string_view port) {
    const auto size = node.size() + 1 + port.size();
    if ((size < wrong.size() ? wrong.size() - size : size - wrong.size()) >= least) return;
    text candidate;
    candidate << node << "." << port;
    if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
      least = distance;
      best = candidate;
    }
  };
  for (int i = 0; i < graph.count; ++i) {
    const auto& item = graph.items[i];
    if (item.kind == item_kind::node)
      for (int which = 0; which < 3; ++which) {
        const auto function = telling::function(*item.component, which);
        for (int p = 0; function && p < (outputs ? function->output_count : function->input_count); ++p)
          if (const auto& port = (outputs ? function->outputs : function->inputs)[p]; outputs || port.space)
            consider(item.from, port.name);
      }
    if (item.kind == item_kind::graph)
      for (int e = 0; e < item.inner->count; ++e)
        if (const auto& inner = item.inner->items[e];
            inner.kind == item_kind::expose && shows_output(*item.inner, inner.from) == outputs)
          consider(item.from, inner.to);
  }
  return best;
}

constexpr const item_info* node_named(const graph_info& graph, std::string_view name) {
  for (int i = 0; i < graph.count; ++i)
    if ((graph.items[i].kind == item_kind::node || graph.items[i].kind == item_kind::graph) &&
        graph.items[i].from == name)
      return &graph.items[i];
  return nullptr;
}

constexpr void tell_unknown_port(auto& t) {
  const auto& item = t.item();
  if (item.kind == item_kind::observe) {
    t.at_node();
    t.say() << "cca::observe<`" << item.from << "`> in " << t.graph().name
            << " hears nothing, for no output has such a path: write it from the nodes of this graph on, as "
               "in `node.port` or "
               "`node.*`";
    return;
  }
  t.at_wire();
  const bool exposes = item.kind == item_kind::expose, reader = t.found().a == 1;
  const auto wrong = reader ? item.to : item.from;
  if (exposes) t.say() << "cca::expose<`" << item.from << "`, `" << item.to << "`>";
  else if (item.kind == item_kind::require)
    t.say() << "cca::latency<`" << item.from << "`, `" << item.to << "`>";
  else {
    t.say() << "the wire ";
    t.wire();
  }
  t.say() << " in " << t.graph().name << " names `" << wrong << "`, but ";
  int dots = 0;
  for (const char c : wrong) dots += c == '.';
  const auto* node = node_named(t.graph(), wrong.substr(0, wrong.find('.')));
  if (dots == 0) {
    t.say() << "a port is named with its node: `node.port`";
  } else if (dots > 1 && node && node->inner) {
    const auto inside = wrong.substr(wrong.find('.') + 1), port = wrong.substr(wrong.rfind('.') + 1);
    t.say() << "a path into an inner graph cannot be wired: ";
    for (int i = 0; i < node->inner->count; ++i)
      if (const auto& shown = node->inner->items[i];
          shown.kind == item_kind::expose && shown.from == inside) {
        t.say() << node->inner->name << " exposes this port as `" << node->from << "." << shown.to
                << "`, name that";
        return;
      }
    t.say() << "let " << node->inner->name << " show the port, with cca::expose<`" << inside << "`, `" << port
            << "`>, and name `" << node->from << "." << port << "` here";
    return;
  } else if (!node) {
    t.say() << "there is no node `" << wrong.substr(0, wrong.find('.')) << "`";
  } else {
    t.say() << "`" << node->from << "` (" << (node->inner ? node->inner->name : node->component->name())
            << ") " << (node->inner ? "exposes" : "has") << " no such "
            << (exposes  ? "port"
                : reader ? "input"
                         : "output");
  }
  auto best = nearest_port(t.graph(), wrong, !reader);
  if (best.size == 0 && exposes) best = nearest_port(t.graph(), wrong, false);
  if (best.size > 0) t.say() << "; did you mean `" << best.view() << "`?";
}

constexpr void tell_direction(auto& t) {
  t.at_wire();
  const bool from_input = t.found().a == 0;
  t.say() << "a wire leads from an output to an input, but in ";
  t.wire();
  t.say() << " in " << t.graph().name << " `" << (from_input ? t.item().from : t.item().to) << "` is an "
          << (from_input ? "input" : "output");
  if (t.found().b == 1) {
    t.say() << " and `" << (from_input ? t.item().to : t.item().from) << "` an "
            << (from_input ? "output" : "input") << ": call it round, cca::wire<`" << t.item().to << "`, `"
            << t.item().from << "`>";
  } else {
    const auto best = nearest_port(t.graph(), from_input ? t.item().from : t.item().to, from_input);
    t.say() << ": name an " << (from_input ? "output" : "input") << " there";
    if (best.size > 0) t.say() << "; did you mean `" << best.view() << "`?";
  }
}

constexpr void tell_two_writers(auto& t) {
  const auto& in = t.g.inputs[t.found().a];
  t.at(in);
  t.port(in);
  t.say() << " is written by ";
  t.port(t.g.outputs[in.writer]);
  if (in.writer == t.found().b) {
    t.say() << " twice: remove one of the two wires";
    return;
  }
  t.say() << " and by ";
  t.port(t.g.outputs[t.found().b]);
  t.say() << ", but an input has one writer: put an arbiter in front, cca::arbiter<`" << port_of(t.g, in).name
          << "`, " << t.space(in).name
          << ", cca::by_priority<`first`, `second`>>, and wire each to an input of it";
}

constexpr void tell_bad_option(auto& t) {
  t.at_wire();
  t.say() << "the wire ";
  t.wire();
  if (t.item().number < 1 && t.item().policy != policy_kind::unstated)
    t.say() << (t.item().policy == policy_kind::delayed ? " has a delay of " : " has a queue of ")
            << t.item().number << ", but that is at least 1: say so, or write cca::latest instead";
  else if (t.item().full == full_kind::unknown)
    t.say() << " has a queue that does `" << t.item().unknown_type
            << "` when it is full: say what is lost, cca::drop_oldest or cca::drop_newest, or cca::reject";
  else if (t.item().unknown_type.empty())
    t.say() << " has two policies, or two initial values, of which only one could hold: leave one of each";
  else
    t.say() << " has the option `" << t.item().unknown_type
            << "`, which is none: it may have a policy (cca::latest, cca::delayed<N>, cca::queue<C, F>) "
               "and a cca::initial<...>";
}

constexpr void tell_bad_initial(auto& t) {
  t.at_wire();
  const auto& in = t.g.inputs[t.found().a];
  t.say() << "cca::initial of the wire ";
  t.wire();
  t.say() << " gives " << t.item().initial_count << (t.item().initial_count == 1 ? " number" : " numbers")
          << ", but ";
  t.port(in);
  t.say() << " has " << t.space(in).size << ": give one for each, or one for all";
}

constexpr bool same_axes(const space_info& a, const space_info& b) {
  bool same = a.axis_count == b.axis_count;
  for (int i = 0; same && i < a.axis_count; ++i) same = a.axes[i] == b.axes[i];
  return same;
}

constexpr bool same_axes_in_another_order(const space_info& a, const space_info& b) {
  bool all = a.axis_count == b.axis_count;
  for (int i = 0; all && i < a.axis_count; ++i) {
    all = false;
    for (int j = 0; j < b.axis_count; ++j) all |= a.axes[i] == b.axes[j];
  }
  return all;
}

constexpr void tell_mismatch(auto& t) {
  const auto& from = t.g.outputs[t.found().a];
  const auto& to = t.g.inputs[t.found().b];
  const auto &a = t.space(from), &b = t.space(to);
  t.at_wire();
  t.wired_port(from, t.item().from);
  t.say() << " publishes ";
  add_space(t.say(), a);
  t.say() << " but ";
  t.wired_port(to, t.item().to);
  t.say() << " expects ";
  add_space(t.say(), b);
  const auto base = [](std::string_view name) { return name.substr(0, name.find('<')); };
  if (a.domain != b.domain && base(a.domain) == base(b.domain))
    t.say() << ": the frames differ; put a transformation between them";
  else if (a.domain != b.domain)
    t.say() << ": the domain types differ; put a mapping between them, or wire another port";
  else if (same_axes_in_another_order(a, b) && !same_axes(a, b))
    t.say() << ": the axes stand in another order; give both ends one space";
  else if (!same_axes(a, b))
    t.say() << ": the axes differ; use a splitter or a collector, or give both ends one space";
  else if (a.hz != b.hz)
    t.say() << ": the rates differ; give both spaces one rate, or let one of them state none";
  else
    t.say() << ": their domain types, axes or frames have the same names but are different types; use those "
               "of one namespace";
}

// An input of an inner graph is wired where it is shown.
constexpr void tell_unconnected(auto& t) {
  const auto& in = t.g.inputs[t.found().a];
  t.at(in);
  t.port(in);
  text shown;
  shown << item_of_call(t.g, t.g.calls[in.call]).from << "." << port_of(t.g, in).name;
  int scope = t.found().scope;
  for (bool found = true; found && t.g.scopes[scope].parent >= 0;) {
    found = false;
    const auto& inside = t.g.scopes[scope];
    for (int i = 0; i < inside.graph->count && !found; ++i)
      if (const auto& item = inside.graph->items[i];
          item.kind == item_kind::expose && item.from == shown.view()) {
        shown = {};
        shown << inside.item->from << "." << item.to;
        found = true;
      }
    if (found) scope = inside.parent;
  }
  t.say() << " is not connected: in " << t.g.scopes[scope].graph->name << ", wire an output of ";
  add_space(t.say(), t.space(in));
  t.say() << " to `" << shown.view() << "`, or expose it, or make it a cca::optional_in";
}

constexpr void tell_missing_limits(auto& t) {
  const auto& in = t.g.inputs[t.found().a];
  const auto& space = t.space(in);
  t.at(in);
  t.port(in);
  t.say() << " takes commands of " << space.name << ", but its axis `" << space.axes[space.missing_limits]
          << "` states no limits of " << space.quantity
          << " to keep them within: add `static constexpr auto limits = cca::limits{cca::" << space.quantity
          << "{lower, upper}};` to it";
}

constexpr void tell_initial_beyond_limits(auto& t) {
  const auto& in = t.g.inputs[t.found().a];
  t.at_wire();
  t.port(in);
  t.say() << " may be read before a first command has passed a limiter, and would then hold the cca::initial "
             "of its wire, which "
             "lies outside of the limits of `"
          << t.space(in).axes[t.found().c] << "`, on its way to the actuator";
  if (t.found().a != t.found().b) {
    t.say() << " ";
    t.port(t.g.inputs[t.found().b]);
  }
  t.say() << ": give the wire a cca::initial<...> within them";
}

constexpr void tell_unlimited(auto& t) {
  if (t.found().c >= 0) return tell_initial_beyond_limits(t);
  const auto& from = t.g.outputs[t.found().a];
  const auto& to = t.g.inputs[t.found().b];
  t.at_wire();
  t.port(from);
  t.say() << " reaches the actuator ";
  t.port(to);
  t.say() << " without passing a limiter: put a cca::limiter<" << t.space(to).name
          << "> between them (its input is `command`, its output `safe`), or a cca::unlimited where that is "
             "meant";
}

}  // namespace cca::detail
