// Bodies of parts: their attachment, and the laws of their kinematics and dynamics.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cca/component/parameters.hpp>
#include <cca/mapping/pantograph.hpp>
#include <cca/robot/body_components.hpp>

#include "../../laws/mapping_laws.hpp"
#include "bodies.hpp"
#include "random_trees.hpp"

namespace {

using namespace body_test;

static_assert(std::is_same_v<cca::axes_of<dog>, cca::axes<d, b, c, e, a>>);
static_assert(dog::attached::parent == std::array{2, 3, 4, -1, -1});
static_assert(star::attached::parent == std::array{-1, -1});
static_assert(cca::part_index<dog>("tail") == 3 && cca::part_index<dog>("ear") == -1);

using vector = cca::body_pose<dog>::vector_type;

vector random_state(laws::source& random, double size) {
  vector v;
  for (auto& x : v) x = random(-size, size);
  return v;
}

// Its coordinates are d, b, c, e, a.
cca::rigid by_hand(const vector& q, std::string_view which) {
  const auto step = [](const cca::rigid& from, const cca::joint& j, double x) {
    cca::rigid to = from * j.where;
    const Eigen::Vector3d axis = cca::detail::as_vector(j.axis).normalized();
    if (j.kind == cca::joint_kind::prismatic) to.at += to.turn * axis * x;
    else to.turn = to.turn * cca::rotation::matrix<double>(cca::rotation::about<double>(axis, x));
    return to;
  };
  cca::rigid frame;
  if (which == "tail" || which == "sensor") {
    frame = step(frame, tail_chain::joints[0], q[3]) * tail_chain::tip;
    return which == "tail" ? frame : frame * sensor_place::tip;
  }
  frame = step(frame, hip_chain::joints[0], q[4]) * hip_chain::tip;
  if (which == "hip") return frame;
  frame = step(step(step(frame, leg_chain::joints[0], -q[1]), leg_chain::joints[1], q[2]),
               leg_chain::joints[2], 0.1 - q[2]) *
          leg_chain::tip;
  if (which == "leg") return frame;
  return step(frame, toe_chain::joints[0], 0.7 * q[0]) * toe_chain::tip;
}

// Kinetic and potential energy of all masses, with the base at rest; velocities are differences of positions.
double energy(const vector& q, const vector& dq, const Eigen::Vector3d& gravity) {
  constexpr double h = 1e-6;
  const cca::body_pose<dog> now(q), before(q - h * dq), after(q + h * dq);
  double sum = 0;
  for (std::size_t i = 0; i < now.links().size(); ++i) {
    const auto& inertia = cca::detail::body_tree_of<dog>.links[i].inertia;
    const Eigen::Vector3d c = cca::detail::as_vector(inertia.centre);
    const auto point = [&](const cca::body_pose<dog>& p) -> Eigen::Vector3d {
      return p.links()[i].frame.at + p.links()[i].frame.turn * c;
    };
    const Eigen::Vector3d v = (point(after) - point(before)) / (2 * h);
    const Eigen::Matrix3d spin = now.links()[i].frame.turn.transpose() *
                                 (after.links()[i].frame.turn - before.links()[i].frame.turn) / (2 * h);
    const Eigen::Vector3d w(spin(2, 1), spin(0, 2), spin(1, 0));
    sum += inertia.mass * (v.dot(v) / 2 - gravity.dot(point(now))) +
           w.dot(cca::detail::matrix_of(inertia.about_centre) * w) / 2;
  }
  return sum;
}

// A graph with the nodes that the hip names, one of them in an inner graph.
struct motor {
  void act() {}
};
struct no_motor {
  void process(cca::beat) {}
};
struct legs : cca::graph<cca::node<"motor", motor>> {};
struct whole : cca::graph<cca::rate<1000>,
                          cca::node<"legs", legs>,
                          cca::node<"hip", motor>,
                          cca::node<"plan", no_motor>> {};
static_assert(cca::embodied<dog, whole>);
static_assert(cca::detail::has_resource<whole>("hip") && !cca::detail::has_resource<whole>("plan") &&
              !cca::detail::has_resource<whole>("hi") && !cca::detail::has_resource<whole>("motor") &&
              cca::detail::has_resource<whole>("legs.motor") && !cca::detail::has_resource<whole>("legs"));

struct angles : cca::space<cca::joint_angles, cca::axes<a, b, c, d, e>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<e, a, b, c, d>> {};
struct accelerations : cca::space<cca::joint_accelerations, cca::axes<d, b, c, e, a>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<c, b, a, e, d>> {};
struct paw_in_trunk : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

}  // namespace

