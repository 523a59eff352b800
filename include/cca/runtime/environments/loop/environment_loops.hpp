// The loops of all environments of a deployment.
#pragma once

#include <utility>

#include <cca/runtime/environments/loop/environment_loop.hpp>

namespace cca::detail {

template <class D, class Environments = std::make_integer_sequence<int, environment_count<D>>>
struct environment_loops;
template <class D, int... E>
struct environment_loops<D, std::integer_sequence<int, E...>> : environment_loop<D, E>... {
  template <int Environment>
  auto& at() {
    return static_cast<environment_loop<D, Environment>&>(*this);
  }
  template <int Environment>
  const auto& at() const {
    return static_cast<const environment_loop<D, Environment>&>(*this);
  }
  // f.template operator()<E>(loop) for each.
  template <class F>
  void for_each(F f) {
    (f.template operator()<E>(at<E>()), ...);
  }
  template <class F>
  void for_each(F f) const {
    (f.template operator()<E>(at<E>()), ...);
  }
};

}  // namespace cca::detail
