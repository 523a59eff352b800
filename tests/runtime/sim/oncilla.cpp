// The simulated Oncilla in a graph: the same as the world alone, a snapshot when it is copied, and refused
// without a limiter.
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/sim/oncilla.hpp>

#include "standing.hpp"

namespace {

namespace sim = cca::sim;

// Swings all joints, each in a phase of its own.
struct exercise {
  auto process(cca::beat now) -> cca::out<"command", sim::leg_angles> {
    const sim::robot_command wanted = test::swinging(now.index());
    sim::leg_angles::vector_type v;
    for (int i = 0; i < 4; ++i) {
      v[i] = wanted[static_cast<std::size_t>(i)].hip;
      v[4 + i] = wanted[static_cast<std::size_t>(i)].knee;
    }
    return v;
  }
};

struct exercised : cca::graph<cca::rate<1000>,
                              cca::node<"exercise", exercise>,
                              cca::node<"limits", cca::limiter<sim::leg_angles>>,
                              cca::node<"robot", sim::oncilla>,
                              cca::wire<"exercise.command", "limits.command">,
                              cca::wire<"limits.safe", "robot.command">> {};

// Listens to every sensor that the robot shows.
struct listener {
  void process(cca::in<"angles", sim::leg_angles> q,
               cca::in<"velocities", sim::leg_velocities> v,
               cca::in<"torques", sim::leg_torques> t,
               cca::in<"orientation", sim::trunk_orientation> o,
               cca::in<"angular_velocity", sim::trunk_angular_velocity> w,
               cca::in<"acceleration", sim::trunk_acceleration> a,
               cca::in<"contacts", sim::foot_contacts> c,
               cca::in<"foot_loads", sim::foot_loads> f,
               cca::in<"abducted", sim::abduction_angles> b) {
    angles = q.vector();
    velocities = v.vector();
    torques = t.vector();
    orientation = o.vector();
    angular_velocity = w.vector();
    acceleration = a.vector();
    contacts = c.vector();
    loads = f.vector();
    abducted = b.vector();
  }
  Eigen::Matrix<double, 8, 1> angles, velocities, torques;
  Eigen::Vector4d orientation, contacts, loads, abducted;
  Eigen::Vector3d angular_velocity, acceleration;
};

struct abduct {
  auto process(cca::beat)
      -> std::tuple<cca::out<"angles", sim::abduction_angles>, cca::out<"stiffness", sim::hip_stiffnesses>> {
    return {Eigen::Vector4d(0.1, 0.1, -0.05, 7.0), Eigen::Vector4d(120, 120, 120, 120)};
  }
};

struct listened : cca::graph<cca::rate<1000>,
                             cca::node<"exercise", exercise>,
                             cca::node<"limits", cca::limiter<sim::leg_angles>>,
                             cca::node<"abduct", abduct>,
                             cca::node<"abduction_limits", cca::limiter<sim::abduction_angles>>,
                             cca::node<"stiffness_limits", cca::limiter<sim::hip_stiffnesses>>,
                             cca::node<"robot", sim::oncilla>,
                             cca::node<"listener", listener>,
                             cca::wire<"exercise.command", "limits.command">,
                             cca::wire<"limits.safe", "robot.command">,
                             cca::wire<"abduct.angles", "abduction_limits.command">,
                             cca::wire<"abduction_limits.safe", "robot.abduction">,
                             cca::wire<"abduct.stiffness", "stiffness_limits.command">,
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

struct unlimited : cca::graph<cca::rate<1000>,
                              cca::node<"exercise", exercise>,
                              cca::node<"robot", sim::oncilla>,
                              cca::wire<"exercise.command", "robot.command">> {};

static_assert(cca::well_formed<exercised>);
static_assert(cca::well_formed<listened>);
static_assert(!cca::well_formed<unlimited>);
static_assert(cca::diagnosis<unlimited>.rule == "robot.unlimited_command");

}  // namespace

TEST_SUITE("sim oncilla") {
  TEST_CASE("a copied controller is a snapshot of graph and world: both go on bit for bit") {
    cca::controller<exercised> original;
    original.load();
    original.start();
    original.run(cca::for_beats<700>{});
    cca::controller<exercised> copy = original;
    original.run(cca::for_beats<500>{});
    CHECK(original.get<"robot.simulator">().world().hash() != copy.get<"robot.simulator">().world().hash());
    copy.run(cca::for_beats<500>{});
    CHECK(original.get<"robot.simulator">().world().hash() == copy.get<"robot.simulator">().world().hash());
    CHECK(!copy.get<"robot.simulator">().world().fallen());
  }

  TEST_CASE("the graph does what the bare world does with the same commands") {
    cca::controller<exercised> c;
    c.load();
    c.start();
    sim::world bare = c.get<"robot.simulator">().world();
    for (int k = 0; k < 500; ++k) {
      c.step();
      // The motors follow the commands that passed the limiter.
      const sim::robot_command wanted = c.get<"robot.simulator">().world().targets();
      bare.advance(wanted);
      REQUIRE(bare.hash() == c.get<"robot.simulator">().world().hash());
    }
  }

  TEST_CASE("every sensor arrives, a beat after the world made it") {
    cca::controller<listened> c;
    c.load();
    c.start();
    for (int k = 0; k < 400; ++k) {
      const sim::robot_reading before = c.get<"robot.simulator">().world().reading();
      REQUIRE(c.step());
      const listener& heard = c.get<"listener">();
      for (int i = 0; i < 4; ++i) {
        const sim::leg_reading& leg = before.legs[static_cast<std::size_t>(i)];
        REQUIRE(heard.angles[i] == leg.hip.angle);
        REQUIRE(heard.angles[4 + i] == leg.knee.angle);
        REQUIRE(heard.velocities[i] == leg.hip.velocity);
        REQUIRE(heard.velocities[4 + i] == leg.knee.velocity);
        REQUIRE(heard.torques[i] == leg.hip.torque);
        REQUIRE(heard.torques[4 + i] == leg.knee.torque);
        REQUIRE(heard.contacts[i] == (leg.contact() ? 1.0 : 0.0));
        REQUIRE(heard.loads[i] == leg.foot_force[2]);
        REQUIRE(heard.abducted[i] == leg.abduction.angle);
      }
      REQUIRE(heard.orientation[3] == before.trunk.orientation.w);
      REQUIRE(heard.orientation[0] == before.trunk.orientation.x);
      for (int i = 0; i < 3; ++i) {
        REQUIRE(heard.angular_velocity[i] == before.trunk.angular_velocity[static_cast<std::size_t>(i)]);
        REQUIRE(heard.acceleration[i] == before.trunk.specific_force[static_cast<std::size_t>(i)]);
      }
    }
    const sim::robot_command taken = c.get<"robot.simulator">().world().targets();
    CHECK(taken[0].abduction == 0.1);
    CHECK(taken[3].abduction == sim::oncilla_defaults.abduction_range.high);
    CHECK(taken[1].hip_stiffness == 120);
  }

  TEST_CASE("limits of the axes are those of the model") {
    constexpr auto knee = sim::left_hind_knee::limits;
    CHECK(knee.of<cca::angle>().lower == sim::oncilla_defaults.knee_range.low);
    CHECK(knee.of<cca::torque>().upper == sim::oncilla_defaults.knee_motor.torque);
    constexpr auto hip = sim::right_front_hip::limits;
    CHECK(hip.of<cca::velocity>().upper == sim::oncilla_defaults.hip_motor.no_load_speed);
  }
}
