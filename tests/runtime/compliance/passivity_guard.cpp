// The passivity guard against controllers that feed energy.
#include <cca/robot/compliance/joint_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using impedance = cca::joint_impedance<arm, angles, velocities, torques>;
using guard = cca::passivity_guard<arm, angles, velocities, torques>;

vector reversed(const vector& v) { return v.reverse(); }

// The torques of a controller through a guard or not, on the simulated arm.
struct outcome {
  double delivered = 0;  // the most that the controller has given in all, J
  double kinetic = 0;    // the most that the arm had
  double least_in_tank = 1e9;
  bool limited = false;
};

// `wanted(q, dq, k)` without gravity.
template <class Controller>
outcome run(const Controller& wanted, bool guarded, double energy, int beats, simulated body = {bent}) {
  guard keeper;
  keeper.p.energy = keeper.p.most = energy;
  keeper.on_start();
  outcome result;
  double given_in_all = 0;
  for (int k = 0; k < beats; ++k) {
    const vector held = cca::gravity_torques(cca::body_pose<arm>(body.q)), ask = wanted(body.q, body.dq, k);
    vector torque = ask + held;
    if (guarded) {
      const auto [out, in_tank, status, state] = keeper.process(
          given<cca::in<"torques", torques>>(reversed(ask)), angles_of(body.q), velocities_of(body.dq),
          {k, 1'000'000, 1}, given<cca::optional_in<"gravity", torques>>(reversed(held)));
      torque = in_order(out.vector());
      result.least_in_tank = std::min(result.least_in_tank, in_tank.vector()[0]);
      result.limited = result.limited || is(state, cca::guard::limiting);
    }
    const vector before = body.q;
    body.hold(torque, 1e-3);
    given_in_all += (torque - held).dot(body.q - before);
    result.delivered = std::max(result.delivered, given_in_all);
    result.kinetic =
        std::max(result.kinetic, 0.5 * body.dq.dot(cca::mass_matrix(cca::body_pose<arm>(body.q)) * body.dq));
    if (result.delivered > 1e4) break;
  }
  return result;
}

// [adversary]
// A stiffness that feeds each swing: stiff on the way back to the reference, soft on the way out.
struct adversary {
  mutable impedance servo{};
  adversary() { servo.p.compensate_gravity = false, servo.p.damping_ratio = 0; }

  vector operator()(const vector& q, const vector& dq, int) const {
    vector stiffness;
    for (int i = 0; i < 7; ++i) stiffness[i] = (bent[i] - q[i]) * dq[i] > 0 ? 60 : 20;
    return in_order(
        std::get<0>(
            servo.process(
                given<cca::in<"reference", angles>>(bent), angles_of(q), velocities_of(dq), {},
                given<cca::optional_in<"stiffness", cca::stiffness_along<torques>>>(reversed(stiffness)), {},
                {}, {}))
            .vector());
  }
};
// [adversary end]

simulated pushed() {
  simulated body{bent, vector::Zero()};
  body.dq << 0.5, -0.4, 0.3, 0.6, -0.2, 0.1, 0.4;
  return body;
}

// What the tank holds when `t` is asked for at these angles and velocities.
double asked(guard& keeper, const vector& t, const vector& q, const vector& dq) {
  return std::get<1>(keeper.process(given<cca::in<"torques", torques>>(reversed(t)), angles_of(q),
                                    velocities_of(dq), {0, 1'000'000, 1}, {}))
      .vector()[0];
}

}  // namespace

