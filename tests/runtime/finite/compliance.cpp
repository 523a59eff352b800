// The components of robot/compliance/ under the laws of finite numbers.
#include <cca/robot/compliance/admittance.hpp>
#include <cca/robot/compliance/cartesian_impedance.hpp>
#include <cca/robot/compliance/contact_reaction.hpp>
#include <cca/robot/compliance/hybrid_control.hpp>
#include <cca/robot/compliance/joint_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>

#include "../../laws/finite_laws.hpp"
#include "../body/bodies.hpp"

namespace {

using namespace body_test;

struct angles : cca::space<cca::joint_angles, arm_axes> {};
struct velocities : cca::space<cca::joint_velocities, arm_axes> {};
struct torques : cca::space<cca::joint_torques, arm_axes> {};

using impedance = cca::joint_impedance<arm, angles, velocities, torques>;
using admittance = cca::admittance<arm_base, flange>;

// The tank of the posture, and the account of the guard: small, so that what a gap cost is soon filled again.
struct cartesian : laws::finite_case<cca::cartesian_impedance<arm, "arm", angles, velocities, torques>> {
  static constexpr int settles_in = 1000;
  static auto made() {
    auto c = std::make_unique<component>();
    c->p.posture_energy = 0.01;
    c->p.posture_damping = 0;
    return c;
  }
};
struct guarded : laws::finite_case<cca::passivity_guard<arm, angles, velocities, torques>> {
  static constexpr int settles_in = 1000;
  static auto made() {
    auto c = std::make_unique<component>();
    c->p.energy = c->p.most = 0.01;
    c->p.braking = 0;
    return c;
  }
};
struct hybrid : laws::finite_case<cca::hybrid_control<arm, "arm", angles, velocities, torques>> {};

}  // namespace

TEST_CASE("robot/compliance/joint_impedance.hpp") { laws::finite<laws::finite_case<impedance>>(); }
TEST_CASE("robot/compliance/cartesian_impedance.hpp") { laws::finite<cartesian>(); }
TEST_CASE("robot/compliance/passivity_guard.hpp") { laws::finite<guarded>(); }
TEST_CASE("robot/compliance/contact_reaction.hpp") {
  laws::finite<laws::finite_case<cca::contact_reaction<arm, angles, velocities, torques>>>();
}
TEST_CASE("robot/compliance/admittance.hpp") { laws::finite<laws::finite_case<admittance>>(); }
TEST_CASE("robot/compliance/hybrid_control.hpp") { laws::finite<hybrid>(); }
