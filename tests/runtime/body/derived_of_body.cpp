// Components that share the kinematics and the mass matrix of a body give the bits of those that compute them
// alone.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include <cca/cca.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/compliance/cartesian_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>

#include "bodies.hpp"

using namespace body_test;

namespace {

template <cca::fixed_string Name>
struct limited : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::torque{-80, 80}};
};
struct base : cca::frame<"base"> {};
struct end : cca::frame<"end"> {};
using joints = cca::axes<limited<"j1">, limited<"j2">, limited<"j3">>;
struct chain : cca::serial_chain<base, end, joints> {
  static constexpr std::array joints{revolute(along_z, at(0, 0, 0.1)), revolute(along_y, at(0, 0, 0.2)),
                                     revolute(along_y, at(0.3, 0, 0))};
  static constexpr auto tip = at(0.25, 0, 0);
  static constexpr std::array links{cca::link_inertia{2, {0, 0, 0.1}, {0.02, 0.02, 0.01, 0, 0, 0}},
                                    cca::link_inertia{1.5, {0.15, 0, 0}, {0.002, 0.02, 0.02, 0, 0, 0}},
                                    cca::link_inertia{1, {0.1, 0, 0}, {0.001, 0.01, 0.01, 0, 0, 0}}};
};
struct body : cca::body<base, cca::part<"arm", chain>> {};
struct angles : cca::space<cca::joint_angles, joints> {};
struct velocities : cca::space<cca::joint_velocities, joints> {};
struct torques : cca::space<cca::joint_torques, joints> {};
// The same axes in another order.
struct other_angles : cca::space<cca::joint_angles, cca::axes<limited<"j3">, limited<"j1">, limited<"j2">>> {
};

using gravity = cca::gravity_compensation<body, angles, torques>;
using observer = cca::momentum_observer<body, angles, velocities, torques>;
using guard = cca::passivity_guard<body, angles, velocities, torques>;
using impedance = cca::cartesian_impedance<body, "arm", angles, velocities, torques>;
using place = cca::pose_in<base>;
using kinematics = cca::part_kinematics<body, "arm", angles, place>;

// Angles that no component takes as they are come, too: beyond the bound of inputs, and NaN.
struct moving {
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", angles>,
                                          cca::out<"velocities", velocities>,
                                          cca::out<"torques", torques>,
                                          cca::out<"wanted", place>> {
    const double t = 0.01 * static_cast<double>(now.index());
    Eigen::Vector3d q(std::sin(t), 0.5 + 0.3 * std::cos(t), 0.8 - 0.2 * std::sin(2 * t));
    if (now.index() % 50 == 20) q[1] = 1e13;
    if (now.index() % 50 == 40) q[2] = std::numeric_limits<double>::quiet_NaN();
    Eigen::Matrix<double, 7, 1> pose;
    pose << 0.4, 0.1, 0.3, cca::rotation::about(Eigen::Vector3d(0, 1, 0), 0.6);
    return {q, Eigen::Vector3d(std::cos(t), -0.3 * std::sin(t), 0.1), Eigen::Vector3d(1, 2, 3), pose};
  }
  void act(cca::in<"torque", torques>) {}
};

struct together : cca::graph<cca::rate<1000>,
                             cca::node<"robot", moving>,
                             cca::node<"flange", kinematics>,
                             cca::node<"gravity", gravity>,
                             cca::node<"observer", observer>,
                             cca::node<"impedance", impedance>,
                             cca::node<"guard", guard>,
                             cca::wire<"robot.angles", "flange.angles">,
                             cca::wire<"robot.angles", "gravity.angles">,
                             cca::wire<"robot.angles", "observer.angles">,
                             cca::wire<"robot.velocities", "observer.velocities">,
                             cca::wire<"robot.torques", "observer.torques">,
                             cca::wire<"robot.angles", "impedance.angles">,
                             cca::wire<"robot.velocities", "impedance.velocities">,
                             cca::wire<"robot.wanted", "impedance.reference">,
                             cca::wire<"impedance.torques", "guard.torques">,
                             cca::wire<"robot.angles", "guard.angles">,
                             cca::wire<"robot.velocities", "guard.velocities">,
                             cca::wire<"gravity.torques", "guard.gravity">,
                             cca::node<"limits", cca::limiter<torques>>,
                             cca::wire<"guard.torques", "limits.command">,
                             cca::wire<"limits.safe", "robot.torque">,
                             cca::observe<"flange.*">,
                             cca::observe<"observer.*">,
                             cca::observe<"impedance.*">,
                             cca::observe<"guard.*">> {};

}  // namespace

