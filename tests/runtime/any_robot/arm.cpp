// The arm as a node of graphs: held and moved by torques, and by its drives.
#include <limits>
#include <optional>

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robots/arm/description.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/robot.hpp>

namespace arm = cca::robots::arm;
namespace sim = cca::sim;

namespace {

using vector = arm::angles::vector_type;
using simulated_arm = sim::robot<arm::description>;

// [held]
// The torques of gravity hold the arm where it is.
struct held
    : cca::graph<cca::node<"gravity", cca::gravity_compensation<arm::body, arm::angles, arm::torques>>,
                 cca::node<"limits", cca::limiter<arm::torques>>,
                 cca::node<"robot", cca::sim::robot<arm::description>>,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::wire<"gravity.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torque">> {};
// [held end]

static_assert(cca::well_formed<held>);
static_assert(cca::embodied<arm::body, simulated_arm>);

struct accelerations : cca::space<cca::joint_accelerations, arm::joint_axes, arm::description::rate> {};

// [moved]
// A movement of two seconds. Where the arm lags behind, it is accelerated towards the movement.
struct movement {
  vector from = vector::Map(arm::description::start.data());
  vector by = vector(0.4, 0.3, -0.3, 0.5, 0.4, -0.3, 0.5);

  auto process(cca::in<"angles", arm::angles> q, cca::in<"velocities", arm::velocities> dq, cca::beat now)
      -> cca::out<"accelerations", accelerations> {
    const double s = std::min(0.5e-9 * static_cast<double>(now.time()), 1.0);  // minimum jerk
    const double at = s * s * s * (10 + s * (6 * s - 15)), speed = s * s * (30 + s * (30 * s - 60)) / 2,
                 change = s * (60 + s * (120 * s - 180)) / 4;
    return (by * change + 60 * (by * speed - dq.vector()) + 900 * (from + by * at - q.vector())).eval();
  }
};

struct moved
    : cca::graph<
          cca::node<"movement", movement, cca::timed<1>>,
          cca::node<
              "dynamics",
              cca::inverse_dynamics_of<arm::body, arm::angles, arm::velocities, accelerations, arm::torques>>,
          cca::node<"limits", cca::limiter<arm::torques>>,
          cca::node<"robot", cca::sim::robot<arm::description>>,
          cca::wire<"robot.angles", "movement.angles">,
          cca::wire<"robot.velocities", "movement.velocities">,
          cca::wire<"robot.angles", "dynamics.angles">,
          cca::wire<"robot.velocities", "dynamics.velocities">,
          cca::wire<"movement.accelerations", "dynamics.accelerations">,
          cca::wire<"dynamics.torques", "limits.command">,
          cca::wire<"limits.safe", "robot.torque">> {};
// [moved end]

static_assert(cca::well_formed<moved>);

struct reckless
    : cca::graph<cca::node<"gravity", cca::gravity_compensation<arm::body, arm::angles, arm::torques>>,
                 cca::node<"robot", simulated_arm>,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::wire<"gravity.torques", "robot.torque">> {};
static_assert(cca::diagnosis<reckless>.rule == "robot.unlimited_command");

// Commands of one kind: none until there is a value.
template <class Command>
struct source {
  using space = cca::robots::commanded<arm::description, Command>;
  std::optional<vector> value;
  auto process(cca::beat) -> cca::maybe<"value", space> {
    if (value) return *value;
    return {};
  }
};
template <class Command>
using limits = cca::limiter<cca::robots::commanded<arm::description, Command>>;

struct operator_stop {
  bool pressed = false;
  auto process(cca::beat) -> cca::fault { return pressed ? cca::fault("stop") : cca::fault(); }
};

// All commands of the arm, of which each test uses some.
struct driven : cca::graph<cca::rate<1000>,
                           cca::node<"stop", operator_stop>,
                           cca::node<"position", source<cca::robots::position_command>>,
                           cca::node<"velocity", source<cca::robots::velocity_command>>,
                           cca::node<"torque", source<cca::robots::torque_command>>,
                           cca::node<"stiffness", source<cca::robots::stiffness_command>>,
                           cca::node<"damping", source<cca::robots::damping_command>>,
                           cca::node<"position_limits", limits<cca::robots::position_command>>,
                           cca::node<"velocity_limits", limits<cca::robots::velocity_command>>,
                           cca::node<"torque_limits", limits<cca::robots::torque_command>>,
                           cca::node<"stiffness_limits", limits<cca::robots::stiffness_command>>,
                           cca::node<"damping_limits", limits<cca::robots::damping_command>>,
                           cca::node<"robot", simulated_arm>,
                           cca::wire<"position.value", "position_limits.command">,
                           cca::wire<"velocity.value", "velocity_limits.command">,
                           cca::wire<"torque.value", "torque_limits.command">,
                           cca::wire<"stiffness.value", "stiffness_limits.command">,
                           cca::wire<"damping.value", "damping_limits.command">,
                           cca::wire<"position_limits.safe", "robot.position">,
                           cca::wire<"velocity_limits.safe", "robot.velocity">,
                           cca::wire<"torque_limits.safe", "robot.torque">,
                           cca::wire<"stiffness_limits.safe", "robot.stiffness">,
                           cca::wire<"damping_limits.safe", "robot.damping">> {};

template <class Graph>
const sim::robot_world& world_of(const cca::controller<Graph>& c) {
  return c.template get<"robot.simulator">().world();
}
template <class Graph>
vector angles_of(const cca::controller<Graph>& c) {
  vector q;
  for (int i = 0; i < 7; ++i) q[i] = world_of(c).joints()[static_cast<std::size_t>(i)].angle;
  return q;
}
template <class Graph>
void started(cca::controller<Graph>& c) {
  c.load();
  c.start();
}
template <class Graph>
void steps(cca::controller<Graph>& c, int count) {
  for (int k = 0; k < count; ++k) REQUIRE(c.step());
}

const vector start = vector::Map(arm::description::start.data());

}  // namespace

