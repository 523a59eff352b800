// Ports over groups of joints, the sensors of feet, and servos that hold: on the Oncilla as it was built
// (cca/robots/oncilla/as_built.hpp), which cca::sim::oncilla and cca::hardware::oncilla are made of.
#include <array>
#include <cmath>
#include <cstddef>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/robot.hpp>

#include "described_oncilla.hpp"

using namespace described_oncilla_test;

namespace {

using built = oncilla::as_built;

// Stands, with stiffer hips, and moves its legs aside once it is told.
struct orders {
  auto process(cca::beat) -> std::tuple<cca::out<"command", oncilla::leg_angles>,
                                        cca::maybe<"abduction", oncilla::abduction_angles>,
                                        cca::maybe<"stiffness", oncilla::hip_stiffnesses>> {
    oncilla::leg_angles::vector_type legs;
    legs << Eigen::Vector4d::Constant(0.75), Eigen::Vector4d::Constant(1.4);
    cca::maybe<"abduction", oncilla::abduction_angles> abduction;
    cca::maybe<"stiffness", oncilla::hip_stiffnesses> stiffness;
    if (aside) abduction = Eigen::Vector4d(0.1, 0.1, 0.05, -0.05), stiffness = Eigen::Vector4d::Constant(120);
    return {legs, abduction, stiffness};
  }
  bool aside = false;
};

struct listener {
  void process(cca::in<"angles", oncilla::leg_angles> q,
               cca::in<"velocities", oncilla::leg_velocities> v,
               cca::in<"torques", oncilla::leg_torques> t,
               cca::in<"orientation", oncilla::trunk_orientation> o,
               cca::in<"angular_velocity", oncilla::trunk_angular_velocity> w,
               cca::in<"acceleration", oncilla::trunk_acceleration> a,
               cca::in<"contacts", oncilla::foot_contacts> c,
               cca::in<"foot_loads", oncilla::foot_loads> f,
               cca::in<"abducted", oncilla::abduction_angles> b) {
    angles = q.vector(), velocities = v.vector(), torques = t.vector();
    orientation = o.vector(), contacts = c.vector(), loads = f.vector(), abducted = b.vector();
    angular_velocity = w.vector(), acceleration = a.vector();
  }
  Eigen::Matrix<double, 8, 1> angles, velocities, torques;
  Eigen::Vector4d orientation, contacts, loads, abducted;
  Eigen::Vector3d angular_velocity, acceleration;
};

struct standing : cca::graph<cca::node<"orders", orders>,
                             cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                             cca::node<"abduction_limits", cca::limiter<oncilla::abduction_angles>>,
                             cca::node<"stiffness_limits", cca::limiter<oncilla::hip_stiffnesses>>,
                             cca::node<"robot", sim::robot<built>>,
                             cca::node<"listener", listener>,
                             cca::wire<"orders.command", "limits.command">,
                             cca::wire<"limits.safe", "robot.command">,
                             cca::wire<"orders.abduction", "abduction_limits.command">,
                             cca::wire<"abduction_limits.safe", "robot.abduction">,
                             cca::wire<"orders.stiffness", "stiffness_limits.command">,
                             cca::wire<"stiffness_limits.safe", "robot.stiffness">,
                             cca::wire<"robot.angles", "listener.angles">,
                             cca::wire<"robot.velocities", "listener.velocities">,
                             cca::wire<"robot.torques", "listener.torques">,
                             cca::wire<"robot.orientation", "listener.orientation">,
                             cca::wire<"robot.angular_velocity", "listener.angular_velocity">,
                             cca::wire<"robot.acceleration", "listener.acceleration">,
                             cca::wire<"robot.contacts", "listener.contacts">,
                             cca::wire<"robot.foot_loads", "listener.foot_loads">,
                             cca::wire<"robot.abducted", "listener.abducted">> {};

constexpr std::size_t hip_of(std::size_t leg) { return 4 * leg + 1; }

template <class Controller>
auto& put_on(Controller& c, const sim::terrain& ground, const sim::disturbance& d) {
  auto& simulator = c.template get<"robot.simulator">();
  simulator.put_down(put_down<built>(trot::put_down(trot::gait().p, d), on(ground.with_friction(d.friction))),
                     d);
  return simulator;
}

}  // namespace

