// The components of mapping/ under the laws of finite numbers. Most have no state: NaN passes through them.
#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/mapping.hpp>
#include <cca/motor/dmp_shapes.hpp>

#include "../../laws/finite_laws.hpp"
#include "../mapping/chains.hpp"

namespace {

using namespace mapping_test;

template <class Type>
struct stateless : laws::finite_case<Type> {
  static constexpr bool says_unreadable = false, passes_nan = true;
};
struct half {
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return 0.5 * p; }
};
using halved = cca::mapping<foot_in_hip, foot_in_hip, half>;
using halved_here = cca::transformation<foot_in_hip, half>;
using moved = cca::frame_change<hip_in_trunk, foot_in_hip, foot_in_trunk>;

struct arm_angles : cca::space<cca::joint_angles, cca::axes<a1, a2, a4, slide>> {};
using forward = cca::forward_kinematics<sliding_arm, arm_angles, foot_in_trunk>;
using inverse = cca::inverse_kinematics<sliding_arm, arm_angles, foot_in_trunk>;

// Its answer is always finite, but its status is a cca::reaching.
struct search : laws::finite_case<inverse> {
  [[maybe_unused]] static constexpr bool says_unreadable = false;  // clang 19 overlooks its use
};

struct learned_space : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
using machine = cca::extreme_learning_machine<cca::elm_function<learned_space, learned_space, 10>>;
// y = W x, learned by least squares.
struct line {
  using from = learned_space;
  using to = learned_space;
  using input = Eigen::Vector2d;
  using output = Eigen::Vector2d;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (Eigen::Matrix2d, weights));
    parameters() : weights(Eigen::Matrix2d::Zero()) {}
  };
  static Eigen::Vector2d regressors(const input& x) { return x; }
  static output answer(const parameters& p, const input& x) { return p.weights * x; }
  static std::string title() { return "line"; }
};
using fitted = cca::recursive_least_squares<line>;

template <class Type>
struct learned : stateless<Type> {
  static constexpr bool forgets = false;
};

}  // namespace

TEST_CASE("mapping/mapping.hpp") {
  laws::finite<stateless<halved>>();
  laws::finite<stateless<halved_here>>();
}
TEST_CASE("mapping/mapping_chain.hpp") { laws::finite<stateless<cca::mapping_chain<halved, moved>>>(); }
TEST_CASE("mapping/rigid_motion.hpp") { laws::finite<stateless<moved>>(); }
TEST_CASE("mapping/forward_kinematics.hpp") { laws::finite<stateless<forward>>(); }
TEST_CASE("mapping/inverse_kinematics.hpp") {
  laws::stays_finite<search>(2);  // hundreds of steps for each target out of reach
  // An unreadable target gives the last angles.
  inverse ik;
  const cca::in<"position", foot_in_trunk> there(Eigen::Vector3d(0.3, 0.1, 0.2), 0, true),
      broken(Eigen::Vector3d(0.3, std::nan(""), 0.2), 0, true);
  const auto before = std::get<0>(ik.process(there, {})).vector();
  for (int k = 0; k < 100; ++k) {
    const auto [angles, status] = ik.process(broken, {});
    CHECK(angles.vector() == before);
    CHECK(status.vector()[0] == cca::status_of(cca::reaching::unreadable));
  }
}
TEST_CASE("mapping/adaptive_mapping.hpp") {
  // A hyperbolic tangent answers infinity with 1; the mapping with NaN, as for NaN.
  cca::adaptive_mapping<learned_space, learned_space, machine, 50> learns;
  std::vector<cca::example<machine::model>> examples;
  for (int i = 0; i < 100; ++i) examples.push_back({{0.1 * i, std::sin(i)}, {std::cos(i), 0.2 * i}});
  learns.learning.collect();
  learns.learning.rest();
  learns.learning.hand_over(machine::batch(examples, {}));
  learns.p.settings.margin = cca::infinity;  // every input that is a number counts as trained
  for (const double x : {0.5, std::nan(""), cca::infinity, -cca::infinity}) {
    CAPTURE(x);
    const auto [output, module] =
        learns.process(cca::in<"input", learned_space>(Eigen::Vector2d(x, 0.1), 0, true), {}, {});
    CHECK(output.vector().array().isNaN().all() == !std::isfinite(x));
    CHECK(module.vector()[1] ==
          cca::status_of(std::isfinite(x) ? cca::trained_region::inside : cca::trained_region::outside));
  }
  laws::finite<learned<cca::adaptive_mapping<learned_space, learned_space, machine, 50>>>();
  laws::finite<learned<cca::adaptive_transformation<learned_space, machine, 50>>>();
  laws::finite<learned<cca::adaptive_mapping<learned_space, learned_space, fitted, 50>>>();
}
