// node.bad_name: names of nodes and ports have no dot and no star, and are not empty.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct node_bad_name {
  static constexpr std::string_view id = "node.bad_name";

  static constexpr bool is_broken(when::named_node, const flat_view&, const finding& f) {
    return !is_name(f.item->from);
  }
  static constexpr bool is_broken(when::component_port, const flat_view&, const finding& f) {
    return !is_name(f.name);
  }
  static constexpr bool is_broken(when::exposed_name, const flat_view&, const finding& f) {
    return !is_name(f.item->to);
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    if (m.where.size == 0) m.where << m.graph().name;
    const bool is_exposed = m.item().kind == item_kind::expose,
               is_port = !is_exposed && is_name(m.item().from);
    const auto name = is_exposed ? m.item().to : is_port ? m.found().name : m.item().from;
    if (is_exposed) {
      m.say() << "a port that " << m.graph().name << " exposes";
    } else if (is_port) {
      m.say() << "a port of ";
      m.node();
    } else {
      m.say() << "a node of " << m.graph().name;
    }
    if (name.empty()) m.say() << " has no name, so no wire could name it: give it one";
    else
      m.say() << " is named `" << name
              << "`, but dots join names to paths, and `*` stands for any name: use neither in a name";
  }
};

}  // namespace cca::detail
