// stoppable<S>: fires when S does, while its part is started. The part, a component or a whole inner graph,
// can be stopped and started on its own: between two beats (`controller::stop<Path>()`), by a component
// (stops, starts), or by the component itself (done). A graph is `stoppable<>`: the strategies stand on the
// components inside. `stoppable<>` on a component keeps its default strategy. docs/strategies.md.
#pragma once

#include <type_traits>

#include <cca/component/strategy.hpp>

namespace cca {

template <class Strategy = detail::by_default>
struct stoppable {
  using parts = detail::list<Strategy>;
  static constexpr bool is_stoppable = true;

  static constexpr void add_name(auto& text) {
    text << "stoppable<";
    if constexpr (!std::is_same_v<Strategy, detail::by_default>) detail::add_strategy_name<Strategy>(text);
    text << ">";
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    return detail::strategy_of<Strategy>.waits_in_vain(inputs);
  }

  // The loop asks S itself, and only while the part is started.
  template <class Inputs>
    requires(ProcessingStrategy<Strategy> || std::is_same_v<Strategy, detail::by_default>)
  static constexpr bool fires(beat now, const Inputs& in) {
    if (in.is_stopped()) return false;
    if constexpr (std::is_same_v<Strategy, detail::by_default>) return in.any_fresh();
    else return Strategy{}.fires(now, in);
  }
};

}  // namespace cca
