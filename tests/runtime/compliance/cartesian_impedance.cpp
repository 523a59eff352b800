// Cartesian impedance on a simulated arm.
#include <cca/robot/compliance/cartesian_impedance.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using impedance = cca::cartesian_impedance<arm, "arm", angles, velocities, torques>;
using along_hand = cca::cartesian_impedance<arm, "arm", angles, velocities, torques, flange>;
using pose7 = Eigen::Matrix<double, 7, 1>;
template <class Servo>
using wanted_pose = cca::in<"reference", cca::pose_in<typename Servo::base>>;
template <class Servo>
using wanted_posture = cca::optional_in<"posture", angles>;

pose7 pose_at(const vector& q) { return cca::detail::tip_in<hand_pose>(cca::body_pose<arm>(q).tip<"arm">()); }
cca::beat beat_of(std::int64_t k) { return {k, 1'000'000, 1}; }

// The component as the laws see it.
template <class Servo = impedance>
struct model {
  mutable Servo servo{};
  pose7 reference = pose_at(bent);
  mutable std::int64_t k = 0;
  bool keeps_posture = false;
  vector posture = bent;

  model() {
    servo.p.posture_damping = 0;
    servo.on_start();
  }
  auto all(const vector& q, const vector& dq) const {
    cca::optional_in<"posture", angles> rest;
    if (keeps_posture) rest = given<cca::optional_in<"posture", angles>>(posture);
    return servo.process(given<wanted_pose<Servo>>(reference), angles_of(q), velocities_of(dq), beat_of(k++),
                         {}, {}, {}, {}, rest, {});
  }
  vector operator()(const vector& q, const vector& dq) const {
    return in_order(std::get<0>(all(q, dq)).vector());
  }
  double stored(const vector& q) const {
    const auto end = cca::body_pose<arm>(q).tip<"arm">();
    const cca::matrix3 frame = Servo::along_reference
                                   ? cca::rotation::matrix(Eigen::Vector4d(reference.tail<4>()))
                                   : cca::matrix3(cca::matrix3::Identity());
    vector6 away;
    away << frame.transpose() *
                cca::detail::turn_from(reference.tail<4>(), cca::detail::quaternion_of(end.turn)),
        frame.transpose() * (end.at - reference.head<3>());
    double sum = 0;
    for (int i = 0; i < 6; ++i) {
      const double stiff = servo.p.stiffness[i], e = std::abs(away[i]), most = servo.p.largest[i];
      sum += stiff * e <= most ? 0.5 * stiff * e * e : most * e - 0.5 * most * most / stiff;
    }
    return sum;
  }
};

template <class Servo>
double largest_growth(std::uint64_t seed, bool cut) {
  laws::source random{std::mt19937_64{seed}};
  double most = 0;
  for (int run = 0; run < 6; ++run) {
    model<Servo> servo;
    for (int i = 0; i < 6; ++i) {
      servo.servo.p.stiffness[i] = i < 3 ? random(0, 60) : random(0, 1000);
      if (cut) servo.servo.p.largest[i] = i < 3 ? random(0.2, 3) : random(1, 20);
    }
    servo.servo.p.damping_ratio = random(0, 1);
    servo.servo.p.posture_damping = random(0, 10);
    simulated body{bent, vector::Zero()};
    for (int i = 0; i < 7; ++i) body.q[i] += random(-0.3, 0.3), body.dq[i] = random(-0.5, 0.5);
    body.world.anchor = random.vector(0.6);
    body.world.stiffness = run % 2 ? random(100, 1000) : 0;
    most = std::max(most, laws::energy_created(body, servo, 0.7, 5e-4));
  }
  return most;
}

}  // namespace

