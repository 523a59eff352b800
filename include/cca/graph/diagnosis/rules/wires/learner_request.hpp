// learner.request: what a component may request is something that the learner at the other end can do.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct learner_request {
  static constexpr std::string_view id = "learner.request";

  static constexpr bool is_broken(when::connection, const flat_view& g, const finding& f) {
    return !why(g, f).empty();
  }

  static constexpr void tell(auto& m) {
    const auto& from = m.g.outputs[m.found().output];
    const auto& to = m.g.inputs[m.found().input];
    m.at_wire();
    m.wired_port(from, m.item().from);
    m.say() << " may request of ";
    m.wired_port(to, m.item().to);
    m.say() << " what is not possible there: " << why(m.g, m.found());
  }

private:
  static constexpr std::string_view why(const flat_view& g, const finding& f) {
    const auto& to = g.inputs[f.input];
    const auto refusal = item_of_call(g, g.calls[to.call]).component->refusal;
    const auto& space = *port_of(g, g.outputs[f.output]).space;
    for (int i = 0; refusal && i < space.only_count; ++i)
      if (const auto found = refusal(port_of(g, to).name, space.only[i]); !found.empty()) return found;
    return {};
  }
};

}  // namespace cca::detail
