// modes.unknown_mode: a component asks only for modes that exist.
#pragma once

#include <array>

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_unknown_mode {
  static constexpr std::string_view id = "modes.unknown_mode";

  static constexpr bool is_broken(when::requested_mode, const flat_view& g, const finding& f) {
    return modes_in_plan(g).number_of(f.name) < 0;
  }

  static constexpr void tell(auto& m) {
    const auto& all = modes_in_plan(m.g);
    m.at_node();
    m.node();
    m.say() << " returns a cca::switch_to<`" << m.found().name << "`>, but " << all.name
            << " has no such mode";
    std::array<std::string_view, most_modes> names{};
    for (int i = 0; i < all.count; ++i) names[static_cast<std::size_t>(i)] = all.modes[i].name;
    if (const auto near = nearest_name(m.found().name, names); !near.empty())
      m.say() << "; did you mean `" << near << "`?";
    else m.say() << ": ask for one of its modes, or add a mode of this name";
  }
};

}  // namespace cca::detail
