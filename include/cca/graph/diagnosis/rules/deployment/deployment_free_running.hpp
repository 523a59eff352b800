// deployment.free_running: what runs in a free-running environment is full_speed, while it is started; and
// the first environment, which gives the beat, is not free-running. In a
// deployment of modes none is.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_free_running {
  static constexpr std::string_view id = "deployment.free_running";

  static constexpr bool is_broken(when::finished_environment, const flat_view& g, finding& f) {
    if (!g.environments[f.environment].is_free_running) return false;
    if (f.environment == 0 || g.modes) return true;
    for (int n = 0; n < g.node_count; ++n)
      if (g.nodes[n].environment == f.environment && !is_full_speed(*g.nodes[n].item)) {
        f.item = g.nodes[n].item;
        f.scope = g.nodes[n].scope;
        f.component = n;
        return true;
      }
    return false;
  }

  static constexpr void tell(auto& m) {
    if (m.g.modes) {
      m.where << m.g.environments[m.found().environment].name;
      m.environment(m.found().environment);
      m.say() << " of " << m.deployment().name
              << " is cca::free_running, but the environments of a set of modes switch in one beat, and its "
                 "cycles are no beats: remove cca::free_running, or deploy one graph, and stop parts of it";
      return;
    }
    if (!m.found().item) {
      m.where << m.g.environments[0].name;
      m.environment(0);
      m.say() << " is the first of " << m.deployment().name
              << ", which gives the beat, but a cca::free_running one has none: put the environment of the "
                 "robot before it";
      return;
    }
    m.at_node();
    m.node();
    m.say() << " runs in ";
    m.environment(m.found().environment);
    m.say() << ", whose cycles begin without pause, but its strategy is ";
    strategy_of_call(m.g, m.g.calls[m.g.nodes[m.found().component].first_call]).add_name(m.say());
    m.say() << ": write cca::node<`" << m.item().from << "`, " << m.item().component->name()
            << (m.item().is_stoppable() ? ", cca::stoppable<cca::full_speed>>" : ", cca::full_speed>")
            << ", or place it in another environment";
  }

private:
  static constexpr bool is_full_speed(const item_info& node) {
    const auto strategy = node.strategy_while_started();
    return strategy && &*strategy == &strategy_of<full_speed>;
  }
};

}  // namespace cca::detail
