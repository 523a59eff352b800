// modes.two_types: a path names the same component in every mode that has it.
#pragma once

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_two_types {
  static constexpr std::string_view id = "modes.two_types";

  static constexpr bool is_broken(when::shared_path, const flat_view& g, finding& f) {
    const auto& shared = g.nodes[f.component];
    if (shared.item->component->key == f.item->component->key) return false;
    f.name = f.item->component->name();
    f.item = shared.item;
    f.scope = shared.scope;
    return true;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.say() << "`" << m.where.view() << "` is " << m.item().component->name() << " in ";
    m.mode(in_mode(m.found()));
    m.say() << " but " << m.found().name << " in ";
    m.mode(other_mode(m.found()));
    m.say() << (m.item().component->resource()
                    ? ": the modes of a set run on one robot, so give it one type in all of them"
                    : ": modes share what is at a path, its state and its parameters, so give one of them "
                      "another name");
  }
};

}  // namespace cca::detail
