// strategy.unknown_port: a strategy names inputs that its component has.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct strategy_unknown_port {
  static constexpr std::string_view id = "strategy.unknown_port";

  static constexpr bool is_broken(when::stated_strategy, const flat_view&, finding& f) {
    if (f.item->kind != item_kind::node) return false;
    return bool(find_part(*f.item->strategy, [&](const strategy_info& strategy) {
      for (const auto name : strategy.named_inputs)
        if (!has_input(*f.item->component, name)) {
          f.name = name;
          return true;
        }
      return false;
    }));
  }

  static constexpr void tell(auto& m) {
    const auto wrong = m.found().name;
    m.at_node();
    m.node();
    m.say() << " is cca::port_triggered by `" << wrong << "`, but it has no such input";
    std::string_view best;
    std::size_t least = 64;
    for (const auto function : functions_of(*m.item().component))
      for (int p = 0; function && p < function->input_count; ++p)
        if (const auto distance = edit_distance(wrong, function->inputs[p].name); distance < least) {
          least = distance;
          best = function->inputs[p].name;
        }
    if (!best.empty()) m.say() << "; did you mean `" << best << "`?";
    else m.say() << ": it has no inputs at all";
  }

private:
  static constexpr bool has_input(const component_info& component, std::string_view name) {
    for (const auto function : functions_of(component))
      for (int p = 0; function && p < function->input_count; ++p)
        if (function->inputs[p].name == name) return true;
    return false;
  }
};

}  // namespace cca::detail
