// Stops the robot when a component receives NaN or infinity (input_status.hpp).
//
//   cca::node<"check", cca::fault_when_unreadable<cca::input_status_port, 5>>
//   cca::wire<"servo.status", "check.status">
//
//   in  "status"   Status   input_status_port or ode_status_port
//   fault "an input is NaN or infinite"   when the status is `unreadable` in `Firings` firings in a row
//
// A component that keeps no wrong number may go on when the right ones come back, so the library does not
// choose how long it may last. Cost: a comparison. Example: tests/runtime/finite/faults.cpp.
#pragma once

#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/port.hpp>

namespace cca {

namespace detail {

template <int Firings>
struct no_firings {
  static constexpr void tell(text& m) {
    m << "cca::fault_when_unreadable: it stops after " << Firings
      << " unreadable inputs in a row: make this number 1 or more";
  }
};

}  // namespace detail

template <class Status = input_status_port, int Firings = 1>
  requires(std::is_same_v<Status, input_status_port> || std::is_same_v<Status, ode_status_port>)
struct fault_when_unreadable {
  static_assert(detail::holds_or_tells<(Firings >= 1), detail::no_firings<Firings>>::value);

  auto process(in<"status", Status> now) -> fault {
    using states = std::conditional_t<std::is_same_v<Status, ode_status_port>, ode_status, input_status>;
    in_a_row = now.template is<states>(states::unreadable) ? in_a_row + 1 : 0;
    return in_a_row >= Firings ? fault("an input is NaN or infinite") : fault();
  }

  void on_start() { in_a_row = 0; }

private:
  int in_a_row = 0;
};

}  // namespace cca