TEST_SUITE("Cartesian impedance") {
  TEST_CASE("what is too stiff for its inertia and rate is refused, or lowered with a status") {
    model<> stiff;
    CHECK(stiff.servo.p.check_at(0.001).empty());
    CHECK(is(std::get<2>(stiff.all(bent, vector::Zero())), cca::input_status::usable));
    stiff.servo.p.stiffness.setConstant(1e7);
    CHECK(stiff.servo.p.check_at(0.001).find("`stiffness` is 1e+07, but at 1000 Hz it must be at most") == 0);
    const vector near = bent + vector::Constant(1e-6);
    const auto found = stiff.all(near, vector::Zero());
    CHECK(is(std::get<2>(found), cca::input_status::clamped));
    // It pulls to the reference, and softly enough for a beat.
    const vector pull =
        in_order(std::get<0>(found).vector()) - cca::gravity_torques(cca::body_pose<arm>(near));
    const vector change = 1e-6 * cca::mass_matrix(cca::body_pose<arm>(near)).ldlt().solve(pull);
    CHECK(pull.dot(bent - near) > 0);
    CHECK(change.norm() < (bent - near).norm());
  }

  TEST_CASE("under a load it is as stiff as commanded, about and along each axis") {
    model servo;
    servo.servo.p.stiffness << 40, 40, 40, 400, 600, 900;
    servo.servo.p.damping_ratio = 1;
    servo.servo.p.posture_damping = 20;
    simulated body{bent, vector::Zero()};
    body.world.wrench << 1, -2, 1.5, 20, -12, 9;
    laws::settle(body, servo, 8);
    const pose7 there = pose_at(body.q);
    const Eigen::Vector3d moved = (there - servo.reference).head<3>(),
                          turned = cca::detail::turn_from(servo.reference.tail<4>(), there.tail<4>());
    for (int i = 0; i < 3; ++i) {
      CHECK(moved[i] ==
            doctest::Approx(body.world.wrench[3 + i] / servo.servo.p.stiffness[3 + i]).epsilon(1e-6));
      CHECK(turned[i] == doctest::Approx(body.world.wrench[i] / 40).epsilon(1e-6));
    }
  }

  TEST_CASE("a posture doesn't change the stiffness of the end, and is reached") {
    model servo;
    servo.servo.p.damping_ratio = 1;
    servo.servo.p.posture_stiffness.setConstant(40);
    servo.keeps_posture = true;
    servo.posture << 0.9, 0.6, -1, 1, 0.2, -0.5, 0.6;
    simulated body{bent, vector::Zero()};
    body.world.wrench << 0, 0, 0, 20, -12, 9;
    servo.servo.p.posture_damping = 20;
    const double before = (servo.posture - bent).norm();
    laws::settle(body, servo, 12);
    const Eigen::Vector3d moved = (pose_at(body.q) - servo.reference).head<3>();
    for (int i = 0; i < 3; ++i)
      CHECK(moved[i] == doctest::Approx(body.world.wrench[3 + i] / 500).epsilon(1e-6));
    // Nothing is left for the free joints to do.
    const cca::detail::tip_dynamics_at<arm, "arm"> at(body.q);
    CHECK(at.free_torques(vector(40 * (servo.posture - body.q))).norm() < 1e-5);
    CHECK((servo.posture - body.q).norm() < before);
    CHECK(servo.servo.posture_energy() > 0);
  }

  TEST_CASE("each mode has the damping ratio that was asked for") {
    laws::source random{std::mt19937_64{3}};
    for (const double ratio : {0.1, 0.5, 0.9}) {
      model servo;
      for (int i = 0; i < 6; ++i) servo.servo.p.stiffness[i] = i < 3 ? random(5, 60) : random(100, 1000);
      servo.servo.p.damping_ratio = ratio;
      // And one motion that the end does not feel.
      laws::has_damping_ratio(simulated{bent, vector::Zero()}, servo, ratio, 12);
    }
  }

  TEST_CASE("principal axes along the reference") {
    model<along_hand> servo;
    servo.servo.p.stiffness << 10, 20, 30, 100, 200, 300;
    servo.servo.p.damping_ratio = 0;
    const Eigen::Matrix3d turn = cca::rotation::matrix(Eigen::Vector4d(servo.reference.tail<4>()));
    const Eigen::Vector3d moved(0.01, -0.02, 0.03), turned(0.2, 0, 0);
    servo.reference.head<3>() -= turn * moved;
    auto wrench = std::get<1>(servo.all(bent, vector::Zero())).vector();
    CHECK((wrench.tail<3>() + turn * Eigen::Vector3d(1, -4, 9)).norm() < 1e-12);
    CHECK(wrench.head<3>().norm() < 1e-12);
    servo.reference = pose_at(bent);
    servo.reference.tail<4>() = cca::rotation::product(Eigen::Vector4d(servo.reference.tail<4>()),
                                                       cca::rotation::exp(Eigen::Vector3d(-turned)));
    wrench = std::get<1>(servo.all(bent, vector::Zero())).vector();
    CHECK((wrench.head<3>() + turn * Eigen::Vector3d(2, 0, 0)).norm() < 1e-9);
  }

  TEST_CASE("each optional input acts as the formula says") {
    impedance servo;
    servo.p.damping_ratio = 0, servo.p.posture_damping = 0;
    vector6 stiff, damp, twist, push;
    stiff << 10, 20, 30, 100, 200, 300;
    damp << 0.1, 0.2, 0.3, 1, 2, 3;  // slow enough for the wrist at 1 kHz
    twist << 0.1, -0.2, 0.3, 0.05, 0.1, -0.15;
    push << 0.5, -0.4, 0.3, 2, 3, -4;
    vector dq;
    dq << 0.1, 0.2, -0.1, 0.3, 0.2, -0.2, 0.1;
    const Eigen::Vector3d moved(0.01, -0.02, 0.03);
    const Eigen::Vector4d leans = cca::rotation::about(Eigen::Vector3d(0.6, 0.8, 0), 0.5);
    pose7 reference = pose_at(bent);
    reference.head<3>() -= moved;
    using tip = impedance::tip;
    using base = impedance::base;
    const auto all = servo.process(
        given<wanted_pose<impedance>>(reference), angles_of(bent), velocities_of(dq), beat_of(0),
        given<cca::optional_in<"reference_twist", cca::motion_of<tip, base>>>(twist),
        given<cca::optional_in<"stiffness", cca::stiffness_at<tip, base>>>(stiff),
        given<cca::optional_in<"damping", cca::damping_at<tip, base>>>(damp),
        given<cca::optional_in<"feedforward", cca::load_on<tip, base>>>(push), {},
        given<cca::optional_in<"attitude", cca::base_attitude>>(leans));
    const cca::body_pose<arm> now(bent);
    const auto jacobian = now.jacobian<"arm">();
    vector6 wanted = push + damp.cwiseProduct(twist - jacobian * dq);
    wanted.tail<3>() -= stiff.tail<3>().cwiseProduct(moved);
    CHECK((std::get<1>(all).vector() - wanted).norm() < 1e-9);
    const Eigen::Vector3d down =
        cca::rotation::matrix(leans).transpose() * Eigen::Vector3d(0, 0, -9.81);  // along the leaning base
    const vector torques = jacobian.transpose() * wanted + cca::gravity_torques(now, down);
    CHECK((in_order(std::get<0>(all).vector()) - torques).norm() < 1e-9);
  }

  TEST_CASE("it creates no energy, whatever touches the arm") {
    const double base = largest_growth<impedance>(4, false), cut = largest_growth<impedance>(5, true),
                 hand = largest_growth<along_hand>(6, false), cut_hand = largest_growth<along_hand>(7, true);
    MESSAGE("largest growth of the energy: along the base "
            << base << " J, cut " << cut << " J; along the reference " << hand << " J, cut " << cut_hand
            << " J");
    CHECK(base < 1e-5);
    CHECK(cut < 1e-5);
    CHECK(hand < 1e-5);
    CHECK(cut_hand < 1e-5);
  }

  TEST_CASE("in a loop, with a posture and a wall, it creates no more than the posture may") {
    laws::source random{std::mt19937_64{8}};
    double most = 0;
    for (int run = 0; run < 6; ++run) {
      model servo;
      servo.keeps_posture = true;
      servo.servo.p.posture_energy = 0.2;
      servo.servo.p.posture_damping = random(1, 5);
      servo.servo.p.posture_stiffness.setConstant(30);
      simulated body{bent, vector::Zero()};
      for (int i = 0; i < 7; ++i) servo.posture[i] += random(-1, 1), body.dq[i] = random(-0.3, 0.3);
      body.world.floor = pose_at(bent)[2] - 0.01, body.world.floor_stiffness = 2000;
      most = std::max(most, laws::energy_created_in_a_loop(body, servo, 1, 1e-3));
    }
    MESSAGE("largest growth above the beginning: " << most << " J");
    CHECK(most < 0.2 + 1e-3);
    CHECK(most > 0.01);  // the posture does work
  }

  TEST_CASE("an empty tank lets the posture yield") {
    model servo;
    servo.keeps_posture = true;
    servo.servo.p.posture_energy = 0;
    servo.posture << 0.9, 0.6, -1, 1, 0.2, -0.5, 0.6;
    simulated body{bent, vector::Zero()};
    for (int k = 0; k < 1000; ++k) body.hold(servo(body.q, body.dq), 1e-3);
    CHECK(body.dq.norm() < 1e-2);
    CHECK((body.q - bent).norm() < 1e-2);
  }

  TEST_CASE("the saturation says what was cut, and the torques of a stretched arm stay small") {
    model servo;
    servo.servo.p.largest << 1, 1, 1, 10, 10, 10;
    servo.reference[0] += 0.005;
    CHECK(is(std::get<3>(servo.all(bent, vector::Zero())), cca::saturation::none));
    servo.reference[0] += 0.5;
    const auto far = servo.all(bent, vector::Zero());
    CHECK(is(std::get<3>(far), cca::saturation::spring));
    CHECK(std::get<1>(far).vector()[3] == doctest::Approx(10));
    servo.servo.p.largest.setConstant(1e30), servo.servo.p.stiffness.tail<3>().setConstant(1e6);
    CHECK(is(std::get<3>(servo.all(bent, vector::Zero())), cca::saturation::torque));
    CHECK(servo.servo.summary().starts_with(
        "1 times a torque was at the limit of its joint; 1 times the spring"));

    model stretched;
    stretched.reference = pose_at(vector::Zero());
    stretched.reference[2] += 0.1;  // out of reach
    simulated body{vector::Constant(1e-9), vector::Zero()};
    body.dq << 0.1, 0.2, -0.1, 0.3, 0.2, -0.2, 0.1;
    stretched.servo.p.posture_damping = 5;
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
      const vector t = stretched(body.q, body.dq);
      most = std::max(most, t.cwiseAbs().maxCoeff());
      body.hold(t, 1e-3);
    }
    CHECK(most < 60);
    CHECK(body.dq.norm() < 0.2);
  }

  TEST_CASE("until a reference comes it only holds itself, and numbers that it can't use") {
    impedance servo;
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent)), v = vector::Constant(0.2);
    const auto free =
        servo.process({}, angles_of(bent), velocities_of(vector::Zero()), beat_of(0), {}, {}, {}, {}, {}, {});
    CHECK((in_order(std::get<0>(free).vector()) - held).norm() < 1e-12);
    pose7 broken = pose_at(bent);
    broken[5] = no_number;
    const auto braked = servo.process(given<wanted_pose<impedance>>(broken), angles_of(bent),
                                      velocities_of(v), beat_of(1), {}, {}, {}, {}, {}, {});
    CHECK((in_order(std::get<0>(braked).vector()) - held).dot(v) < -0.1);
    CHECK(is(std::get<2>(braked), cca::input_status::unreadable));
    const auto none =
        servo.process(given<wanted_pose<impedance>>(pose_at(bent)), angles_of(vector::Constant(no_number)),
                      velocities_of(v), beat_of(2), {}, {}, {}, {}, {}, {});
    CHECK(std::get<0>(none).vector().norm() == 0);
    CHECK(is(std::get<2>(none), cca::input_status::unreadable));
  }
}
