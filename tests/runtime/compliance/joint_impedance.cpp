// Joint impedance on a simulated arm.
#include <cca/robot/compliance/joint_impedance.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using impedance = cca::joint_impedance<arm, angles, velocities, torques>;
using wanted_angles = cca::in<"reference", angles>;
using wanted_stiffness = cca::optional_in<"stiffness", cca::stiffness_along<torques>>;
using wanted_damping = cca::optional_in<"damping", cca::damping_along<torques>>;
using wanted_torques = cca::optional_in<"feedforward", torques>;
using wanted_velocities = cca::optional_in<"reference_velocities", velocities>;

// The component as the laws see it.
struct model {
  mutable impedance servo{};
  vector reference = bent;

  vector operator()(const vector& q, const vector& dq) const {
    return in_order(std::get<0>(servo.process(given<wanted_angles>(reference), angles_of(q),
                                              velocities_of(dq), {}, {}, {}, {}, {}))
                        .vector());
  }
  double stored(const vector& q) const {
    double all = 0;
    for (int i = 0; i < 7; ++i) {
      const double k = servo.p.stiffness[i], e = std::abs(reference[i] - q[i]), most = servo.p.largest[i];
      all += k * e <= most ? 0.5 * k * e * e : most * e - 0.5 * most * most / k;
    }
    return all;
  }
};

vector random_vector(laws::source& random, double size) {
  vector v;
  for (int i = 0; i < 7; ++i) v[i] = random(-size, size);
  return v;
}

}  // namespace

