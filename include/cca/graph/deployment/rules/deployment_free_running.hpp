// deployment.free_running: what runs in a free-running environment is full_speed, while it is started, in
// each mode; and the first environment, which gives the beat, is not free-running.
#pragma once

#include <cca/graph/deployment/placement_events.hpp>

namespace cca::detail {

struct deployment_free_running {
  static constexpr std::string_view id = "deployment.free_running";

  static constexpr bool is_broken(when::stated_environment, const flat_view& g, const finding& f) {
    return environment_of(f) == 0 && environment_in(g, 0).is_free_running;
  }
  static constexpr bool is_broken(when::free_node, const flat_view&, const finding& f) {
    return !is_full_speed(*f.item);
  }

  static constexpr void tell(auto& m) {
    if (!m.found().item) {
      m.where << environment_in(m.g, 0).name;
      m.environment(0);
      m.say() << " is the first of " << m.deployment().name
              << ", which gives the beat, but a cca::free_running one has none: put the environment of the "
                 "robot before it";
      return;
    }
    m.at_node();
    m.node();
    m.of_mode();
    m.say() << " runs in ";
    m.environment(environment_of(m.found()));
    m.say() << ", whose cycles begin without pause, but its strategy is ";
    strategy_of_call(m.g, m.g.calls[m.g.nodes[m.found().component].first_call]).add_name(m.say());
    m.say() << ": write cca::node<`" << m.item().from << "`, " << m.item().component->name()
            << (m.item().is_stoppable() ? ", cca::stoppable<cca::full_speed>>" : ", cca::full_speed>")
            << ", or place it in another environment";
  }

  static constexpr bool is_full_speed(const item_info& node) {
    const auto strategy = node.strategy_while_started();
    return strategy && &*strategy == &strategy_of<full_speed>;
  }
};

}  // namespace cca::detail
