// wire.bad_initial: an initial value has one number, or one for each coordinate, and an input has one of
// them.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_bad_initial {
  static constexpr std::string_view id = "wire.bad_initial";

  static constexpr bool is_broken(when::connection, const flat_view& g, const finding& f) {
    if (!f.item->initial) return false;
    const auto& in = g.inputs[f.input];
    const int size = port_of(g, in).space->size;
    return (f.item->initial_count != 1 && f.item->initial_count != size) ||
           (in.initial && !same_initial(in.initial, f.item, size));
  }

  static constexpr void tell(auto& m) {
    m.at_wire();
    const auto& in = m.g.inputs[m.found().input];
    if (in.initial && in.initial != m.found().item) {
      m.port(in);
      m.say() << " gets an initial value from two of the wires that are merged there, and they differ: leave "
                 "the cca::initial of one of them";
      return;
    }
    m.say() << "cca::initial of the wire ";
    m.wire();
    m.say() << " gives " << m.item().initial_count << (m.item().initial_count == 1 ? " number" : " numbers")
            << ", but ";
    m.port(in);
    m.say() << " has " << m.space(in).size << ": give one for each, or one for all";
  }
};

}  // namespace cca::detail
