// graph.algebraic_loop: wires without delay close no loop.
#pragma once

#include <cca/graph/diagnosis/cycle.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct graph_algebraic_loop {
  static constexpr std::string_view id = "graph.algebraic_loop";

  static constexpr bool is_broken(when::unordered_calls, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto loop = find_cycle(m.g);
    if (loop.length == 0) return tell_observer(m);
    const auto input_at = [&](int i) -> const input& {
      return m.g.inputs[loop.inputs[static_cast<std::size_t>(i)]];
    };
    for (int i = 0; i < loop.length; ++i) {
      m.say() << (i > 0 ? ", " : "");
      m.port(m.g.outputs[input_at(i).writer]);
      m.say() << " -> ";
      m.port(input_at(i));
    }
    m.say() << (loop.backwards
                    ? " leads back within a beat, which is: every sense, then every component, then every act"
                : loop.length == 1
                    ? " is a loop without delay, so its component would have to come before itself"
                    : " are a loop without delay, so none of their components can come first")
            << "; say where it may be a beat late: ";
    const auto& last = input_at(loop.length - 1);
    m.wire_with(last.wire->from, last.wire->to, "cca::delayed<1>");
    add_port(m.where, m.g, m.g.outputs[last.writer]);
    m.where << " -> ";
    add_port(m.where, m.g, last);
  }

private:
  // The loop goes through an observer.
  static constexpr void tell_observer(auto& m) {
    for (int l = 0; l < m.g.link_count; ++l) {
      const auto& observer = m.g.inputs[m.g.first_link + l];
      const auto& observed = m.g.outputs[m.g.links[l].output];
      if (observer.delay > 0 || m.g.calls[observer.call].rank >= 0 || m.g.calls[observed.call].rank >= 0)
        continue;
      const auto path = port_of(m.g, observer).name;
      add_node_path(m.where, m.g, m.g.calls[observer.call].node);
      m.say() << "`" << m.where.view() << "` observes `" << path << "`, and so ";
      m.port(observed);
      m.say()
          << ", which depends on what it publishes itself, so neither can come first; let it observe a beat "
             "later: cca::observe<`"
          << path << "`, cca::delayed<1>>";
      return;
    }
  }
};

}  // namespace cca::detail