TEST_SUITE("groups of joints") {
  TEST_CASE("every sensor and every joint arrives at its port, a beat after the world made it") {
    cca::controller<standing> c;
    c.load();
    const sim::robot_world& w = put_on(c, sim::terrain::flat(), sim::disturbance::none()).world();
    c.start();
    double load = 0;
    for (int k = 0; k < 2990; ++k) REQUIRE(c.step());
    for (int k = 0; k < 10; ++k) {
      const sim::robot_world before = w;
      REQUIRE(c.step());
      const listener& heard = c.get<"listener">();
      for (std::size_t leg = 0; leg < 4; ++leg) {
        const auto i = static_cast<Eigen::Index>(leg);
        const auto &hip = before.joints()[hip_of(leg)], &knee = before.joints()[hip_of(leg) + 1];
        REQUIRE(heard.angles[i] == hip.angle);
        REQUIRE(heard.angles[4 + i] == knee.angle);
        REQUIRE(heard.velocities[i] == hip.velocity);
        REQUIRE(heard.torques[4 + i] == knee.torque);
        REQUIRE(heard.abducted[i] == before.joints()[hip_of(leg) - 1].angle);
        REQUIRE(heard.loads[i] == before.force_on_end(leg)[2]);
        REQUIRE(heard.contacts[i] == 1);
        load += heard.loads[i] / 10;
      }
      REQUIRE(heard.orientation[3] == before.inertial(0).orientation[3]);
      REQUIRE(heard.angular_velocity[1] == before.inertial(0).angular_velocity[1]);
      REQUIRE(heard.acceleration[2] == before.inertial(0).specific_force[2]);
    }
    CHECK(load == doctest::Approx(w.mass() * 9.81).epsilon(0.05));
  }

  TEST_CASE("in the air no foot touches") {
    cca::controller<standing> c;
    c.load();
    c.get<"robot.simulator">().put_down(put_down<built>(sim::standing_posture(), {}));
    c.start();
    for (int k = 0; k < 50; ++k) REQUIRE(c.step());
    CHECK(c.get<"listener">().contacts == Eigen::Vector4d::Zero());
    CHECK(c.get<"listener">().loads == Eigen::Vector4d::Zero());
  }

  TEST_CASE("servos hold until a first command, then follow - a stiffness is for its group alone") {
    cca::controller<standing> c;
    c.load();
    sim::initial_posture posture = sim::standing_posture();
    for (auto& leg : posture.legs) leg.abduction = 0.06;
    c.get<"robot.simulator">().put_down(put_down<built>(posture, on(sim::terrain::flat())));
    c.start();
    for (int k = 0; k < 1500; ++k) REQUIRE(c.step());
    const sim::robot_world& w = c.get<"robot.simulator">().world();
    for (std::size_t leg = 0; leg < 4; ++leg) {
      CHECK(w.joints()[hip_of(leg) - 1].angle == doctest::Approx(0.06).epsilon(0.3));
      CHECK(w.save().laws[hip_of(leg)].stiffness == 30);
    }
    c.get<"orders">().aside = true;
    for (int k = 0; k < 1500; ++k) REQUIRE(c.step());
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const auto laws = w.save().laws;
      const double wanted = leg < 2 ? 0.1 : leg == 2 ? 0.05 : -0.05;
      CHECK(laws[hip_of(leg) - 1].position == wanted);
      CHECK(std::abs(w.joints()[hip_of(leg) - 1].angle - wanted) < 0.03);
      CHECK(laws[hip_of(leg)].stiffness == 120);
      CHECK(laws[hip_of(leg)].damping == doctest::Approx(1.5));  // scaled with it
      CHECK(laws[hip_of(leg) + 1].stiffness == 80);              // the cable's
      CHECK(laws[hip_of(leg) - 1].stiffness == 80);
    }
  }
}
