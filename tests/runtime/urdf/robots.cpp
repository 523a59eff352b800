// Three public robots, from their URDF files: what cca-urdf writes compiles, and accelerates as KDL says of
// the same file and as the simulator does.
#include <array>
#include <string>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/sim/robot.hpp>

#include <written/crooked.hpp>
#include <written/panda.hpp>
#include <written/solo12.hpp>
#include <written/ur5e.hpp>

#include "../any_robot/accelerations.hpp"
#include "kdl_of_urdf.hpp"

namespace sim = cca::sim;
using namespace world_test;

namespace {

constexpr double agreed = 1e-6;  // relative

std::string file_of(const char* robot) { return std::string(CCA_URDF) + "/" + robot + ".urdf"; }

template <class Axes>
struct names;
template <class... Axes>
struct names<cca::axes<Axes...>> {
  static std::vector<std::string> all() { return {std::string(Axes::name)...}; }
};

// Torques of KDL for random accelerations, and what they give in the library and in the world.
template <class R>
void agrees_with_kdl(const char* file, unsigned seed, double speed) {
  using body = typename R::body;
  using pose = cca::body_pose<body>;
  constexpr int n = pose::size;
  const urdf_test::kdl_robot theirs(file_of(file));
  const auto axes = names<cca::axes_of<body>>::all();
  REQUIRE(theirs.joints() == axes.size());
  sim::robot_model model = without_losses(sim::model_of<R>());
  model.floats = false;
  laws::source random{std::mt19937_64{seed}};
  double worst = 0, worst_in_world = 0;
  for (int round = 0; round < 50; ++round) {
    const vector q = random_vector(random, n, 2), dq = random_vector(random, n, speed),
                 ddq = random_vector(random, n, 10);
    const motion s{q, dq, theirs.torques(axes, q, dq, ddq), {}};
    const typename pose::vector_type ours =
        cca::forward_dynamics(pose(q), typename pose::vector_type(dq), typename pose::vector_type(s.torques));
    worst = std::max(worst, error(ours, ddq));
    worst_in_world = std::max(worst_in_world, error(accelerations(model, s).head<n>(), ddq));
  }
  MESSAGE(std::string(file), ": largest relative error against KDL: ", worst,
          ", in the world: ", worst_in_world);
  CHECK(worst < agreed);
  CHECK(worst_in_world < agreed);
}

// [extended]
struct my_panda : panda::description {
  using commands = cca::robots::commands<cca::robots::position_command>;
  using sensors = cca::robots::sensors<cca::robots::force_sensor<"flange_load", "panda_link8">>;
  static constexpr auto drives = [] {
    auto all = panda::description::drives;
    for (auto& drive : all) drive.stiffness = 600, drive.damping = 50;
    return all;
  }();
};
// [extended end]

// [held]
// The robot holds itself by the torques of gravity. R: panda::description, for example.
template <class R>
struct held
    : cca::graph<
          cca::node<
              "gravity",
              cca::gravity_compensation<typename R::body, cca::robots::angles<R>, cca::robots::torques<R>>>,
          cca::node<"limits", cca::limiter<cca::robots::torques<R>>>,
          cca::node<"robot", sim::robot<R>>,
          cca::wire<"robot.angles", "gravity.angles">,
          cca::wire<"gravity.torques", "limits.command">,
          cca::wire<"limits.safe", "robot.torque">> {};
// [held end]

template <class R>
double drift(double seconds) {
  cca::controller<held<R>> c;
  c.load();
  c.start();
  const auto before = c.template get<"robot.simulator">().world().joints();
  for (int i = 0; i < seconds * 1000; ++i) c.step();
  double most = 0;
  const auto& after = c.template get<"robot.simulator">().world().joints();
  for (std::size_t i = 0; i < before.size(); ++i)
    most = std::max(most, std::abs(after[i].angle - before[i].angle));
  return most;
}

}  // namespace

