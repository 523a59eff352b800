// What cca-urdf writes of files that are not as they should be: it compiles, and has what they mean.
#include <cmath>
#include <type_traits>

#include <Eigen/Geometry>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robots/ports.hpp>

#include <written/bare.hpp>
#include <written/gripper.hpp>
#include <written/gripper_in_parts.hpp>

namespace {

using cca::body_pose;

struct angles_of_bare : cca::space<cca::joint_angles, cca::axes_of<bare::whole_body>, cca::rate<1000>> {};
struct tool_in_base
    : cca::space<cca::cartesian_position<bare::frame::base>, cca::axes<cca::x, cca::z>, cca::rate<1000>> {};

// Asked of a type, so that an answer can be no.
template <class Axis, class Quantity>
constexpr bool is_limited = cca::detail::axis_has_limits<Axis, Quantity>;

}  // namespace

TEST_SUITE("written") {
  TEST_CASE("names that are taken, frames on the way, placeholders") {
    namespace r = j1_robot;
    static_assert(std::is_same_v<r::flange_chain::axes, cca::axes<r::axis::M_PI_, r::axis::elbow>>);
    static_assert(std::is_same_v<r::flange_chain::tip_frame, r::frame::flange>);
    static_assert(std::is_same_v<r::EOF_chain::axes, cca::axes<r::axis::M_PI_>>);
    static_assert(!is_limited<r::axis::M_PI_, cca::velocity> && is_limited<r::axis::elbow, cca::velocity>);
    static_assert(std::is_same_v<cca::axes_of<r::whole_body>,
                                 cca::axes<r::axis::M_PI_, r::axis::elbow, r::axis::grip, r::axis::errno_>>);
    // A wheel without limits has no motor, but it can be in a command.
    CHECK(r::description::drives[3].motor.torque == 0);
    using torques = cca::robots::torques<r::description>;
    CHECK(cca::limiter<torques>()
              .process({Eigen::Vector4d::Ones(), 0, true}, {}, cca::beat(0, 1, 1))
              .vector()[3] == 0);
    REQUIRE(r::description::shapes.size() == 1);
    CHECK(r::description::shapes[0].form.kind == cca::robots::shape_kind::sphere);
  }

  TEST_CASE("the flange is where the joints before it put it") {
    const double turn = 0.3, bend = -0.4;
    const auto flange = cca::chain_pose<j1_robot::flange_chain>(Eigen::Vector2d(turn, bend)).tip();
    const Eigen::Vector3d out(0.3 * std::cos(bend), 0, 0.2 - 0.3 * std::sin(bend));
    const Eigen::Vector3d at = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * out;
    CHECK((flange.at - at).norm() < 1e-12);
    // Where a part ends there, the body has it too, and the gripper does not move it.
    using parts = body_pose<gripper_in_parts::whole_body>;
    for (const double grip : {0.0, -1.0}) {
      const parts now(parts::vector_type(turn, bend, grip, 2));
      CHECK((now.tip<"flange">().at - flange.at).norm() < 1e-12);
      CHECK((now.tip<"flange">().turn - flange.turn).norm() < 1e-12);
      CHECK(now.jacobian<"flange">().col(2).isZero(0));
      // The jaw is the same in both.
      const body_pose<j1_robot::whole_body> whole(parts::vector_type(turn, bend, grip, 2));
      CHECK((now.tip<"jaw">().at - whole.tip<"jaw">().at).norm() < 1e-12);
      CHECK((now.tip<"jaw">().turn - whole.tip<"jaw">().turn).norm() < 1e-12);
    }
  }

  TEST_CASE("a robot without masses has kinematics and ports") {
    static_assert(cca::robots::check_without_masses<bare::description>());
    using pose = body_pose<bare::whole_body>;
    cca::inverse_kinematics<bare::tool_chain, angles_of_bare, tool_in_base> ik;
    const pose wanted(Eigen::Vector2d(0.5, 0.7));
    const Eigen::Vector3d target = wanted.tip<"tool">().at;
    pose::vector_type found = pose::vector_type::Zero();
    for (int i = 0; i < 10; ++i) {
      const cca::in<"position", tool_in_base> to(Eigen::Vector2d(target[0], target[2]), 0, true);
      found = std::get<0>(ik.process(to, {})).vector();
    }
    CHECK((pose(found).tip<"tool">().at - target).norm() < 1e-6);
    CHECK(cca::robots::angles<bare::description>::size == 2);
    CHECK(bare::description::start[1] == doctest::Approx(1.05));
  }
}
