// strategy.coordination: the inputs of a coordinated component can share a time of origin.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/origins.hpp>

namespace cca::detail {

struct strategy_coordination {
  static constexpr std::string_view id = "strategy.coordination";

  static constexpr bool is_broken(when::finished_call, const flat_view& g, finding& f) {
    const auto& call = g.calls[f.call];
    if (!strategy_of_call(g, call).needs_one_origin || !never_share_origin(g, f.call)) return false;
    for (int i = call.first_input; i < call.first_input + call.function->input_count; ++i)
      if (g.inputs[i].writer >= 0) (f.input < 0 ? f.input : f.other_input) = i;
    if (f.other_input < 0) f.other_input = f.input;
    return true;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.say() << " is cca::coordinated, but ";
    tell_source(m, m.g.inputs[m.found().input]);
    m.say() << " and ";
    tell_source(m, m.g.inputs[m.found().other_input]);
    m.say() << " never hold samples of one time of origin, so it would never fire: feed them from one source "
               "at one "
               "rate, with equal delays, or make it cca::moderate";
  }

private:
  static constexpr void tell_source(auto& m, const input& in) {
    const auto& writer = m.g.outputs[in.writer];
    m.port(in);
    m.say() << " (from ";
    m.port(writer);
    m.say() << ", ";
    add_clock(m.say(), published(m.g, writer));
    m.say() << ")";
  }
};

}  // namespace cca::detail
