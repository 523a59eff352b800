// stoppable<S>: fires when S does, while its component is started. The component can be stopped and started
// on its own, between two beats (`controller::stop<Path>()`) or by itself (`done`). docs/strategies.md.
#pragma once

#include <cca/component/strategy.hpp>

namespace cca {

template <class Strategy>
struct stoppable {
  using parts = detail::list<Strategy>;
  static constexpr bool is_stoppable = true;

  static constexpr void add_name(auto& text) {
    text << "stoppable<", detail::add_strategy_name<Strategy>(text);
    text << ">";
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    return detail::strategy_of<Strategy>.waits_in_vain(inputs);
  }

  template <class Inputs>
    requires ProcessingStrategy<Strategy>
  static constexpr bool fires(beat now, const Inputs& in) {
    return !in.is_stopped() && Strategy{}.fires(now, in);
  }
};

}  // namespace cca
