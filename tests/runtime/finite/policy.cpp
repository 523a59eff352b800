// A policy under the laws of finite numbers.
#include <cca/mapping/policy.hpp>

#include "../../laws/finite_laws.hpp"

namespace {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct trunk : cca::frame<"trunk"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct place : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct numbers : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

// Its weights are drawn, not trained; before the first sample it says nothing.
struct walk : cca::policy<cca::policy_inputs<cca::in<"angles", leg>, cca::in<"foot", place>>,
                          cca::hidden_layers<6, 5>,
                          cca::hyperbolic_tangent,
                          numbers> {};
template <class Type, int Size>
struct drawn : laws::finite_case<Type> {
  static auto made() {
    auto c = std::make_unique<Type>();
    laws::numbers n(3);
    for (double& w : c->weights.weights) w = Size * n.usual();
    c->weights.gain.setConstant(Size);
    return c;
  }
};
struct bold : cca::policy<cca::policy_inputs<cca::in<"angles", leg>, cca::in<"foot", place>>,
                          cca::hidden_layers<6, 5>,
                          cca::rectifier,
                          numbers> {};

}  // namespace

TEST_CASE("mapping/policy.hpp") {
  laws::finite<drawn<walk, 1>>();
  laws::finite<drawn<bold, 1>>();
  laws::stays_finite<drawn<bold, 1'000'000'000>>();
}
