// component.hook_signature: a hook is `void on_...()`.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct component_hook_signature {
  static constexpr std::string_view id = "component.hook_signature";

  static constexpr bool is_broken(when::whole_component, const flat_view&, const finding& f) {
    return !f.item->component->bad_hook.empty();
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    const auto hook = m.item().component->bad_hook;
    m.say() << " has a hook `" << hook << "` that would never be called, because it is not `void " << hook
            << "()`: make it a public function of that signature, or give it another name";
  }
};

}  // namespace cca::detail
