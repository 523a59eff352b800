// all_of<S...>: fires if all of its strategies would.
#pragma once

#include <cstddef>

#include <cca/component/strategy.hpp>

namespace cca {
namespace detail {

template <class... Strategies>
constexpr bool exclude_each_other() {
  const clock clocks[] = {strategy_of<Strategies>.in_combination..., clock{}};
  for (std::size_t i = 0; i < sizeof...(Strategies); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (clocks[i].known() && clocks[j].known() && intersection_of(clocks[i], clocks[j]).never())
        return true;
  return false;
}

// Does it fire? The second is for parts with a state.
template <bool KeepsState, class... Strategies>
struct fires_for_all {
  template <class Inputs>
    requires(ProcessingStrategy<Strategies> && ...)
  static constexpr bool fires(beat now, const Inputs& in) {
    return (Strategies{}.fires(now, in) && ...);
  }
};
template <class... Strategies>
struct fires_for_all<true, Strategies...> : strategy_parts<Strategies...> {
  template <class Inputs>
    requires(ProcessingStrategy<Strategies> && ...)
  constexpr bool fires(beat now, const Inputs& in) {
    return this->ask(now, in).all;
  }
};

}  // namespace detail

template <class... Strategies>
struct all_of : detail::fires_for_all<detail::keep_state<Strategies...>, Strategies...> {
  using parts = detail::list<Strategies...>;
  static constexpr detail::clock clock = [] {
    auto all = detail::every(1);
    ((all = detail::intersection_of(all, detail::strategy_of<Strategies>.in_combination)), ...);
    return all;
  }();
  // Two known clocks have no beat in common. (An inactive strategy is no mistake.)
  static constexpr bool excludes_itself = detail::exclude_each_other<Strategies...>();

  static constexpr void add_name(auto& text) {
    text << "all_of<";
    int n = 0;
    ((text << (n++ > 0 ? ", " : ""), detail::add_strategy_name<Strategies>(text)), ...);
    text << ">";
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    return (detail::strategy_of<Strategies>.waits_in_vain(inputs) || ...);
  }
};

}  // namespace cca
