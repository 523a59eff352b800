// strategy.no_fires: a strategy says when it fires.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct strategy_no_fires {
  static constexpr std::string_view id = "strategy.no_fires";

  static constexpr bool is_broken(when::stated_strategy, const flat_view&, const finding& f) {
    return f.item->kind == item_kind::node && !f.item->unknown_type.empty();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.say() << " has the strategy `" << m.item().unknown_type << "`, which cannot say when it fires: ";
    if (!m.item().instead.empty()) m.say() << m.item().instead;
    else
      m.say() << "use one like cca::timed<10> or cca::moderate, or give it `template <class Inputs> static "
                 "bool fires(cca::beat, const Inputs&)` (not static if it has a state) and a constructor "
                 "without arguments";
  }
};

}  // namespace cca::detail
