// The leg compared with closed forms: kinematics and its inverse, springs as the derivative of their energy,
// motors within their torque-speed lines.
#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "standing.hpp"

using namespace test;

namespace {
const sim::oncilla_model& m = sim::oncilla_defaults;
constexpr cca::robots::cable_drive cable = cca::robots::oncilla::as_built::knee.cable;

// Extends the knee: force times d(length)/d(knee).
double spring_torque(double knee) {
  const double lever = m.middle_length * m.spring_arm * std::sin(knee) / sim::diagonal_length(m, knee);
  return m.spring_rate * sim::diagonal_stretch(m, knee) * lever;
}

double spring_energy(double knee) {
  const double s = sim::diagonal_stretch(m, knee);
  return 0.5 * m.spring_rate * s * s;
}
}  // namespace

TEST_SUITE("sim leg") {
  TEST_CASE("inverse kinematics undoes forward kinematics") {
    for (double hip = -1; hip <= 1; hip += 0.1)
      for (double knee = m.knee_range.low; knee <= m.knee_range.high; knee += 0.1) {
        const sim::leg_angles_in_plane q = sim::leg_angles_for(m, sim::foot_position(m, {hip, knee}));
        CHECK(q.hip == doctest::Approx(hip).epsilon(1e-9));
        CHECK(q.knee == doctest::Approx(knee).epsilon(1e-9));
      }
  }

  TEST_CASE("out of reach the knee stays in its range and the leg points at the target") {
    const sim::leg_angles_in_plane q = sim::leg_angles_for(m, {0.3, -0.3});
    CHECK(q.knee == m.knee_range.low);
    const sim::foot_in_plane foot = sim::foot_position(m, q);
    CHECK(std::atan2(foot.x, -foot.z) == doctest::Approx(std::atan2(0.3, 0.3)));
  }

  TEST_CASE("a leg folded square: the law of cosines by hand") {
    const double right_angle = std::acos(0.0);
    const sim::foot_in_plane foot = sim::foot_position(m, {0, right_angle});
    CHECK(foot.x == doctest::Approx(-m.middle_length));
    CHECK(foot.z == doctest::Approx(-(m.upper_length + m.lower_length + m.toe_length)));
    CHECK(sim::diagonal_length(m, right_angle) == doctest::Approx(std::hypot(0.095, 0.035)));
  }

  TEST_CASE("the diagonal spring: slack, then the derivative of its energy") {
    CHECK(spring_torque(sim::degrees(80)) == 0);
    // The study's figures: 0.77, 1.8 and 2.5 N m at 90, 100 and 110 degrees, to their precision.
    CHECK(spring_torque(sim::degrees(90)) == doctest::Approx(0.77).epsilon(0.02));
    CHECK(spring_torque(sim::degrees(100)) == doctest::Approx(1.8).epsilon(0.04));
    CHECK(spring_torque(sim::degrees(110)) == doctest::Approx(2.5).epsilon(0.05));
    for (double knee = sim::degrees(85); knee < sim::degrees(150); knee += 0.02) {
      const double h = 1e-6;
      const double slope = (spring_energy(knee + h) - spring_energy(knee - h)) / (2 * h);
      CHECK(spring_torque(knee) == doctest::Approx(slope).epsilon(1e-6));
    }
  }

  TEST_CASE("a motor drives within its line and brakes with its full torque") {
    const sim::motor_line line{6, 14};
    CHECK(sim::limit_torque(line, 9, 0) == 6);
    CHECK(sim::limit_torque(line, 9, 7) == 6);
    CHECK(sim::limit_torque(line, 9, 10.5) == doctest::Approx(3));
    CHECK(sim::limit_torque(line, 9, 14) == 0);
    CHECK(sim::limit_torque(line, 9, 20) == 0);
    CHECK(sim::limit_torque(line, -9, 20) == -6);
    CHECK(sim::available_speed(line, 0) == 14);
    CHECK(sim::available_speed(line, 3) == doctest::Approx(10.5));
    CHECK(sim::available_speed(line, 6) == 0);
  }

  TEST_CASE("the cable pulls or hangs slack, it never pushes") {
    sim::cable_winch winch;
    winch.position = 1;
    CHECK(winch.pull(m.knee_motor, cable, 1.2, 0) == 0);
    CHECK(winch.pull(m.knee_motor, cable, 0.99, 0) == doctest::Approx(0.01 * cable.stiffness));
    CHECK(winch.pull(m.knee_motor, cable, 0.99, 100) == 0);
    CHECK(winch.pull(m.knee_motor, cable, 0.0, 0) == m.knee_motor.torque);
    const double before = winch.position;
    winch.aim(2, 1e-3);
    winch.wind(m.knee_motor, 1e-3);  // stalled: it holds, but winds no further
    CHECK(winch.position == before);
    winch.aim(0, 1e-3);
    winch.wind(m.knee_motor, 1e-3);  // it can always let go
    CHECK(winch.position == doctest::Approx(before - 1e-3 * m.knee_motor.no_load_speed));
  }

  TEST_CASE("the cable winds evenly: its greatest pull doesn't depend on the physics step") {
    const auto greatest_pull = [](int steps_per_beat) {
      sim::cable_winch winch;
      const double beat = 1e-3, dt = beat / steps_per_beat;
      double greatest = 0;
      for (int k = 1; k <= 20; ++k) {
        winch.aim(1e-3 * k, beat);  // 1 rad/s, against a knee that holds
        for (int i = 0; i < steps_per_beat; ++i) {
          winch.wind(m.knee_motor, dt);
          greatest = std::max(greatest, winch.pull(m.knee_motor, cable, 0, 0));
        }
        CHECK(winch.position == doctest::Approx(1e-3 * k));
      }
      return greatest;
    };
    CHECK(greatest_pull(2) == doctest::Approx(cable.stiffness * 0.02 + cable.damping * 1));
    CHECK(greatest_pull(32) == doctest::Approx(greatest_pull(2)));
  }

  TEST_CASE("the engine's legs stand where the closed form says, abducted too") {
    sim::initial_posture p = crouched();
    p.legs[0] = {0.5, 1.3, 0.2};
    p.legs[3] = {-0.2, 1.8, -0.3};
    sim::world w(m, sim::terrain::flat(), p);
    const sim::vector3 trunk = w.trunk_position();
    for (std::size_t i = 0; i < 4; ++i) {
      const sim::leg_reading r = w.reading().legs[i];
      CHECK(r.hip.angle == doctest::Approx(p.legs[i].hip));
      CHECK(r.knee.angle == doctest::Approx(p.legs[i].knee));
      CHECK(r.abduction.angle == doctest::Approx(p.legs[i].abduction));
      CHECK(std::abs(r.toe.angle) < 1e-12);
      const sim::foot_in_plane foot = sim::foot_position(m, {p.legs[i].hip, p.legs[i].knee});
      const sim::vector3 at = w.foot_position(i);
      CHECK(at[0] - trunk[0] == doctest::Approx((sim::is_front(i) ? m.hip_x : -m.hip_x) + foot.x));
      CHECK(at[1] - trunk[1] ==
            doctest::Approx(sim::side_of(i) * (m.hip_y - foot.z * std::sin(p.legs[i].abduction))));
      CHECK(at[2] - trunk[2] ==
            doctest::Approx(-m.trunk_above_hips + foot.z * std::cos(p.legs[i].abduction)));
      CHECK(w.tension(i) == doctest::Approx(m.spring_rate * sim::diagonal_stretch(m, p.legs[i].knee)));
    }
  }

  TEST_CASE("in motion the pantograph holds and velocities add up to angles") {
    sim::world w(m, sim::terrain::flat(), crouched());
    const sim::robot_reading start = w.reading();
    std::array<sim::vector3, 4> turned{};
    for (int k = 0; k < 1500; ++k) {
      run(w, k, k + 1);
      for (std::size_t i = 0; i < 4; ++i) {
        const sim::leg_reading now = w.reading().legs[i];
        turned[i][0] += now.hip.velocity * 1e-3;
        turned[i][1] += now.knee.velocity * 1e-3;
        turned[i][2] += now.abduction.velocity * 1e-3;
        REQUIRE(std::abs(now.hip.angle - start.legs[i].hip.angle - turned[i][0]) < 0.03);
        REQUIRE(std::abs(now.knee.angle - start.legs[i].knee.angle - turned[i][1]) < 0.03);
        REQUIRE(std::abs(now.abduction.angle - start.legs[i].abduction.angle - turned[i][2]) < 0.03);
      }
    }
    CHECK(w.parallel_error() < 1e-8);
  }
}
