// observe.bad_policy: an observer has policies of a wire.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct observe_bad_policy {
  static constexpr std::string_view id = "observe.bad_policy";

  static constexpr bool is_broken(when::observer_policy, const flat_view& g, const finding& f) {
    const auto& policy = policy_of(g, f);
    return !policy.unknown_type.empty() || policy.repeats_option || policy.initial ||
           policy.policy == policy_kind::merged || policy.too_small != policy_kind::unstated;
  }

  static constexpr void tell(auto& m) {
    const bool is_component = m.found().input >= 0;
    const auto& policy = policy_of(m.g, m.found());
    m.at_node();
    m.say() << "cca::observe<`"
            << (is_component ? port_of(m.g, m.g.inputs[m.found().input]).name : policy.from) << "`> ";
    if (is_component) {
      m.say() << "of ";
      m.node();
    } else {
      m.say() << "in " << m.graph().name;
    }
    if (!policy.unknown_type.empty())
      m.say() << " has `" << policy.unknown_type << "`, which is no policy of an observer";
    else if (policy.policy == policy_kind::merged)
      m.say()
          << " is cca::merged, but what it hears may be of several spaces, and each has a queue of its own";
    else if (policy.initial)
      m.say()
          << " has an initial value, but what it hears may be of several spaces, and begins with the zero "
             "of each";
    else m.say() << " has two policies of one kind, or one with a number below 1";
    m.say() << ": write cca::latest, cca::delayed<N> or cca::queue<C, F>, each as on a wire";
  }

private:
  static constexpr const item_info& policy_of(const flat_view& g, const finding& f) {
    return f.input >= 0 ? port_of(g, g.inputs[f.input]).policy() : *f.item;
  }
};

}  // namespace cca::detail