TEST_SUITE("passivity guard") {
  TEST_CASE("an adversary that modulates the stiffness gains energy - after the guard it doesn't") {
    const double at_first = 0.5 * pushed().dq.dot(cca::mass_matrix(cca::body_pose<arm>(bent)) * pushed().dq);
    const auto free = run(adversary{}, false, 0, 3000, pushed());
    MESSAGE("without the guard: " << free.delivered << " J delivered, " << free.kinetic << " J of motion");
    CHECK(free.delivered > 20);
    const auto kept = run(adversary{}, true, 1, 10000, pushed());
    MESSAGE("with 1 J in the tank: " << kept.delivered << " J delivered, " << kept.kinetic
                                     << " J of motion, least in the tank " << kept.least_in_tank << " J");
    CHECK(kept.delivered < 1 + 1e-3);
    CHECK(kept.delivered > 0.9);               // it takes all that there is
    CHECK(kept.kinetic < at_first + 1 + 0.1);  // gravity compensation is half a beat late: that feeds, too
    CHECK(kept.least_in_tank > -1e-2);
    CHECK(kept.limited);
  }

  TEST_CASE("torques that push along each motion, that flip in each beat, and that are random") {
    laws::source random{std::mt19937_64{5}};
    const auto along = [](const vector&, const vector& dq, int) {
      return vector(100 * (dq.array() < 0).select(-vector::Ones(), vector::Ones()));
    };
    const auto flipping = [](const vector&, const vector& dq, int k) {
      const double sign = k % 2 ? 1 : -1;
      return vector(sign * 150 * (dq.array() < 0).select(-vector::Ones(), vector::Ones()));
    };
    const auto anything = [&](const vector&, const vector&, int) {
      vector t;
      for (int i = 0; i < 7; ++i) t[i] = random(-100, 100);
      return t;
    };
    for (const double energy : {0.0, 0.1, 3.0}) {
      CAPTURE(energy);
      const auto a = run(along, true, energy, 2000), b = run(flipping, true, energy, 2000),
                 c = run(anything, true, energy, 2000);
      MESSAGE("beyond " << energy << " J: " << a.delivered - energy << ", " << b.delivered - energy << ", "
                        << c.delivered - energy << " J");
      for (const auto& one : {a, b, c}) {
        CHECK(one.delivered < energy + 2e-2);
        CHECK(one.limited);
      }
    }
    CHECK(run(along, false, 0, 200).delivered > 20);
  }

  TEST_CASE("what a spring delivers it has taken before: it passes as it is") {
    impedance servo;
    servo.p.compensate_gravity = false;
    const auto spring = [&](const vector& q, const vector& dq, int) {
      return in_order(std::get<0>(servo.process(given<cca::in<"reference", angles>>(bent), angles_of(q),
                                                velocities_of(dq), {}, {}, {}, {}, {}))
                          .vector());
    };
    const auto kept = run(spring, true, 0.1, 3000, pushed());
    CHECK(!kept.limited);
    CHECK(kept.delivered < 1e-6);
  }

  TEST_CASE("the account is exact: what leaves the tank is the work of the torques") {
    guard keeper;
    keeper.p.energy = keeper.p.most = 5;
    keeper.on_start();
    simulated body = pushed();
    double work = 0, in_tank = 5, least = 5;
    for (int k = 0; k < 200; ++k) {
      const cca::body_pose<arm> at(body.q);
      const vector wanted = cca::mass_matrix(at) * vector::Constant(k < 100 ? 3 : -3),
                   held = cca::gravity_torques(at);
      const auto all = keeper.process(given<cca::in<"torques", torques>>(reversed(wanted)), angles_of(body.q),
                                      velocities_of(body.dq), {k, 1'000'000, 1},
                                      given<cca::optional_in<"gravity", torques>>(reversed(held)));
      in_tank = std::get<1>(all).vector()[0];
      least = std::min(least, in_tank);
      CHECK(in_tank == doctest::Approx(std::min(5 - work, 5.0)).epsilon(1e-9));
      const vector before = body.q;
      body.hold(in_order(std::get<0>(all).vector()), 1e-3);
      work = std::max(0.0, work + wanted.dot(body.q - before));
    }
    CHECK(least < 4.9);
  }

  TEST_CASE("while it saw no angles nothing flows into the tank, but what was taken counts") {
    const vector push = vector::Constant(2), still = vector::Zero(), lost = vector::Constant(no_number);
    for (const double way : {-0.01, 0.01}) {
      CAPTURE(way);
      const vector there = bent + vector::Constant(way);
      const double work = push.dot(there - bent);
      for (const bool gap : {false, true}) {
        guard keeper;
        keeper.p.energy = 1, keeper.p.most = 5;
        keeper.on_start();
        CHECK(asked(keeper, push, bent, still) == 1);
        if (gap) CHECK(asked(keeper, push, lost, still) == 1);
        CHECK(asked(keeper, push, there, still) ==
              doctest::Approx(1 - (gap ? std::max(0.0, work) : work)).epsilon(1e-9));
      }
    }
  }

  TEST_CASE("an angle that jumped leaves a debt of at most 1 J") {
    guard keeper;
    keeper.p.energy = 1, keeper.p.most = 5;
    keeper.on_start();
    asked(keeper, vector::Constant(2), bent, vector::Zero());
    CHECK(asked(keeper, vector::Zero(), bent + vector::Constant(10), vector::Zero()) == -1);
  }

  TEST_CASE("the account is that of the torques within the limits of the axes") {
    guard keeper;
    keeper.p.energy = 1, keeper.p.most = 1e6;
    keeper.on_start();
    const vector push = 300 * vector::Unit(0), moved = -1e-3 * vector::Unit(0);
    const auto first =
        keeper.process(given<cca::in<"torques", torques>>(reversed(push)), angles_of(bent),
                       velocities_of(-vector::Unit(0)), {0, 1'000'000, 1}, {});  // it brakes, so it passes
    REQUIRE(is(std::get<3>(first), cca::guard::passing));
    REQUIRE(in_order(std::get<0>(first).vector())[0] == 200);
    CHECK(asked(keeper, vector::Zero(), bent + moved, vector::Zero()) ==
          doctest::Approx(1 + 0.2).epsilon(1e-9));
  }

  TEST_CASE("numbers that it can't use") {
    guard keeper;
    keeper.on_start();
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent)), v = vector::Constant(0.3),
                 push = vector::Constant(3);
    const auto call = [&](const vector& t, const vector& q, const vector& g) {
      return keeper.process(given<cca::in<"torques", torques>>(reversed(t)), angles_of(q), velocities_of(v),
                            {0, 1'000'000, 1}, given<cca::optional_in<"gravity", torques>>(reversed(g)));
    };
    vector broken = push;
    broken[2] = no_number;
    const auto no_command = call(broken, bent, held);
    CHECK((in_order(std::get<0>(no_command).vector()) - held).dot(v) < 0);  // the brake
    CHECK(is(std::get<2>(no_command), cca::input_status::unreadable));
    CHECK(is(std::get<3>(no_command), cca::guard::limiting));
    const auto blind = call(push, broken, held);
    CHECK((in_order(std::get<0>(blind).vector()) - held).norm() < 1e-12);
    const auto nothing = call(push, broken, broken);
    CHECK(std::get<0>(nothing).vector().norm() == 0);
    CHECK(is(std::get<2>(nothing), cca::input_status::unreadable));
  }

  TEST_CASE("parameters that are refused") {
    guard keeper;
    CHECK_NOTHROW(cca::check_parameters(keeper.p, "guard", 1e-3));
    keeper.p.energy = 3;
    CHECK_THROWS_WITH_AS(cca::check_parameters(keeper.p, "guard"), "guard: `energy` is above `most`",
                         cca::refused);
    keeper.p.most = 3, keeper.p.braking = 40;
    CHECK_THROWS_WITH_AS(
        cca::check_parameters(keeper.p, "guard", 0.1),
        "guard: `braking` is 40, but at 10 Hz it must be at most 10: run the node faster, or "
        "change it",
        cca::refused);
  }
}
