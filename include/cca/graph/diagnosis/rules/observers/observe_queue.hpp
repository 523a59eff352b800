// observe.queue: what a queue shows is known only where the queue is, and only now.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct observe_queue {
  static constexpr std::string_view id = "observe.queue";

  static constexpr bool is_broken(when::heard_input, const flat_view& g, const finding& f) {
    const auto& heard = g.inputs[f.input];
    return heard.shows >= 0 && heard.delay > g.inputs[heard.shows].delay;
  }
  static constexpr bool is_broken(when::queue_shown_elsewhere, const flat_view&, const finding&) {
    return true;
  }

  static constexpr void tell(auto& m) {
    const auto& heard = m.g.inputs[m.found().input];
    const auto pattern = heard.outside ? m.item().from : port_of(m.g, heard).name;
    m.at_node();
    if (heard.outside) {
      m.say() << "cca::observe<`" << pattern << "`> in " << m.graph().name << " names the input ";
    } else {
      m.node();
      m.say() << " observes `" << pattern << "`, and so the input ";
    }
    m.port(m.g.inputs[heard.shows]);
    if (m.g.environment_count > 0 && m.g.nodes[m.g.calls[heard.call].node].environment !=
                                         m.g.nodes[m.g.calls[m.g.inputs[heard.shows].call].node].environment)
      m.say() << " in another environment";
    else m.say() << " later than it is read";
    m.say() << ", but that has a queue, and what waits in a queue is gone once it was read: ";
    if (pattern.ends_with("**")) m.say() << "observe the outputs alone, with `" << pattern << ".*`, or ";
    m.say() << "observe it without a delay, in the same environment";
  }
};

}  // namespace cca::detail
