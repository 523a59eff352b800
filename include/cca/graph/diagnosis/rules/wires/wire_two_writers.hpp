// wire.two_writers: an input has one writer, or all of its wires are merged in the same way.
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
    bool is_same = false;
    for_each_way(m.g, m.found().input, [&](const input& way) {
      is_same =
          is_same || (way.writer == m.found().output && (way.delay == m.item().delay || !leads_to_many(way)));
    });
    if (is_same) {
      m.port(m.g.outputs[m.found().output]);
      m.say() << " twice: remove one of the two wires";
      return;
    }
    m.port(m.g.outputs[in.writer]);
    m.say() << " and by ";
    m.port(m.g.outputs[m.found().output]);
    if (leads_to_many(in) || m.item().policy == policy_kind::merged) {
      m.say() << ", ";
      policy(m, *in.wire);
      m.say() << " and ";
      policy(m, m.item());
      m.say() << ", but wires that are merged at an input lead into one queue: give each of them the same "
                 "cca::merged<C, F> (a cca::delayed<N> beside it may differ)";
      return;
    }
    m.say() << ", but an input has one writer: put an arbiter in front, cca::arbiter<`"
            << port_of(m.g, in).name << "`, " << m.space(in).name
            << ", cca::by_priority<`first`, `second`>>, and wire each to an input of it; or, to read every "
               "sample of both, give each wire cca::merged<8>";
  }

private:
  static constexpr bool leads_to_many(const input& way) { return way.wire->policy == policy_kind::merged; }
  static constexpr void policy(auto& m, const item_info& wire) {
    constexpr std::string_view full[] = {"drop_oldest", "drop_newest", "reject", "..."};
    if (wire.policy == policy_kind::merged)
      m.say() << "one by cca::merged<" << wire.capacity << ", cca::" << full[static_cast<int>(wire.full)]
              << ">";
    else m.say() << "one not merged";
  }
};

}  // namespace cca::detail
