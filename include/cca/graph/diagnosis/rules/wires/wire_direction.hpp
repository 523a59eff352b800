// wire.direction: a wire leads from an output to an input.
#pragma once

#include <cca/graph/diagnosis/nearest_port.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct wire_direction {
  static constexpr std::string_view id = "wire.direction";

  static constexpr bool is_broken(when::unknown_port, const flat_view&, const finding& f) {
    return f.is_opposite;
  }

  static constexpr void tell(auto& m) {
    const bool at_reader = m.found().at_reader;
    const auto wrong = at_reader ? m.item().to : m.item().from;
    const auto is = [&](bool output) { return output ? "output" : "input"; };
    m.at_wire();
    m.say() << "a wire leads from an output to an input, but in ";
    m.wire();
    m.say() << " in " << m.graph().name << " `" << wrong << "` is an " << is(at_reader);
    if (m.found().is_reversed) {
      m.say() << " and `" << (at_reader ? m.item().from : m.item().to) << "` an " << is(!at_reader)
              << ": turn it round, cca::wire<`" << m.item().to << "`, `" << m.item().from << "`>";
      return;
    }
    m.say() << ": name an " << is(!at_reader) << " there";
    if (const auto best = nearest_port(m.graph(), wrong, !at_reader); best.size > 0)
      m.say() << "; did you mean `" << best.view() << "`?";
  }
};

}  // namespace cca::detail
