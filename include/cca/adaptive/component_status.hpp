// Component Status: the state of an adaptive component, from ODE Status, Module Status and the state of its
// criterion (the source document, chapter 3 and section 4.4.4).
//
//   diverged                 the criterion is lost
//   reached                  the criterion is fulfilled (if it requires rest: and the ode has converged)
//   outside_trained_region   neither, and the input of the module lies outside its trained region
//   converging               otherwise
//
// The node `status` of an adaptive component publishes all three, so `observe<"dmp.status.*">` receives them:
//
//   in  "ode"        ode_status_port
//   in  "module"     module_status_port     optional: a module without a learner has none
//   in  "criterion"  criterion_port
//   out "ode", "module"                     as received
//   out "component"  component_status_port
//
// It has no state. A number that no enumerator has (NaN too) counts as the first: ode `transient`, criterion
// `open`, so nothing is reached.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include <cca/adaptive/criterion.hpp>
#include <cca/adaptive/module_status.hpp>
#include <cca/adaptive/ode_status.hpp>

namespace cca {

enum class component_status : std::uint8_t { converging, reached, outside_trained_region, diverged };

constexpr std::string_view to_string(component_status state) {
  constexpr std::array<std::string_view, 4> names{"converging", "reached", "outside the trained region",
                                                  "diverged"};
  return names[static_cast<std::size_t>(state)];
}

struct component_axis : dimension<"component"> {};
struct component_status_port : space<status, axes<component_axis>> {};

// `rests`: the ode has converged, or does not have to.
constexpr component_status component_status_from(criterion_state criterion,
                                                 trained_region region,
                                                 bool rests) {
  if (criterion == criterion_state::lost) return component_status::diverged;
  if (criterion == criterion_state::fulfilled && rests) return component_status::reached;
  return region == trained_region::outside ? component_status::outside_trained_region
                                           : component_status::converging;
}

template <bool AtRest>
struct status_of_component {
  auto process(in<"ode", ode_status_port> ode,
               optional_in<"module", module_status_port> module,
               in<"criterion", criterion_port> criterion)
      -> std::tuple<out<"ode", ode_status_port>,
                    out<"module", module_status_port>,
                    out<"component", component_status_port>> {
    const auto of_module = module ? module.vector() : status_of(learning::idle, trained_region::inside);
    const auto region = static_cast<trained_region>(of_module[1] != 0);
    const bool rests = !AtRest || ode.template is<ode_status>(ode_status::converged);
    return {ode, of_module,
            status_of(component_status_from(criterion.template as<criterion_state>(), region, rests))};
  }
};

}  // namespace cca
