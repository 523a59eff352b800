// node.duplicate_name: the nodes of a graph have different names, and so have the outputs that it exposes.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct node_duplicate_name {
  static constexpr std::string_view id = "node.duplicate_name";

  static constexpr bool is_broken(when::repeated_name, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    m.at_node();
    if (m.item().kind == item_kind::expose) {
      m.say() << "two outputs are exposed as `" << m.item().to << "` by " << m.graph().name
              << ": give one of them another name";
      return;
    }
    m.say() << "two nodes of " << m.graph().name << " are named `" << m.item().from << "`";
    const char* separator = " (";
    for (int i = 0; i < m.graph().count; ++i) {
      const auto& other = m.graph().items[i];
      if (other.from != m.item().from || (!other.component && !other.inner)) continue;
      m.say() << separator << (other.component ? other.component->name() : other.inner->name);
      separator = ", ";
    }
    m.say() << "), so a path to them has two meanings: give one of them another name";
  }
};

}  // namespace cca::detail