TEST_SUITE("arm") {
  TEST_CASE("its published numbers are physically possible, and its flange is where the maker has it") {
    for (const auto& l : arm::chain::links) {
      const Eigen::Vector3d moments =
          cca::detail::matrix_of(l.about_centre).selfadjointView<Eigen::Lower>().eigenvalues();
      CHECK(moments[0] > 0);
      CHECK(moments[0] + moments[1] >= moments[2] * (1 - 1e-3));
    }
    const cca::body_pose<arm::body> zero(vector::Zero());
    CHECK((zero.tip<"arm">().at - Eigen::Vector3d(0.088, 0, 0.333 + 0.316 + 0.384 - 0.107)).norm() < 1e-12);
    CHECK((zero.tip<"arm">().turn.col(2) + Eigen::Vector3d::UnitZ()).norm() < 1e-12);
    CHECK((world_of(cca::controller<driven>()).end(0).where.at -
           cca::body_pose<arm::body>(start).tip<"arm">().at)
              .norm() < 1e-12);
  }

  TEST_CASE("the torques of gravity hold it - without them it falls") {
    cca::controller<held> c;
    started(c);
    steps(c, 5000);
    CHECK((angles_of(c) - start).cwiseAbs().maxCoeff() < 1e-6);

    cca::controller<driven> fallen;  // without a command
    started(fallen);
    steps(fallen, 500);
    CHECK((angles_of(fallen) - start).cwiseAbs().maxCoeff() > 0.2);
  }

  TEST_CASE("torques by inverse dynamics move it along a path") {
    cca::controller<moved> c;
    started(c);
    const movement& m = c.get<"movement">();
    double worst = 0;
    for (int k = 0; k < 2500; ++k) {
      REQUIRE(c.step());
      const double s = std::min((k + 1) * 0.0005, 1.0);
      const vector wanted = m.from + m.by * (s * s * s * (10 + s * (6 * s - 15)));
      worst = std::max(worst, (angles_of(c) - wanted).cwiseAbs().maxCoeff());
    }
    MESSAGE("largest error of an angle: ", worst);
    CHECK(worst < 0.01);  // friction, which the body does not know, and the steps of physics
    CHECK((angles_of(c) - m.from - m.by).cwiseAbs().maxCoeff() < 2e-3);
  }

  TEST_CASE("drives follow positions: up to the load on their springs") {
    cca::controller<driven> c;
    c.get<"position">().value = start + vector::Constant(0.1);
    started(c);
    steps(c, 3000);
    const vector lag = angles_of(c) - *c.get<"position">().value;
    const auto load = cca::gravity_torques(cca::body_pose<arm::body>(angles_of(c)));
    for (int i = 0; i < 7; ++i)
      CHECK(lag[i] * arm::description::drives[static_cast<std::size_t>(i)].stiffness ==
            doctest::Approx(-load[i]).epsilon(1e-3));
  }

  TEST_CASE("a commanded stiffness replaces the servo's, and a torque is added") {
    cca::controller<driven> c;
    c.get<"position">().value = start;
    c.get<"stiffness">().value = vector(2000, 2000, 2000, 2000, 300, 300, 300);
    c.get<"torque">().value = cca::gravity_torques(cca::body_pose<arm::body>(start));
    started(c);
    steps(c, 1000);
    CHECK((angles_of(c) - start).cwiseAbs().maxCoeff() < 1e-6);
    *c.get<"torque">().value += vector(10, 0, 0, 0, 0, 0, 3);
    steps(c, 2000);
    CHECK(angles_of(c)[0] - start[0] == doctest::Approx(10.0 / 2000).epsilon(0.05));
    CHECK(angles_of(c)[6] - start[6] == doctest::Approx(3.0 / 300).epsilon(0.05));
  }

  TEST_CASE("drives move at a commanded speed, and hold at speed 0") {
    cca::controller<driven> c;
    c.get<"velocity">().value = vector::Zero();
    started(c);
    steps(c, 1000);  // speed 0
    const vector before = angles_of(c);
    CHECK((before - start).cwiseAbs().maxCoeff() < 0.1);
    c.get<"velocity">().value = vector(0.2, 0.2, -0.2, 0.2, 0.2, -0.2, 0.2);
    steps(c, 2000);
    CHECK((angles_of(c) - before - 2 * *c.get<"velocity">().value).cwiseAbs().maxCoeff() < 0.05);
  }

  TEST_CASE("commands beyond the limits and commands that are no numbers") {
    cca::controller<driven> c;
    c.get<"torque">().value = vector::Constant(1e6);
    started(c);
    steps(c, 1);
    c.get<"torque">().value = vector::Constant(std::numeric_limits<double>::quiet_NaN());
    for (int k = 0; k < 500; ++k) {
      REQUIRE(c.step());
      for (int i = 0; i < 7; ++i) {
        const double torque = world_of(c).joints()[static_cast<std::size_t>(i)].torque;
        REQUIRE(std::abs(torque) <= arm::description::drives[static_cast<std::size_t>(i)].motor.torque);
      }
    }
    CHECK(angles_of(c).allFinite());
    CHECK(c.get<"torque_limits">().interventions() > 0);
    CHECK(world_of(c).joints()[0].torque == 0);  // 1000 N m/s down from the limit
  }

  TEST_CASE("a commanded damping brakes a falling arm") {
    cca::controller<driven> c;
    c.get<"damping">().value = vector(200, 200, 200, 200, 5, 5, 5);
    started(c);
    cca::controller<driven> fallen;  // without a command
    started(fallen);
    steps(c, 300);
    steps(fallen, 300);
    CHECK((angles_of(c) - start).norm() < 0.2 * (angles_of(fallen) - start).norm());
  }

  TEST_CASE("after a fault the motors damp: no energy is added, and the arm sinks to its stops") {
    cca::controller<driven> c;
    c.get<"torque">().value = vector(5, -20, 0, 15, 0, 0, 0);
    started(c);
    steps(c, 800);
    c.get<"stop">().pressed = true;
    steps(c, 1);  // the beat that the fault ends, before the robot acts
    CHECK(world_of(c).time() == doctest::Approx(0.8));
    double energy = world_of(c).energy();
    REQUIRE(std::isfinite(energy));
    for (int k = 0; k < 5000; ++k) {
      CHECK(!c.step());
      REQUIRE(world_of(c).energy() < energy + 1e-3);
      energy = world_of(c).energy();
    }
    CHECK(world_of(c).time() == doctest::Approx(5.8));
    for (const auto& joint : world_of(c).joints()) CHECK(std::abs(joint.velocity) < 0.2);
  }

  TEST_CASE("a copy is a snapshot: both go on bit for bit") {
    cca::controller<moved> a;
    started(a);
    steps(a, 200);
    cca::controller<moved> b = a;
    steps(a, 300);
    CHECK(world_of(a).hash() != world_of(b).hash());
    steps(b, 300);
    CHECK(world_of(a).hash() == world_of(b).hash());
  }
}
