// The example of docs/body.md.
#include <string_view>

#include <doctest/doctest.h>

#include <cca/robot/dynamics/floating_derivatives.hpp>

#include "../picture.hpp"

// [body]
#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>

namespace walker {

// Frames: each chain begins in one and ends in another.
struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct finger : cca::frame<"finger"> {};
struct head : cca::frame<"head"> {};

template <cca::fixed_string Name>
struct joint : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::torque{-5, 5}};
};
struct shoulder : joint<"shoulder"> {};
struct elbow : joint<"elbow"> {};
struct grip : joint<"grip"> {};
struct neck : joint<"neck"> {};

// Chains with the inertia of their links: mass, its centre, the inertia about the centre.
struct arm_chain : cca::serial_chain<trunk, hand, cca::axes<shoulder, elbow>> {
  static constexpr std::array joints{cca::revolute(cca::along_y, cca::at(0.1, 0.05, 0)),
                                     cca::revolute(cca::along_y, cca::at(0.2, 0, 0))};
  static constexpr auto tip = cca::at(0.15, 0, 0);
  static constexpr std::array links{cca::link_inertia{0.4, {0.1, 0, 0}, {1e-4, 1e-3, 1e-3, 0, 0, 0}},
                                    cca::link_inertia{0.3, {0.07, 0, 0}, {1e-4, 8e-4, 8e-4, 0, 0, 0}}};
};
struct finger_chain : cca::serial_chain<hand, finger, cca::axes<grip>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0.03, 0, 0);
};
struct neck_chain : cca::serial_chain<trunk, head, cca::axes<neck>> {
  static constexpr std::array joints{cca::revolute(cca::along_z, cca::at(0.15, 0, 0.05))};
  static constexpr auto tip = cca::at(0.05, 0, 0.03);
};

// The finger is attached to the arm, where its chain begins; arm and head are attached to the trunk.
struct body : cca::body<trunk,
                        cca::part<"arm", arm_chain, cca::driven_by<"arm">>,  //
                        cca::part<"finger", finger_chain>,                   //
                        cca::part<"head", neck_chain>> {
  static constexpr cca::link_inertia base{2.0, {0, 0, 0.02}, {4e-3, 2e-2, 2e-2, 0, 0, 0}};
};

struct angles : cca::space<cca::joint_angles, cca::axes<shoulder, elbow, grip, neck>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow, grip, neck>> {};
struct hand_place : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

// The resource node that moves the arm, and a graph that lets it float.
struct motors {
  Eigen::Vector4d q{0.3, -0.5, 0, 0}, last = Eigen::Vector4d::Zero();
  auto sense() -> cca::out<"angles", angles> { return q; }
  void act(cca::in<"torques", torques> command) { last = command.vector(); }
};
struct floating : cca::graph<cca::rate<1000>,
                             cca::node<"arm", motors>,  //
                             cca::node<"gravity", cca::gravity_compensation<body, angles, torques>>,
                             cca::node<"limits", cca::limiter<torques>>,  //
                             cca::wire<"arm.angles", "gravity.angles">,
                             cca::wire<"gravity.torques", "limits.command">,  //
                             cca::wire<"limits.safe", "arm.torques">> {};
static_assert(cca::embodied<body, floating>);

}  // namespace walker
// [body end]

namespace walker {
struct arm : cca::body<trunk, cca::part<"arm", arm_chain>> {
  static constexpr cca::link_inertia base = walker::body::base;
};
}  // namespace walker

