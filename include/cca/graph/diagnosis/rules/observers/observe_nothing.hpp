// observe.nothing: a pattern names something.
#pragma once

#include <cca/graph/diagnosis/nearest_pattern.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct observe_nothing {
  static constexpr std::string_view id = "observe.nothing";

  static constexpr bool is_broken(when::unheard_pattern, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    m.at_node();
    const bool is_node = m.item().kind == item_kind::node;
    const auto wrong = is_node ? port_of(m.g, m.g.inputs[m.found().input]).name : m.item().from;
    if (is_node) {
      m.node();
      m.say() << " observes `" << wrong << "`, which names nothing in ";
    } else {
      m.say() << "cca::observe<`" << wrong << "`> in " << m.graph().name << " names nothing, neither in ";
    }
    const int observer = is_node ? m.g.inputs[m.found().input].call : -1;
    if (wrong.starts_with('/')) m.say() << m.g.scopes[0].graph->name << ", the outermost graph";
    else m.say() << m.graph().name << (is_node ? " or" : " nor") << " in a graph around it";
    m.say() << ", so it would hear nothing";
    const text nearest = nearest_pattern(m.g, wrong, m.found().scope, observer);
    if (nearest.size > 0) m.say() << "; did you mean `" << nearest.view() << "`?";
    else if (wrong.find('/', 1) != wrong.npos)
      m.say() << ": names are joined by dots, and a `/` may only be the first letter, as in `/dmp.status.*`";
    else
      m.say()
          << ": write the path of a port from the nodes of one of these graphs on, as in `node.port`; `*` "
             "stands for one name, and `**` for any number of names";
  }
};

}  // namespace cca::detail
