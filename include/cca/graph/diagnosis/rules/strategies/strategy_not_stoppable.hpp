// strategy.not_stoppable: a component that stops itself has a strategy that lets it be stopped.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct strategy_not_stoppable {
  static constexpr std::string_view id = "strategy.not_stoppable";

  static constexpr bool is_broken(when::component_function, const flat_view&, const finding& f) {
    return f.function->stops_itself && !f.item->is_stoppable();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.say() << " returns cca::done, by which it stops itself, ";
    if (m.item().component->resource())
      m.say() << "but a resource node stops only with its controller: leave the cca::done out";
    else
      m.say()
          << "but its strategy does not let it be stopped: write cca::stoppable<...> around the strategy, "
             "for example cca::stoppable<cca::restless>";
  }
};

}  // namespace cca::detail