TEST_SUITE("body") {
  TEST_CASE("parts end where their chains lead") {
    laws::source random{std::mt19937_64{41}};
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2);
      const cca::body_pose<dog> now(q);
      const auto check = [&](const cca::rigid& tip, std::string_view which) {
        const auto expected = by_hand(q, which);
        CHECK_MESSAGE((tip.at - expected.at).norm() < 1e-14, which);
        CHECK_MESSAGE((tip.turn - expected.turn).norm() < 1e-14, which);
      };
      check(now.tip<"toe">(), "toe");
      check(now.tip<"leg">(), "leg");
      check(now.tip<"hip">(), "hip");
      check(now.tip<"tail">(), "tail");
      check(now.tip<"sensor">(), "sensor");
    }
  }

  TEST_CASE("Jacobians agree with differences of positions") {
    laws::source random{std::mt19937_64{42}};
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2), dq = random_state(random, 1);
      constexpr double h = 1e-6;
      const cca::body_pose<dog> now(q), before(q - h * dq), after(q + h * dq);
      const auto check = [&](const auto& jacobian, const cca::rigid& from, const cca::rigid& to) {
        const Eigen::Matrix<double, 6, 1> v = jacobian * dq;
        const Eigen::Matrix3d turn =
            (to.turn * from.turn.transpose() - Eigen::Matrix3d::Identity()) / (2 * h);
        const Eigen::Vector3d w =
            Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1)) / 2;
        CHECK((v.tail<3>() - (to.at - from.at) / (2 * h)).norm() < 1e-8);
        CHECK((v.head<3>() - w).norm() < 1e-8);
      };
      check(now.jacobian<"toe">(), before.tip<"toe">(), after.tip<"toe">());
      check(now.jacobian<"leg">(), before.tip<"leg">(), after.tip<"leg">());
      check(now.jacobian<"sensor">(), before.tip<"sensor">(), after.tip<"sensor">());
    }
  }

  // Along any motion the power of the joints equals the change of energy.
  TEST_CASE("power equals the change of energy") {
    laws::source random{std::mt19937_64{43}};
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2), dq = random_state(random, 2), ddq = random_state(random, 3);
      cca::base_motion base;
      base.gravity = random.vector(10);
      const cca::body_pose<dog> now(q);
      const auto torques = cca::inverse_dynamics(now, dq, ddq, base).torques;
      constexpr double h = 1e-4;
      const auto energy_at = [&](double t) {
        return energy(q + t * dq + t * t / 2 * ddq, dq + t * ddq, base.gravity);
      };
      const double change = (energy_at(h) - energy_at(-h)) / (2 * h);
      CHECK(torques.dot(dq) == doctest::Approx(change).epsilon(1e-5).scale(1));
    }
  }

  TEST_CASE("the torques of gravity agree with inverse dynamics at rest, and with the centre of mass") {
    laws::source random{std::mt19937_64{44}};
    const vector zero = vector::Zero();
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2);
      cca::base_motion base;
      base.gravity = random.vector(10);
      const cca::body_pose<dog> now(q);
      const auto held = cca::inverse_dynamics(now, zero, zero, base);
      CHECK((cca::gravity_torques(now, base.gravity) - held.torques).norm() < 1e-13);
      const double mass = 3 + 0.3 + 0.35 + 0.04;
      CHECK((held.wrench.tail<3>() + mass * base.gravity).norm() < 1e-12);
      CHECK((held.wrench.head<3>() + mass * now.centre_of_mass().cross(base.gravity)).norm() < 1e-12);
    }
  }

  TEST_CASE("a body without mass has its centre of mass at the origin of the base") {
    struct weightless : cca::body<trunk, cca::part<"tail", tail_chain>> {};
    CHECK(cca::body_pose<weightless>(Eigen::Matrix<double, 1, 1>(0.3)).centre_of_mass() ==
          Eigen::Vector3d::Zero());
  }

  // The wrench on the base equals the change of momentum, seen from a turning base in which all else is at
  // rest.
  TEST_CASE("the wrench on a moving base equals the change of momentum") {
    laws::source random{std::mt19937_64{45}};
    const vector zero = vector::Zero();
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2);
      cca::base_motion base;
      base.gravity.setZero();
      base.angular_velocity = random.vector(3);
      base.angular_acceleration = random.vector(3);
      base.acceleration = random.vector(3);
      const cca::body_pose<dog> now(q);
      const auto held = cca::inverse_dynamics(now, zero, zero, base);
      const Eigen::Vector3d c = now.centre_of_mass(), w = base.angular_velocity,
                            dw = base.angular_acceleration;
      CHECK((held.wrench.tail<3>() - 3.69 * (base.acceleration + dw.cross(c) + w.cross(w.cross(c)))).norm() <
            1e-12);
      // With fixed joints the whole is one rigid body: its inertia about the origin of the base.
      Eigen::Matrix3d inertia = cca::detail::matrix_of(dog::base.about_centre);
      const auto add = [&](double m, const Eigen::Vector3d& p) {
        inertia += m * (p.dot(p) * Eigen::Matrix3d::Identity() - p * p.transpose());
      };
      add(dog::base.mass, cca::detail::as_vector(dog::base.centre));
      for (std::size_t k = 0; k < now.links().size(); ++k) {
        const auto& link = cca::detail::body_tree_of<dog>.links[k].inertia;
        const auto& frame = now.links()[k].frame;
        inertia += frame.turn * cca::detail::matrix_of(link.about_centre) * frame.turn.transpose();
        add(link.mass, frame.at + frame.turn * cca::detail::as_vector(link.centre));
      }
      const Eigen::Vector3d expected =
          inertia * dw + w.cross(inertia * w) + 3.69 * c.cross(base.acceleration);
      CHECK((held.wrench.head<3>() - expected).norm() < 1e-12);
    }
  }

  TEST_CASE("components: each space may have its own order of axes") {
    laws::source random{std::mt19937_64{46}};
    cca::inverse_dynamics_of<dog, angles, velocities, accelerations, torques> dynamics;
    cca::gravity_compensation<dog, angles, torques> gravity;
    cca::part_kinematics<dog, "leg", angles, paw_in_trunk> kinematics;
    static_assert(cca::HasParameters<decltype(dynamics)> && cca::HasParameters<decltype(gravity)>);
    static_assert(cca::Mapping<decltype(kinematics)> && cca::Mapping<decltype(gravity)>);
    for (int i = 0; i < laws::rounds; ++i) {
      const vector q = random_state(random, 2), dq = random_state(random, 2),
                   ddq = random_state(random, 2);  // d, b, c, e, a
      const cca::body_pose<dog> now(q);
      const vector in_a(q[4], q[1], q[2], q[0], q[3]), in_v(dq[3], dq[4], dq[1], dq[2], dq[0]);
      const cca::in<"angles", angles> angle_port(in_a, 0, true);
      const cca::in<"velocities", velocities> velocity_port(in_v, 0, true);
      const cca::in<"accelerations", accelerations> acceleration_port(ddq, 0, true);

      const Eigen::Vector4d turn = cca::rotation::exp(random.vector(2));
      cca::optional_in<"attitude", cca::base_attitude> level, tilted(turn, 0, true);
      tilted.set_wired();
      cca::base_motion base;
      const auto in_order = [](const auto& t) { return vector(t[2], t[1], t[4], t[3], t[0]); };
      CHECK(dynamics.process(angle_port, velocity_port, acceleration_port, level).vector() ==
            in_order(cca::inverse_dynamics(now, dq, ddq, base).torques));
      CHECK(gravity.process(angle_port, level).vector() == in_order(cca::gravity_torques(now)));
      base.gravity = cca::rotation::matrix<double>(turn).transpose() * base.gravity;
      CHECK((dynamics.process(angle_port, velocity_port, acceleration_port, tilted).vector() -
             in_order(cca::inverse_dynamics(now, dq, ddq, base).torques))
                .norm() < 1e-12);
      CHECK((gravity.process(angle_port, tilted).vector() - in_order(cca::gravity_torques(now, base.gravity)))
                .norm() < 1e-12);
      CHECK(laws::map(kinematics, in_a) == now.tip<"leg">().at);
    }
    gravity.p.gravity = 0;
    CHECK(laws::map(gravity, vector(1, 1, 1, 1, 1)).isZero());
  }
}
