// deployment.undelayed: what goes from one environment to another is delayed, unless one of them is
// free-running, which is a way out where all that runs there is full_speed. What waits in a queue now is
// known only where the queue is.
#pragma once

#include <cca/graph/deployment/placement_events.hpp>
#include <cca/graph/deployment/rules/deployment_free_running.hpp>

namespace cca::detail {

struct deployment_undelayed {
  static constexpr std::string_view id = "deployment.undelayed";

  static constexpr bool is_broken(when::crossing, const flat_view& g, const finding& f) {
    const auto& in = g.inputs[f.input];
    return in.delay < 1 && !is_free(g, in.call) && !is_free(g, g.outputs[f.output].call);
  }
  static constexpr bool is_broken(when::queue_shown_elsewhere, const flat_view&, const finding&) {
    return true;
  }

  static constexpr void tell(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    const auto& out = m.g.outputs[m.found().output];
    const auto environment_of = [&](int call) { return m.g.nodes[m.g.calls[call].node].place; };
    if (in.shows >= 0 && environment_of(m.g.inputs[in.shows].call) != environment_of(in.call)) {
      m.at_node();
      m.node();
      m.say() << " observes `" << port_of(m.g, in).name << "`, and so the input ";
      m.port(m.g.inputs[in.shows]);
      m.of_mode();
      m.say() << " in ";
      m.environment(environment_of(m.g.inputs[in.shows].call));
      m.say()
          << ", but what waits in its queue now is known only there: write cca::observe<`"
          << port_of(m.g, in).name
          << "`, cca::delayed<1>>, or a greater delay, to hear what is taken from the queue, or place both "
             "in one environment";
      return;
    }
    const bool is_wire = bool(port_of(m.g, in).space);
    if (is_wire) {
      m.at_wire();
      m.port(out);
    } else {
      m.at_node();
      m.node();
      m.say() << " observes `" << port_of(m.g, in).name << "`: ";
      m.port(out);
    }
    m.of_mode();
    m.say() << " is published in ";
    m.environment(environment_of(out.call));
    m.say() << " and read in ";
    m.environment(environment_of(in.call));
    m.say() << ", so it takes at least a beat to get there: ";
    if (is_wire && m.graph().inner != wires_of::nobody) return tell_skeleton(m, is_queued(in));
    m.say() << "write ";
    if (is_wire && is_queued(in)) tell_queue(m);
    else if (is_wire) m.wire_with(m.item().from, m.item().to, "cca::delayed<1>");
    else m.say() << "cca::observe<`" << port_of(m.g, in).name << "`, cca::delayed<1>>";
    if (is_wire && m.found().scope > 0) m.say() << " in " << m.graph().name;
    m.say() << ", or a greater delay, or place both in one environment";
    for (const int e : {environment_of(out.call), environment_of(in.call)})
      if (may_be_free(m.g, e)) {
        m.say() << ", or give ";
        m.environment(e);
        m.say() << " cca::free_running, because all that it runs is cca::full_speed: then its wires need no "
                   "delay";
        return;
      }
  }

private:
  // Of a set of modes, what it runs in the others is not known here.
  static constexpr bool may_be_free(const flat_view& g, int environment) {
    if (environment == 0 || !placement_in(g).deployment->mode.empty()) return false;
    for (int n = 0; n < g.node_count; ++n)
      if (g.nodes[n].place == environment && (g.nodes[n].item->component->resource() ||
                                              !deployment_free_running::is_full_speed(*g.nodes[n].item)))
        return false;
    return true;
  }
  // The delay stands beside the queue.
  static constexpr void tell_queue(auto& m) {
    constexpr std::string_view full[] = {"drop_oldest", "drop_newest", "reject", "..."};
    m.say() << "cca::wire<`" << m.item().from << "`, `" << m.item().to
            << "`, cca::delayed<1>, cca::" << (m.item().policy == policy_kind::merged ? "merged<" : "queue<")
            << m.item().capacity << ", cca::" << full[static_cast<int>(m.item().full)] << ">>";
  }
  // Its wires are not the user's: an option of the skeleton sets their policies.
  static constexpr void tell_skeleton(auto& m, bool has_queue) {
    int s = m.found().scope;
    while (s > 0 && m.g.scopes[s].graph->inner == wires_of::the_one_around) s = m.g.scopes[s].parent;
    m.say() << (has_queue ? "add cca::delayed<1> to the cca::inner_wires<...> of the skeleton "
                          : "add cca::inner_wires<cca::delayed<1>> to the arguments of the skeleton ");
    if (m.g.scopes[s].item) {
      m.say() << "`";
      add_scope_path(m.say(), m.g, m.g.scopes[s].parent);
      m.say() << m.g.scopes[s].item->from << "` (" << m.g.scopes[s].graph->name << ")";
    } else {
      m.say() << m.g.scopes[s].graph->name;
    }
    m.say() << ", or place its parts in one environment";
  }
  static constexpr bool is_free(const flat_view& g, int call) {
    return environment_in(g, place_of(g, call)).is_free_running;
  }
};

}  // namespace cca::detail
