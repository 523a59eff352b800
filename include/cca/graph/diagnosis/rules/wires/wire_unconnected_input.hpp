// wire.unconnected_input: every input is wired, exposed or optional.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_unconnected_input {
  static constexpr std::string_view id = "wire.unconnected_input";

  static constexpr bool is_broken(when::open_input, const flat_view& g, const finding& f) {
    const auto& port = port_of(g, g.inputs[f.input]);
    return !port.optional;
  }

  static constexpr void tell(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    m.at(in);
    m.port(in);
    // The input of an inner graph is wired where that graph exposes it.
    text shown;
    shown << m.item().from << "." << port_of(m.g, in).name;
    int scope = m.found().scope;
    for (bool found = true; found && m.g.scopes[scope].parent >= 0;) {
      found = false;
      const auto& inside = m.g.scopes[scope];
      for (int i = 0; i < inside.graph->count && !found; ++i)
        if (const auto& item = inside.graph->items[i];
            item.kind == item_kind::expose && item.from == shown.view()) {
          shown = {};
          shown << inside.item->from << "." << item.to;
          found = true;
        }
      if (found) scope = inside.parent;
    }
    m.say() << " is not connected: in " << m.g.scopes[scope].graph->name << ", wire an output of ";
    add_space(m.say(), m.space(in));
    m.say() << " to `" << shown.view() << "`, or expose it, or make it a cca::optional_in";
  }
};

}  // namespace cca::detail