TEST_SUITE("joint impedance") {
  TEST_CASE("under a load it is as stiff as commanded") {
    model servo;
    servo.servo.p.stiffness << 80, 60, 50, 40, 20, 10, 5;
    servo.servo.p.damping_ratio = 1;
    const vector push{4, -3, 2, 2, -1, 0.5, 0.2};
    simulated body{bent, vector::Zero()};
    body.world.load = push;
    laws::settle(body, servo);
    const vector expected = push.cwiseQuotient(servo.servo.p.stiffness);
    MESSAGE("largest error of the deflection: " << ((body.q - bent) - expected).cwiseAbs().maxCoeff()
                                                << " rad");
    for (int i = 0; i < 7; ++i) CHECK(body.q[i] - bent[i] == doctest::Approx(expected[i]).epsilon(1e-6));
  }

  TEST_CASE("stiffness, damping and feed-forward from ports") {
    impedance servo;
    servo.p.damping_ratio = 0;
    servo.p.compensate_gravity = false;
    const vector e{0.1, 0.2, 0.3, 0.1, 0.2, 0.3, 0.1}, k{1, 2, 3, 4, 5, 6, 7}, d{7, 6, 5, 4, 3, 2, 1},
        v{1, -1, 2, -2, 1, -1, 0.5}, w{0.5, 0, 0, 1, 0, 0, 2}, ff{3, 1, 4, 1, 5, 9, 2};
    const auto [torque, status, cut] = servo.process(
        given<wanted_angles>(vector(bent + e)), angles_of(bent), velocities_of(v),
        given<wanted_velocities>(w), given<wanted_stiffness>(vector(k.reverse())),
        given<wanted_damping>(vector(d.reverse())), given<wanted_torques>(vector(ff.reverse())), {});
    CHECK((in_order(torque.vector()) - (k.cwiseProduct(e) + d.cwiseProduct(w - v) + ff)).norm() < 1e-12);
    CHECK(is(status, cca::input_status::usable));
    CHECK(is(cut, cca::saturation::none));
  }

  TEST_CASE("gravity is compensated, also on a base that leans") {
    impedance servo;
    const auto lean = cca::sample<cca::base_attitude>::about({1, 0, 0}, 0.4);
    using attitude = cca::optional_in<"attitude", cca::base_attitude>;
    const auto torque =
        std::get<0>(servo.process(given<wanted_angles>(bent), angles_of(bent), velocities_of(vector::Zero()),
                                  {}, {}, {}, {}, given<attitude>(lean.vector())));
    const Eigen::Vector3d down = lean.inverse().rotate(Eigen::Vector3d(0, 0, -9.81));
    CHECK((in_order(torque.vector()) - cca::gravity_torques(cca::body_pose<arm>(bent), down)).norm() < 1e-9);
  }

  TEST_CASE("each mode has the damping ratio that was asked for") {
    laws::source random{std::mt19937_64{1}};
    for (const double ratio : {0.1, 0.5, 0.9}) {
      model servo;
      for (int i = 0; i < 7; ++i) servo.servo.p.stiffness[i] = random(1, 100);
      servo.servo.p.damping_ratio = ratio;
      const auto found = laws::damping_ratios(simulated{bent, vector::Zero()}, servo);
      REQUIRE(found.size() == 14);
      for (const double one : found) CHECK(one == doctest::Approx(ratio).epsilon(1e-5));
    }
  }

  TEST_CASE("with a ratio of 0.5 a small step overshoots by 16 %, in each mode") {
    model servo;
    servo.servo.p.stiffness.setConstant(30);
    servo.servo.p.damping_ratio = 0.5;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        30 * Eigen::MatrixXd::Identity(7, 7), cca::mass_matrix(cca::body_pose<arm>(bent)));
    for (int i = 0; i < 7; ++i) {
      const vector shape = modes.eigenvectors().col(i).normalized();
      const double w = std::sqrt(modes.eigenvalues()[i]), dt = 0.01 / w;
      simulated body{bent - 1e-4 * shape, vector::Zero()};
      double most = -1;
      for (int k = 0; k * dt < 8 / w; ++k) {
        body.step(servo, dt);
        most = std::max(most, (body.q - bent).dot(shape) / 1e-4);
      }
      CHECK(most == doctest::Approx(std::exp(-cca::pi / std::sqrt(3.0))).epsilon(1e-3));
    }
  }

  TEST_CASE("it creates no energy, whatever touches the arm") {
    laws::source random{std::mt19937_64{2}};
    double most = 0, in_a_loop = 0;
    for (int run = 0; run < 12; ++run) {
      model servo;
      for (int i = 0; i < 7; ++i) {
        servo.servo.p.stiffness[i] = random(0, 100);
        if (run % 3 == 0) servo.servo.p.largest[i] = random(0.5, 5);  // cut most of the time
      }
      servo.servo.p.damping_ratio = random(0, 1);
      simulated body{bent + random_vector(random, 0.5), random_vector(random, 0.5)};
      body.world.anchor = random.vector(0.6);
      body.world.stiffness = run % 2 ? random(100, 1000) : 0;
      body.world.damping = random(0, 5);
      most = std::max(most, laws::energy_created(body, servo, 1, 5e-4));
      servo.servo.p.damping_ratio = 0.7;  // more than what a beat of delay feeds
      servo.servo.p.stiffness = servo.servo.p.stiffness.cwiseMax(30);
      // Within a beat the spring gives up to half its stiffness times the square of the way more than it
      // stored.
      body.q = bent + 0.3 * (body.q - bent);
      body.world.floor = cca::body_pose<arm>(bent).tip<"arm">().at[2], body.world.floor_stiffness = 2000;
      in_a_loop = std::max(in_a_loop, laws::energy_created_in_a_loop(body, servo, 1, 1e-3));
    }
    MESSAGE("largest growth of the energy: " << most << " J; in a loop of 1 kHz, above the beginning: "
                                             << in_a_loop << " J");
    CHECK(most < 1e-5);
    CHECK(in_a_loop < 1e-3);
  }

  TEST_CASE("the saturation says what was cut") {
    impedance servo;
    servo.p.largest.setConstant(2);
    const auto torques_for = [&](double far, double extra) {
      vector ff = vector::Zero();
      ff[6] = extra;  // of the first joint
      return servo.process(given<wanted_angles>(vector(bent + vector::Constant(far))), angles_of(bent),
                           velocities_of(vector::Zero()), {}, {}, {}, given<wanted_torques>(ff), {});
    };
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent));
    const auto [small, s1, none] = torques_for(0.01, 0);
    CHECK(is(none, cca::saturation::none));
    const auto [large, s2, spring] = torques_for(1, 0);
    CHECK(is(spring, cca::saturation::spring));
    CHECK((in_order(large.vector()) - held - vector::Constant(2)).norm() < 1e-9);
    const auto [most, s3, torque] = torques_for(1, 300);
    CHECK(is(torque, cca::saturation::torque));
    CHECK(in_order(most.vector())[0] == 200);
    CHECK(is(s3, cca::input_status::usable));
    CHECK(servo.summary() ==
          "1 times a torque was at the limit of its joint; 1 times the spring, or the force control, was at "
          "its "
          "largest force");
    torques_for(std::numeric_limits<double>::quiet_NaN(), 0);
    CHECK(servo.summary().ends_with("; 1 times an input was not finite"));
    servo.on_start();
    CHECK(servo.summary() == "");
  }

  TEST_CASE("until a reference comes it only holds itself, and before the first angles it does nothing") {
    impedance servo;
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent));
    const auto free =
        std::get<0>(servo.process({}, angles_of(bent), velocities_of(vector::Zero()), {}, {}, {}, {}, {}));
    CHECK((in_order(free.vector()) - held).norm() < 1e-12);
    const auto nothing = std::get<0>(
        servo.process(given<wanted_angles>(bent), {}, velocities_of(vector::Zero()), {}, {}, {}, {}, {}));
    CHECK(nothing.vector().norm() == 0);
  }

  TEST_CASE("numbers that it can't use") {
    impedance servo;
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent)), v = vector::Constant(0.2);
    vector broken = bent;
    broken[3] = no_number;
    // A reference that is none: the arm is held and braked as by the parameters.
    const auto braked =
        std::get<0>(servo.process({}, angles_of(bent), velocities_of(v), {}, {}, {}, {}, {})).vector();
    vector soft = vector::Constant(3);
    const auto [torque, status, cut] =
        servo.process(given<wanted_angles>(broken), angles_of(bent), velocities_of(v), {},
                      given<wanted_stiffness>(soft), {}, given<wanted_torques>(soft), {});
    CHECK(torque.vector() == braked);
    CHECK((in_order(braked) - held).dot(v) < -0.1);
    CHECK(is(status, cca::input_status::unreadable));
    // An angle that is none: no torque.
    const auto [none, lost, uncut] =
        servo.process(given<wanted_angles>(bent), angles_of(broken), velocities_of(v), {}, {}, {}, {}, {});
    CHECK(none.vector().norm() == 0);
    CHECK(is(lost, cca::input_status::unreadable));
    // A stiffness below 0 counts as 0.
    const auto [weak, clamped, unlimited] =
        servo.process(given<wanted_angles>(vector(bent + v)), angles_of(bent), velocities_of(vector::Zero()),
                      {}, given<wanted_stiffness>(vector(-soft)), {}, {}, {});
    CHECK((in_order(weak.vector()) - held).norm() < 1e-12);
    CHECK(is(clamped, cca::input_status::clamped));
  }

  TEST_CASE("parameters that are refused") {
    impedance servo;
    CHECK_NOTHROW(cca::check_parameters(servo.p));
    servo.p.stiffness[2] = -1;
    CHECK_THROWS_WITH_AS(cca::check_parameters(servo.p, "servo"), "servo: a stiffness is negative",
                         cca::refused);
    servo.p.stiffness[2] = 1, servo.p.damping[0] = 1e13;
    CHECK_THROWS_WITH_AS(cca::check_parameters(servo.p, "servo"),
                         "servo: a stiffness or damping is above 1e12", cca::refused);
  }
}
