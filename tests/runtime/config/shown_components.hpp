// Components at their paths, as a controller shows them to <cca/config.hpp>, without a graph.
//
//   struct elements : shown_components<elements> {
//     static constexpr std::string_view file = "motor.toml";      what messages call the text
//     cca::hopf<turn> cpg;
//     template <class Self, class F> static void each(Self& self, F& f) { f("cpg", self.cpg); }
//   };
#pragma once

#include <string>
#include <string_view>

#include <cca/config.hpp>

namespace config_test {

template <class Shown>
struct shown_components {
  template <class F>
  void for_each_component(F f) {
    Shown::each(static_cast<Shown&>(*this), f);
  }
  template <class F>
  void for_each_component(F f) const {
    Shown::each(static_cast<const Shown&>(*this), f);
  }

  std::string text() const {
    return cca::detail::parameters_text(static_cast<const Shown&>(*this), Shown::file);
  }

  // Empty if it was accepted.
  std::string refusal(std::string_view text) {
    try {
      cca::detail::load_parameters_from_text(static_cast<Shown&>(*this), text, Shown::file);
    } catch (const cca::refused& refusal) { return refusal.what(); }
    return {};
  }
};

}  // namespace config_test
