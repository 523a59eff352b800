// plan.unknown_path: a plan or a condition asks for what its component hears.
#pragma once

#include <cca/base/nearest.hpp>
#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/patterns.hpp>

namespace cca::detail {

struct plan_unknown_path {
  static constexpr std::string_view id = "plan.unknown_path";

  static constexpr bool is_broken(when::asked_path, const flat_view& g, const finding& f) {
    return f.input < 0 || f.axis < 0 || f.axis >= port_of(g, g.outputs[f.output]).space->size;
  }

  static constexpr void tell(auto& m) {
    const auto& f = m.found();
    m.at_node();
    m.node();
    if (f.input >= 0) {
      const int size = port_of(m.g, m.g.outputs[f.output]).space->size;
      m.say() << " asks for number " << f.axis << " of `" << f.name << "`, which has " << size
              << (size == 1 ? " number" : " numbers") << ": count from 0";
      return;
    }
    m.say() << " asks for `" << f.name << "`, which nobody publishes under what it observes (";
    bool is_first = true;
    for_each_observer(m.g, f.call, [&](const input& observer) {
      m.say() << (is_first ? "`" : ", `") << port_of(m.g, observer).name << "`";
      is_first = false;
    });
    m.say() << "), so it would wait for ever";
    const text nearest = nearest_heard(m.g, f.call, f.name, f.scope);
    if (nearest.size > 0) m.say() << "; did you mean `" << nearest.view() << "`?";
    else m.say() << ": name one that is published there, as in `node.port`, or let it observe more";
  }

private:
  // Of what the component hears, as it would name that.
  static constexpr text nearest_heard(const flat_view& g, int call, std::string_view wrong, int scope) {
    text nearest;
    std::size_t least = wrong.size() / 3 + 2;
    for (int l = 0; l < g.link_count; ++l) {
      if (const auto& own = g.inputs[g.links[l].observer]; own.call != call || own.outside) continue;
      text candidate;
      for (int s = scope; s >= 0 && candidate.size == 0; s = g.scopes[s].parent)
        add_path(candidate, path_from(g, name_of_link(g, g.links[l]), s));
      if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
        least = distance;
        nearest = candidate;
      }
    }
    return nearest;
  }
};

}  // namespace cca::detail
