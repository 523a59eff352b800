// Shows components by path to <cca/config.hpp> like a controller, but without a graph.
//
//   struct elements : shown_components<elements> {
//     static constexpr std::string_view file = "motor.toml";      the file's name in messages
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

  // The message; empty if the file was accepted.
  std::string refusal(std::string_view text) {
    try {
      cca::detail::load_parameters_from_text(static_cast<Shown&>(*this), text, Shown::file);
    } catch (const cca::refused& refusal) { return refusal.what(); }
    return {};
  }
};

}  // namespace config_test
