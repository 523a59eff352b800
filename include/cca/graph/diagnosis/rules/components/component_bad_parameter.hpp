// component.bad_parameter: a component's function takes only ports, what is derived from them and the beat,
// each input under a name of its own.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct component_bad_parameter {
  static constexpr std::string_view id = "component.bad_parameter";

  static constexpr bool is_broken(when::component_function, const flat_view&, const finding& f) {
    return !f.function->bad_parameter.empty() || !f.function->bad_derived.empty();
  }
  static constexpr bool is_broken(when::repeated_port, const flat_view&, const finding& f) {
    return f.input >= 0;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    if (m.found().input >= 0) {
      m.say() << " has two inputs named `" << m.found().name
              << "`, so a wire to it would have two meanings: give one of them another name";
      return;
    }
    constexpr std::string_view names[] = {"sense", "process", "act"};
    for (std::size_t which = 0; which < 3; ++which) {
      const auto function = functions_of(*m.item().component)[which];
      if (!function || (function->bad_parameter.empty() && function->bad_derived.empty())) continue;
      m.say() << ": `" << names[which] << "` takes ";
      if (function->bad_parameter.empty())
        m.say() << "a cca::derived of `" << function->bad_derived
                << "`, but has no input of that name: name the cca::in from whose sample the value follows";
      else
        m.say()
            << "`" << function->bad_parameter
            << "`, but it may take only ports (cca::in, cca::optional_in, cca::observe), a cca::derived of "
               "one of them and the cca::beat, each by value or by reference to const; give constants as "
               "`parameters`, and data of other components by a wire";
      return;
    }
  }
};

}  // namespace cca::detail
