// port_triggered<"x", ...>: fires if any of the named inputs is fresh.
#pragma once

#include <array>
#include <string_view>

#include <cca/component/arrival_clocks.hpp>
#include <cca/component/strategy.hpp>

namespace cca {

template <fixed_string... Inputs>
struct port_triggered {
  static constexpr std::array<std::string_view, sizeof...(Inputs) + 1> names{Inputs.view()..., {}};
  static constexpr detail::input_names named_inputs{names.data(), sizeof...(Inputs)};
  static constexpr bool fires_on_arrival = true;

  static constexpr void add_name(auto& text) { text << "port_triggered"; }
  static constexpr detail::clock clock_from(const detail::arrivals& inputs) {
    return detail::any_arrival(inputs, [](std::string_view input) { return named_inputs.has(input); });
  }
  static constexpr bool waits_in_vain(const detail::arrivals& inputs) {
    for (const auto& arrival : inputs)
      if (named_inputs.has(arrival.input)) return false;
    return true;
  }

  template <class Wired>
  static constexpr bool fires(beat, const Wired& in) {
    return (in.template fresh<Inputs>() || ...);
  }
};

}  // namespace cca
