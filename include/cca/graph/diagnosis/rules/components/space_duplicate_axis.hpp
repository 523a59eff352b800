// space.duplicate_axis: a space has each axis once.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct space_duplicate_axis {
  static constexpr std::string_view id = "space.duplicate_axis";

  static constexpr bool is_broken(when::component_port, const flat_view& g, const finding& f) {
    return space_of_port(g, f).duplicate_axis >= 0;
  }

  static constexpr void tell(auto& m) {
    if (m.found().output >= 0) tell_of(m, m.g.outputs[m.found().output]);
    else tell_of(m, m.g.inputs[m.found().input]);
  }

private:
  static constexpr const space_info& space_of_port(const flat_view& g, const finding& f) {
    return f.output >= 0 ? *port_of(g, g.outputs[f.output]).space : *port_of(g, g.inputs[f.input]).space;
  }

  static constexpr void tell_of(auto& m, const auto& port) {
    m.at(port);
    const auto& space = m.space(port);
    m.say() << "the space " << space.name << " of ";
    m.port(port);
    m.say() << " has the axis `" << space.axes[space.duplicate_axis]
            << "` twice, so reading along it has two meanings: name each axis once in cca::axes<...>";
  }
};

}  // namespace cca::detail
