// rate.unstated: a wire between different clocks states its policy.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct rate_unstated {
  static constexpr std::string_view id = "rate.unstated";

  static constexpr bool is_broken(when::clocked_wire, const flat_view& g, const finding& f) {
    return f.item->policy == policy_kind::unstated &&
           differ(published(g, g.outputs[f.output]), g.calls[g.inputs[f.input].call].fires);
  }

  static constexpr void tell(auto& m) {
    m.at_wire();
    m.two_clocks(m.g.outputs[m.found().output], m.g.inputs[m.found().input]);
    m.say() << ", and the wire does not say what happens between them: write ";
    m.wire_with(m.item().from, m.item().to, "cca::latest");
    m.say() << ", or cca::queue or cca::delayed instead";
  }
};

}  // namespace cca::detail
