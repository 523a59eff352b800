// Adaptive modules under the laws of finite numbers. They keep what they learned.
#pragma once

#include <cca/space/domain.hpp>

#include "../../laws/finite_laws.hpp"

namespace finite_test {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};

template <class Type>
struct learns : laws::finite_case<Type> {
  static constexpr bool forgets = false;
};

// While it learns online, with a demonstration of any finite numbers.
template <class Type>
struct learning_now : learns<Type> {
  static auto made() {
    auto m = std::make_unique<Type>();
    if constexpr (requires { m->learning.learn(); }) m->learning.learn();
    else m->learning.collect();
    return m;
  }
};
template <class Type>
void laws_of() {
  laws::finite<learns<Type>>();
  laws::stays_finite<learning_now<Type>>();
}

}  // namespace finite_test
