// wire.bad_initial: an initial value has one number, or one for each coordinate.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_bad_initial {
  static constexpr std::string_view id = "wire.bad_initial";

  static constexpr bool is_broken(when::connection, const flat_view& g, const finding& f) {
    return f.item->initial && f.item->initial_count != 1 &&
           f.item->initial_count != port_of(g, g.inputs[f.input]).space->size;
  }

  static constexpr void tell(auto& m) {
    m.at_wire();
    const auto& in = m.g.inputs[m.found().input];
    m.say() << "cca::initial of the wire ";
    m.wire();
    m.say() << " gives " << m.item().initial_count << (m.item().initial_count == 1 ? " number" : " numbers")
            << ", but ";
    m.port(in);
    m.say() << " has " << m.space(in).size << ": give one for each, or one for all";
  }
};

}  // namespace cca::detail
