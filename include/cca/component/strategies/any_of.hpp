// any_of<S...>: fires if some of its strategies would.
#pragma once

#include <cca/component/strategy.hpp>

namespace cca {
namespace detail {

// Does it fire? The second is for parts with a state.
template <bool KeepsState, class... Strategies>
struct fires_for_any {
  template <class Inputs>
    requires(ProcessingStrategy<Strategies> && ...)
  static constexpr bool fires(beat now, const Inputs& in) {
    return (Strategies{}.fires(now, in) || ...);
  }
};
template <class... Strategies>
struct fires_for_any<true, Strategies...> : strategy_parts<Strategies...> {
  template <class Inputs>
    requires(ProcessingStrategy<Strategies> && ...)
  constexpr bool fires(beat now, const Inputs& in) {
    return this->ask(now, in).any;
  }
};

}  // namespace detail

template <class... Strategies>
struct any_of : detail::fires_for_any<detail::keep_state<Strategies...>, Strategies...> {
  using parts = detail::list<Strategies...>;
  static constexpr detail::clock clock = [] {
    auto all = detail::never_clock;
    ((all = detail::union_of(all, detail::strategy_of<Strategies>.in_combination)), ...);
    return all;
  }();

  static constexpr void add_name(auto& text) {
    text << "any_of<";
    int n = 0;
    ((text << (n++ > 0 ? ", " : ""), detail::add_strategy_name<Strategies>(text)), ...);
    text << ">";
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    return sizeof...(Strategies) > 0 && (detail::strategy_of<Strategies>.waits_in_vain(inputs) && ...);
  }
};

}  // namespace cca