TEST_SUITE("robots") {
  TEST_CASE("the Panda accelerates as KDL says") { agrees_with_kdl<panda::description>("panda", 1, 2); }
  TEST_CASE("the UR5e accelerates as KDL says") { agrees_with_kdl<ur5e::description>("ur5e", 2, 2); }
  TEST_CASE("Solo12 on a stand accelerates as KDL says") {
    agrees_with_kdl<solo12::description>("solo12", 3, 2);
  }

  TEST_CASE("a robot that is nowhere straight, with joints that follow others, accelerates as KDL says") {
    agrees_with_kdl<crooked::description>("crooked", 6, 1);
    const sim::robot_model model = sim::model_of<crooked::description>();
    REQUIRE(model.drives.size() == 3);
    CHECK(model.drives[0].friction == 0.25);
    CHECK(model.drives[2].friction == doctest::Approx(1 + 0.5 * 0.5 * 0.5));
  }

  TEST_CASE("Solo12 in the air accelerates as its dynamics say") {
    using pose = cca::body_pose<solo12::description::body>;
    constexpr int n = pose::size;
    const sim::robot_model model = without_losses(sim::model_of<solo12::description>());
    REQUIRE(model.floats);
    laws::source random{std::mt19937_64{4}};
    double worst = 0;
    for (int round = 0; round < 50; ++round) {
      const motion s{random_vector(random, n, 2), random_vector(random, n, 2), random_vector(random, n, 0.02),
                     random_base(random)};
      const Eigen::Matrix3d& turn = s.base.where.turn;
      cca::base_motion base;
      base.gravity = turn.transpose() * base.gravity;
      base.angular_velocity = turn.transpose() * s.base.angular_velocity;
      const pose::vector_type q = s.q, dq = s.dq, torques = s.torques;
      const auto found = cca::floating_forward_dynamics(pose(q), dq, torques, base);
      vector wanted(n + 6);
      wanted << found.accelerations, turn * found.base.angular_acceleration, turn * found.base.acceleration;
      worst = std::max(worst, error(accelerations(model, s), wanted));
    }
    MESSAGE("largest relative error: ", worst);
    CHECK(worst < agreed);
  }

  TEST_CASE("the Panda of the file is the arm of the library") {
    laws::source random{std::mt19937_64{5}};
    using theirs = cca::body_pose<panda::description::body>;
    using ours = cca::body_pose<cca::robots::arm::body>;
    for (int round = 0; round < 20; ++round) {
      const ours::vector_type q = random_vector(random, 7, 2), dq = random_vector(random, 7, 2),
                              ddq = random_vector(random, 7, 5);
      const theirs a(q);
      const ours b(q);
      CHECK((a.tip<"panda_link8">().at - b.tip<"arm">().at).norm() < 1e-14);
      CHECK((a.tip<"panda_link8">().turn - b.tip<"arm">().turn).norm() < 1e-14);
      CHECK((cca::inverse_dynamics(a, dq, ddq).torques - cca::inverse_dynamics(b, dq, ddq).torques).norm() <
            1e-11);
    }
    const sim::robot_model a = sim::model_of<panda::description>(),
                           b = sim::model_of<cca::robots::arm::description>();
    for (std::size_t i = 0; i < 7; ++i) {
      CHECK(a.stops[i].low == b.stops[i].low);
      CHECK(a.stops[i].high == b.stops[i].high);
      CHECK(a.drives[i].motor.torque == b.drives[i].motor.torque);
      CHECK(a.drives[i].motor.no_load_speed == b.drives[i].motor.no_load_speed);
    }
    CHECK(a.start[3] == doctest::Approx(-(3.0718 + 0.0698) / 2));
  }

  TEST_CASE("frames, parts and shapes of the files") {
    const cca::body_pose<ur5e::description::body> arm(Eigen::Matrix<double, 6, 1>::Zero());
    // The maker's lengths, with the arm stretched out: a2 + a3, d4 + d6, d1 - d5.
    CHECK((arm.tip<"tool0">().at - Eigen::Vector3d(0.425 + 0.3922, 0.1333 + 0.0996, 0.1625 - 0.0997)).norm() <
          1e-9);
    CHECK(arm.tip<"ft_frame">().turn(2, 2) == doctest::Approx(-arm.tip<"wrist_3_link">().turn(2, 2)));
    CHECK(arm.tip<"base">().turn(0, 0) == doctest::Approx(-1));
    const sim::robot_model model = sim::model_of<ur5e::description>();
    REQUIRE(model.shapes.size() == 1);
    CHECK(model.shapes[0].link == 1);
    CHECK(model.shapes[0].form.size[0] == 0.06);
    CHECK(model.shapes[0].form.size[1] == doctest::Approx(0.5 - 2 * 0.06));

    const cca::body_pose<solo12::description::body> dog(Eigen::Matrix<double, 12, 1>::Zero());
    CHECK((dog.tip<"HR_FOOT">().at - Eigen::Vector3d(-0.19, -0.1046 - 0.03745 - 0.008, -0.32)).norm() <
          1e-15);
    const sim::robot_model legs = sim::model_of<solo12::description>();
    REQUIRE(legs.shapes.size() == 4);
    CHECK(legs.shapes[3].link == 11);
    CHECK(legs.base.mass == 1.63315091);
    CHECK(legs.links[2].inertia.mass == doctest::Approx(0.03070001 + 0.00693606));
  }

  TEST_CASE("a written description is a robot of the simulator") {
    const sim::robot_model extended = sim::model_of<my_panda>();
    CHECK(extended.drives[6].stiffness == 600);
    CHECK(extended.drives[6].motor.torque == 12);
    CHECK(extended.sensors.size() == 1);
    static_assert(cca::well_formed<held<panda::description>>);
    CHECK(drift<panda::description>(0.5) < 1e-3);
    CHECK(drift<ur5e::description>(0.5) < 1e-3);
  }
}