TEST_SUITE("derived of a body") {
  TEST_CASE("components in a graph have the bits of each alone") {
    cca::controller<together> c;
    c.load();
    c.start();
    moving robot;
    kinematics f;
    gravity g;
    observer o;
    impedance i;
    guard s;
    int compared = 0;
    for (std::int64_t k = 0; k < 200; ++k) {
      c.step();
      const cca::beat now(k, 1'000'000, 1);
      const auto [q, dq, drive, wanted] = robot.sense(now);
      const cca::in<"angles", angles> at(q.vector(), now.time(), true);
      const cca::in<"velocities", velocities> speed(dq.vector(), now.time(), true);
      const auto pose = f.process(at);
      const auto weight = g.process(at, {});
      const auto felt =
          o.process(at, speed, cca::in<"torques", torques>(drive.vector(), now.time(), true), now, {});
      const auto soft = i.process(cca::in<"reference", place>(wanted.vector(), now.time(), true), at, speed,
                                  now, {}, {}, {}, {}, {}, {});
      cca::optional_in<"gravity", torques> held(weight.vector(), now.time(), true);
      held.set_wired();
      const auto safe = s.process(cca::in<"torques", torques>(std::get<0>(soft).vector(), now.time(), true),
                                  at, speed, now, held);
      const auto expect = [&](std::string_view path, const auto& alone) {
        c.observed([&](const cca::observation& one) {
          if (one.path != path) return;
          ++compared;
          for (std::size_t n = 0; n < one.values.size(); ++n) {
            const double a = one.values[n], b = alone.vector()[static_cast<Eigen::Index>(n)];
            INFO(std::string(path) << " in beat " << k);
            CHECK(((std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0));
          }
        });
      };
      expect("flange.pose", pose);
      expect("observer.external", std::get<0>(felt));
      expect("observer.status", std::get<1>(felt));
      expect("impedance.torques", std::get<0>(soft));
      expect("impedance.status", std::get<2>(soft));
      expect("guard.torques", std::get<0>(safe));
      expect("guard.energy", std::get<1>(safe));
      expect("guard.status", std::get<2>(safe));
    }
    CHECK_EQ(compared, 200 * 8);
  }
  TEST_CASE("an angle beyond the bound of inputs counts as the bound") {
    const auto torques_at = [](double angle) {
      const cca::beat now(0, 1'000'000, 1);
      const cca::in<"angles", angles> at(Eigen::Vector3d(0.1, angle, 0.2), 0, true);
      const cca::in<"velocities", velocities> speed(Eigen::Vector3d(0.3, 0.2, 0.1), 0, true);
      const cca::in<"torques", torques> wanted(Eigen::Vector3d(1, 2, 3), 0, true);
      Eigen::Matrix<double, 6, 1> all;
      all << std::get<0>(guard().process(wanted, at, speed, now, {})).vector(),
          std::get<0>(impedance().process({}, at, speed, now, {}, {}, {}, {}, {}, {})).vector();
      return all;
    };
    CHECK(torques_at(1e12).allFinite());
    CHECK(torques_at(1e13) == torques_at(1e12));
    CHECK(torques_at(1e13) != torques_at(2e12 / 3));
  }
  TEST_CASE("of a space with the axes in another order") {
    const cca::in<"angles", other_angles> q(Eigen::Vector3d(0.3, 0.1, 0.2), 0, true);  // j3, j1, j2
    const cca::body_pose<body> now(Eigen::Vector3d(0.1, 0.2, 0.3));
    CHECK(cca::pose_of<body>::of(q).tip<"arm">().at == now.tip<"arm">().at);
    const cca::derived<cca::end_of<body, "arm">, "angles"> tip;
    CHECK(tip.of(q).at == now.tip<"arm">().at);
    const cca::derived<cca::jacobian_of<body, "arm">, "angles"> jacobian;
    CHECK(jacobian.of(q) == now.jacobian<"arm">());
    const cca::derived<cca::mass_of<body>, "angles"> mass;
    CHECK(mass.of(q).matrix == cca::mass_matrix(now));
    CHECK((mass.of(q).matrix * mass.of(q).solver.solve(Eigen::Vector3d(1, 2, 3)) - Eigen::Vector3d(1, 2, 3))
              .norm() < 1e-12);
  }
}
