// What is wrong with the names in a plan, as a message of the compiler.
// Errors: plan.unknown_step.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <cca/base/nearest.hpp>
#include <cca/base/text.hpp>
#include <cca/base/type_name.hpp>

namespace cca::detail {

// The first mistake.
template <class Plan>
constexpr void tell_wrong_steps(text& said) {
  std::array<std::string_view, Plan::table.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = Plan::table[i].name;
  const auto is_known = [&](std::string_view step, const char* option, std::string_view name) {
    if (said.size > 0 || Plan::find(name) >= 0) return;
    said << "plan.unknown_step: the step `" << step << "` of " << type_name<Plan>() << " names `" << name
         << "` in its cca::" << option << ", but the plan has no such step";
    if (const auto near = nearest_name(name, names); !near.empty())
      said << "; did you mean `" << near << "`?";
    else said << ": add it, or name another one";
  };
  if (names.empty()) said << "plan.unknown_step: " << type_name<Plan>() << " has no step: name one or more";
  for (int i = 0; i < Plan::count; ++i) {
    const auto& one = Plan::table[static_cast<std::size_t>(i)];
    if (said.size == 0 && Plan::find(one.name) != i)
      said << "plan.unknown_step: two steps of " << type_name<Plan>() << " are named `" << one.name
           << "`, so it has two meanings: give one of them another name";
    if (!one.next.empty()) is_known(one.name, "then", one.next);
    if (!one.otherwise.empty()) is_known(one.name, "or_after", one.otherwise);
    for (int k = 0; k < one.choice_count; ++k)
      is_known(one.name, "then_one_of", one.choices[static_cast<std::size_t>(k)]);
  }
}

template <class Plan>
struct wrong_steps {
  static constexpr void tell(text& m) { tell_wrong_steps<Plan>(m); }
};

}  // namespace cca::detail
