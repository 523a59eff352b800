// What components derive from the angles of a body (component/ports/derived.hpp): each is computed once in a
// beat, however many components ask for it.
//
//   cca::derived<cca::pose_of<Body>, "angles"> pose              body_pose<Body>
//   cca::derived<cca::end_of<Body, "part">, "angles"> end        rigid: the end of the part
//   cca::derived<cca::jacobian_of<Body, "part">, "angles"> j     6 x coordinates
//
// The mass matrix: dynamics/derived_mass.hpp.
// They take a space of joint angles with the axes of the body in any order, and others beside.
// NaN: as body_pose.hpp says; nothing is kept. Cost: that of body_pose.hpp, once.
// Example: tests/runtime/body/derived_of_body.cpp; docs/body.md.
#pragma once

#include <cca/component/input_status.hpp>
#include <cca/component/ports/derived.hpp>
#include <cca/mapping/forward_kinematics.hpp>
#include <cca/robot/body_pose.hpp>

namespace cca {

template <class Type>
struct pose_of {
  using value = body_pose<Type>;
  template <class Space>
  static value of(const sample<Space>& angles) {
    return value(detail::reordered<axes_of<Type>, Space>::from(angles.vector()));
  }
};

template <class Type, fixed_string Part>
struct end_of {
  using value = rigid;
  using from = cca::from<pose_of<Type>>;
  static value of(const body_pose<Type>& now) { return now.template tip<Part>(); }
};

template <class Type, fixed_string Part>
struct jacobian_of {
  using value = typename body_pose<Type>::jacobian_type;
  using from = cca::from<pose_of<Type>>;
  static value of(const body_pose<Type>& now) { return now.template jacobian<Part>(); }
};

namespace detail {

template <class Derived, class Port>
[[gnu::noinline, gnu::cold]] const typename Derived::value& anew_within_bounds(const Derived& d,
                                                                               const Port& port) {
  input_check bounds;
  return d.anew(sample<typename Port::space>(bounds(port.vector()), port.origin()));
}

// Of an input that an input_check has read, among others: of the port, unless that cut some of them.
template <class Derived, class Port>
CCA_INLINE const typename Derived::value& within_bounds(const Derived& d,
                                                        const Port& port,
                                                        const input_check& inputs) {
  if (inputs.get() != input_status::usable) [[unlikely]]
    return anew_within_bounds(d, port);
  return d.of(port);
}

}  // namespace detail
}  // namespace cca
