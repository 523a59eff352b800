// The numbers of one or several spaces in a row, each with name, unit and limits, as Python sees them.
#pragma once

#include <string>
#include <vector>

#include <cca/mapping/policy.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::python {

struct described_numbers {
  std::vector<std::string> names, units;
  std::vector<double> low, high;
  std::size_t count() const { return names.size(); }
};

namespace detail {

// `before`: of each name, "down." say.
template <class S>
void describe(described_numbers& all, const std::string& before) {
  constexpr auto& schema = cca::schema_of<S>;
  for (int i = 0; i < schema.field_count(); ++i) {
    const auto f = schema.field(i);
    all.names.push_back(before + std::string(f.name()));
    all.units.emplace_back(f.unit);
    all.low.push_back(f.lower), all.high.push_back(f.upper);
  }
}

template <class... In>
described_numbers observed_numbers(policy_inputs<In...>*) {
  described_numbers all;
  (describe<typename In::space>(all, std::string(In::name) + "."), ...);
  return all;
}

}  // namespace detail

template <class StandIn>
described_numbers observations_of() {
  return detail::observed_numbers(static_cast<typename StandIn::inputs*>(nullptr));
}
template <class StandIn>
described_numbers actions_of() {
  described_numbers all;
  detail::describe<typename StandIn::action_space>(all, "");
  return all;
}

}  // namespace cca::python
