// skeleton.arity: a skeleton gets as many parts as it needs. The skeleton states its mistake.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct skeleton_arity {
  static constexpr std::string_view id = "skeleton.arity";

  static constexpr bool is_broken(when::component_kind, const flat_view&, const finding& f) {
    return !f.item->component->wrong_arity.empty();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.say() << " " << m.item().component->wrong_arity;
  }
};

}  // namespace cca::detail
