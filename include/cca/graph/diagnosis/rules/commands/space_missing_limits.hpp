// space.missing_limits: an axis along which commands go to an actuator has limits.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/commands.hpp>

namespace cca::detail {

struct space_missing_limits {
  static constexpr std::string_view id = "space.missing_limits";

  static constexpr bool is_broken(when::finished_input, const flat_view& g, const finding& f) {
    const auto& in = g.inputs[f.input];
    return (is_actuated(g, in) || f.item->component->limits_commands) &&
           port_of(g, in).space->missing_limits >= 0;
  }

  static constexpr void tell(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    const auto& space = m.space(in);
    m.at(in);
    m.port(in);
    // The angle of a continuous axis is bounded by its velocity alone (space/limits.hpp).
    const std::string_view needed = space.missing_is_continuous ? "velocity" : space.quantity;
    m.say() << " takes commands of " << space.name << ", but its axis `" << space.axes[space.missing_limits]
            << "` states no limits of " << needed
            << " to keep them within: add `static constexpr auto limits = cca::limits{cca::" << needed
            << "{lower, upper}};` to it";
  }
};

}  // namespace cca::detail
