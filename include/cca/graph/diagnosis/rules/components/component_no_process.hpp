// component.no_process: a component has `process`; a resource node has `sense` and `act`.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct component_no_process {
  static constexpr std::string_view id = "component.no_process";

  static constexpr bool is_broken(when::component_kind, const flat_view&, const finding& f) {
    const auto& c = *f.item->component;
    return (!c.process && !c.resource()) || c.also_sense || c.also_act || c.is_const;
  }

  static constexpr void tell(auto& m) {
    const auto& c = *m.item().component;
    m.at_node();
    m.node();
    if (is_lambda(c.spelled_type))
      m.say()
          << " is a lambda, which has no `process` from which its ports could be read: write a struct whose "
             "`process` does what the lambda does, as in `struct gait { auto process(cca::in<...>) -> "
             "cca::out<...>; };`; what it captures becomes members and parameters";
    else if (!c.instead.before.empty()) m.say() << c.instead.before << m.graph().name << c.instead.after;
    else if (!c.process && !c.resource())
      m.say()
          << " has no `process` from which its ports could be read: give it one, public, neither overloaded "
             "nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource node has "
             "`sense` and `act` instead";
    else if (c.also_sense || c.also_act)
      m.say() << " has both `process` and `" << (c.also_sense ? "sense" : "act")
              << "`: a component has `process`, a resource node has `sense` and `act`; make two nodes of it";
    else m.say() << " is const, but a component changes as it runs: remove the `const`";
  }

private:
  // As the compilers spell the type of a lambda.
  static constexpr bool is_lambda(std::string_view type) {
    return type.find("<lambda(") != type.npos || type.find("(lambda at ") != type.npos;
  }
};

}  // namespace cca::detail
