// A component with the ports of a policy whose answers come from outside, so a graph can be trained around
// it: it keeps what the policy would observe, and publishes what a program has set.
//
//   cca::node<"policy", cca::python::stand_in<walk>, cca::timed<20>>       walk: a cca::policy
//
//   in  <own names>   those of the policy
//   out "output"      that of the policy: maybe; `answer`, within the limits of the axes
//   out "status"      input_status_port
//
// It publishes as the policy does (mapping/policy.hpp): nothing until each input has a sample, and nothing
// while one is NaN or infinite. `cca::python::stand_in_of<cca::policy_inputs<...>, To>` is the same without a
// policy. It needs no Python. Cost: copying the numbers. Errors: none in a beat.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>

#include <cca/component/input_status.hpp>
#include <cca/component/port.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/space/domain.hpp>

namespace cca::python {

template <class Inputs, Space To>
struct stand_in_of;

template <class... In, Space To>
struct stand_in_of<policy_inputs<In...>, To> {
  using inputs = policy_inputs<In...>;
  using action_space = To;
  static constexpr int observed = (In::space::size + ... + 0);
  using observation = Eigen::Matrix<double, observed, 1>;
  using action = typename To::vector_type;

  auto process(In... all) -> std::tuple<maybe<"output", To>, out<"status", input_status_port>> {
    cca::detail::input_check check;
    int at = 0;
    (void)((observations.template segment<In::space::size>(at) = check(all.vector()), at += In::space::size),
           ...);
    ++firings;
    maybe<"output", To> output;
    if (((all.origin() != never) && ...) && !check.unreadable()) output = within_limits(answer);
    return {output, status_of(check.get())};
  }

  observation observations = observation::Zero();  // of the last firing, one input after the other
  action answer = action::Zero();                  // finite
  std::int64_t firings = 0;

private:
  static action within_limits(action y) {
    constexpr auto& space = cca::detail::space_of<To>;
    for (int i = 0; i < To::size; ++i)
      y[i] = std::min(std::max(y[i], std::max(space.lower[i], -largest_input)),
                      std::min(space.upper[i], largest_input));
    return y;
  }
};

namespace detail {
template <class... In, int... Units, class Activation, Space To>
stand_in_of<policy_inputs<In...>, To> stand_in_for(
    const policy<policy_inputs<In...>, hidden_layers<Units...>, Activation, To>*);
}

template <class Policy>
struct stand_in : decltype(detail::stand_in_for(static_cast<const Policy*>(nullptr))) {
  using policy_type = Policy;
};

}  // namespace cca::python
