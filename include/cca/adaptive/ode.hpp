// An ordinary differential equation x' = f(x, u, p) with state x, input u and parameters p (the source
// document, chapter 3, *ODE*).
//
//   struct decay {
//     using state = Eigen::Matrix<double, 1, 1>;      // fixed-size vector, or a space
//     using input = Eigen::Matrix<double, 1, 1>;
//     struct parameters { double rate; };
//     static state derivative(const state& x, const input& u, const parameters& p) {
//       return p.rate * (u - x);
//     }
//   };
//
// A model has no state of its own: the solver (ode_solver.hpp) holds the state, the component the parameters.
// A model may also have:
//
//   initial()        the first state of a solver; default: zero
//   project(x)       returns x to its valid set after each step (a quaternion to unit length)
//   positions        the number of leading coordinates whose rates are given by the others: a second-order
//                    system, which the semi-implicit Euler method needs
//   fastest(x, u, p) an upper bound of its rates of decay and rotation, in 1/s: the solver divides a step
//                    that is too long for the integrator
//   flow(x, u, p, t) the state t seconds later in closed form: the solver takes it instead of dividing a step
//
// Preconditions: `derivative` returns the same for the same arguments and does not allocate.
// Laws: tests/laws/ode_laws.hpp. Example: tests/runtime/ode/example.cpp; docs/ode.md.
#pragma once

#include <concepts>

#include <cca/base/eigen.hpp>
#include <cca/space/space.hpp>

namespace cca {
namespace detail {

template <class Type>
struct vector_of {
  using type = Type;
};
template <Space Type>
struct vector_of<Type> {
  using type = typename Type::vector_type;
};

template <class Type> concept FixedVector =
    EigenVector<Type> && Type::RowsAtCompileTime >= 0 && Type::ColsAtCompileTime == 1;

}  // namespace detail

// The vectors of a model, which may name a space or a vector type.
template <class Model>
using ode_state = typename detail::vector_of<typename Model::state>::type;
template <class Model>
using ode_input = typename detail::vector_of<typename Model::input>::type;

template <class Model> concept Ode =
    detail::FixedVector<ode_state<Model>> && detail::FixedVector<ode_input<Model>> &&
    requires(const ode_state<Model>& x, const ode_input<Model>& u, const typename Model::parameters& p) {
      { Model::derivative(x, u, p) } -> std::convertible_to<ode_state<Model>>;
    };

// The positions are the first coordinates.
template <class Model> concept SecondOrderOde =
    Ode<Model> && Model::positions > 0 && Model::positions < ode_state<Model>::RowsAtCompileTime;

template <Ode Model>
ode_state<Model> initial_state() {
  if constexpr (requires { Model::initial(); }) return Model::initial();
  else return ode_state<Model>::Zero();
}

}  // namespace cca
