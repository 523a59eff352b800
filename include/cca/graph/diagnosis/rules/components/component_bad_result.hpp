// component.bad_result: a component's function returns only ports and what it asks of the controller, each
// output under a name of its own.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct component_bad_result {
  static constexpr std::string_view id = "component.bad_result";

  static constexpr bool is_broken(when::component_function, const flat_view&, const finding& f) {
    return !f.function->bad_result.empty();
  }
  static constexpr bool is_broken(when::repeated_port, const flat_view&, const finding& f) {
    return f.output >= 0;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    if (m.found().output >= 0) {
      m.say() << " has two outputs named `" << m.found().name
              << "`, so a wire to it would have two meanings: give one of them another name";
      return;
    }
    constexpr std::string_view names[] = {"sense", "process", "act"};
    for (std::size_t which = 0; which < 3; ++which) {
      const auto function = functions_of(*m.item().component)[which];
      if (!function || function->bad_result.empty()) continue;
      m.say() << ": `" << names[which] << "` returns `" << function->bad_result
              << "`, but it may return only ports (cca::out, cca::maybe), a cca::fault, a cca::done, "
                 "cca::switch_to<...>, cca::stops<...> and cca::starts<...>, one or several in a std::tuple, "
                 "or void";
      return;
    }
  }
};

}  // namespace cca::detail
