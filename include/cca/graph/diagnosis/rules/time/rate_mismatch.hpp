// rate.mismatch: all rates of a graph agree, and an output is published at the rate of its space.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct rate_mismatch {
  static constexpr std::string_view id = "rate.mismatch";

  static constexpr bool is_broken(when::second_rate, const flat_view& g, const finding& f) {
    return f.item->hz != g.hz;
  }
  static constexpr bool is_broken(when::clocked_output, const flat_view& g, const finding& f) {
    const auto c = published(g, g.outputs[f.output]);
    const auto space = port_of(g, g.outputs[f.output]).space;
    return c.known() && space->hz > 0 && space->hz * static_cast<double>(c.period) != g.hz;
  }

  static constexpr void tell(auto& m) {
    if (m.found().output >= 0) tell_output(m, m.g.outputs[m.found().output]);
    else if (m.found().scope > 0) tell_inner_graph(m);
    else {
      m.where << m.graph().name;
      m.say() << m.graph().name << " states two rates, " << m.g.hz << " Hz and " << m.item().hz
              << " Hz, but all of it runs in one beat: keep one";
    }
  }

private:
  static constexpr void tell_inner_graph(auto& m) {
    add_scope_path(m.where, m.g, m.found().scope);
    if (m.where.size > 0) --m.where.size;  // without the dot
    m.say() << "the inner graph `" << m.where.view() << "` (" << m.graph().name << ") states " << m.item().hz
            << " Hz, but " << m.g.scopes[0].graph->name << " runs at " << m.g.hz
            << " Hz: give both one rate, or let the inner one state none";
  }

  static constexpr void tell_output(auto& m, const output& out) {
    const auto c = published(m.g, out);
    m.at(out);
    m.port(out);
    m.say() << " is published ";
    add_clock(m.say(), c);
    m.say() << ", that is at " << m.g.hz / static_cast<double>(c.period) << " Hz, but its space is ";
    add_space(m.say(), m.space(out));
    m.say() << ": change the strategy of `";
    add_node_path(m.say(), m.g, m.g.calls[out.call].node);
    m.say() << "`, or the rate of the space, or let the space state none";
  }
};

}  // namespace cca::detail
