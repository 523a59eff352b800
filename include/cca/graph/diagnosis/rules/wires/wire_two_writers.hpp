// wire.two_writers: an input has one writer.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_two_writers {
  static constexpr std::string_view id = "wire.two_writers";

  static constexpr bool is_broken(when::second_writer, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    m.at(in);
    m.port(in);
    m.say() << " is written by ";
    m.port(m.g.outputs[in.writer]);
    if (in.writer == m.found().output) {
      m.say() << " twice: remove one of the two wires";
      return;
    }
    m.say() << " and by ";
    m.port(m.g.outputs[m.found().output]);
    m.say() << ", but an input has one writer: put an arbiter in front, cca::arbiter<`"
            << port_of(m.g, in).name << "`, " << m.space(in).name
            << ", cca::by_priority<`first`, `second`>>, and wire each to an input of it";
  }
};

}  // namespace cca::detail
