// Shared by the tests of motor components: a component between scripted inputs.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <doctest/doctest.h>

#include <cca/cca.hpp>

#include "../../laws/ode_laws.hpp"

namespace motor_test {

struct stride : cca::dimension<"stride"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct plane : cca::space<cca::number, cca::axes<hip, knee>> {};

// A port, filled as the loop does it.
template <class Port>
Port given(const typename Port::vector_type& v, bool fresh = true) {
  return Port(v, 0, fresh);
}
template <class Port>
Port wired(const typename Port::vector_type& v, bool fresh = true) {
  Port port(v, 0, fresh);
  port.set_wired();
  return port;
}

template <class Space>
typename Space::vector_type one(double value) {
  return Space::vector_type::Constant(value);
}

// Beats of 1 ms.
inline cca::beat at(std::int64_t k) { return {k, 1'000'000, 1}; }

}  // namespace motor_test