TEST_SUITE("body, example") {
  TEST_CASE("an arm floats") {
    cca::controller<walker::floating> c;
    c.load();
    c.start();
    CHECK(c.step());
    // Computed by hand: the upper arm turns about y, down is positive.
    const double first = 0.3, second = 0.3 - 0.5, g = 9.81;
    const double elbow = -0.3 * g * 0.07 * std::cos(second);
    const double shoulder = elbow - g * std::cos(first) * (0.4 * 0.1 + 0.3 * 0.2);
    const auto& torques = c.get<"arm">().last;
    CHECK(torques[0] == doctest::Approx(shoulder));
    CHECK(torques[1] == doctest::Approx(elbow));
    CHECK(torques[2] == 0);
    CHECK(torques[3] == 0);
  }

  TEST_CASE("the positions of its parts") {
    // [places]
    const cca::body_pose<walker::body> now(
        Eigen::Vector4d(0, 0, 0, cca::pi / 2));  // over axes_of<walker::body>
    CHECK((now.tip<"finger">().at - Eigen::Vector3d(0.1 + 0.2 + 0.15 + 0.03, 0.05, 0)).norm() < 1e-15);
    CHECK((now.tip<"head">().at - Eigen::Vector3d(0.15, 0.05, 0.05 + 0.03)).norm() < 1e-15);
    const Eigen::Matrix<double, 6, 1> velocity =
        now.jacobian<"finger">() * Eigen::Vector4d(1, 0, 0, 0);  // the shoulder moves it downward
    CHECK(velocity[5] == doctest::Approx(-0.38));
    // [places end]
  }

  TEST_CASE("a motion beside another one") {
    const Eigen::Vector4d q(0.3, -0.5, 0, 0), dq(0.1, 0.2, 0, 0), torques(-1, -0.2, 0, 0);
    // [derivatives]
    const cca::body_pose<walker::arm> now(q.head<2>());
    const auto d = cca::forward_dynamics_derivatives(now, dq.head<2>(), torques.head<2>());
    // The motion nearby: d/dt (q, dq) = A (q, dq) + B torques, around this state.
    Eigen::Matrix4d a;
    a << Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Identity(), d.by_angles, d.by_velocities;
    Eigen::Matrix<double, 4, 2> b;
    b << Eigen::Matrix2d::Zero(), d.by_torques;
    // [derivatives end]
    const Eigen::Vector2d step(1e-5, -2e-5);
    const Eigen::Vector2d there = cca::forward_dynamics(cca::body_pose<walker::arm>(q.head<2>() + step),
                                                        dq.head<2>(), torques.head<2>());
    CHECK((there - d.accelerations - (a * Eigen::Vector4d(step[0], step[1], 0, 0)).tail<2>()).norm() < 1e-6);
    const Eigen::Vector2d pushed =
        cca::forward_dynamics(now, dq.head<2>(), Eigen::Vector2d(torques.head<2>() + step));
    CHECK((pushed - d.accelerations - (b * step).tail<2>()).norm() < 1e-8);
  }

  TEST_CASE("a motion beside that of a free base") {
    const Eigen::Vector2d q(0.3, -0.5), dq(0.1, 0.2), torques(-0.1, -0.02), bent(1e-5, -1e-5);
    cca::base_motion base;
    base.angular_velocity = {0.2, -0.4, 0.1};
    const Eigen::Vector3d turn(1e-5, -2e-5, 1e-5), faster(2e-5, 1e-5, 0);
    // [floating derivatives]
    const cca::body_pose<walker::arm> now(q);
    const auto d = cca::floating_forward_dynamics_derivatives(now, dq, torques, base);
    // How all accelerations change if the base is turned and turns faster, and the joints are bent.
    const Eigen::Matrix<double, 8, 1> change =
        d.by_orientation * turn + d.by_angular_velocity * faster + d.by_angles * bent;
    // [floating derivatives end]
    cca::base_motion other = base;
    other.gravity += base.gravity.cross(turn);
    other.angular_velocity += faster;
    const auto there =
        cca::floating_forward_dynamics(cca::body_pose<walker::arm>(q + bent), dq, torques, other);
    Eigen::Matrix<double, 8, 1> found;
    found << there.base.angular_acceleration - d.base.angular_acceleration,
        there.base.acceleration - d.base.acceleration, there.accelerations - d.accelerations;
    CHECK((found - change).norm() < 1e-6);
    CHECK(change.norm() > 1e-4);
  }
}

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0[("arm<br/><i>1000 Hz</i>")]
  n1["gravity<br/><i>1000 Hz</i>"]
  n2["limits<br/><i>1000 Hz</i>"]
  n2 -- "safe → torques<br/>torques, 1000 Hz" --> n0
  n0 -- "angles<br/>angles, 1000 Hz" --> n1
  n1 -- "torques → command<br/>torques, 1000 Hz" --> n2
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of an arm that carries its own weight is the one on its page") {
  test::check_picture<walker::floating>(picture);
}
