// Contact reaction on a simulated arm with a momentum observer.
#include <cca/robot/compliance/contact_reaction.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using reaction = cca::contact_reaction<arm, angles, velocities, torques>;
using observer = cca::momentum_observer<arm, angles, velocities, torques>;

// An arm that follows a slow movement of its first joint by a stiff servo, and is pushed meanwhile.
struct run {
  reaction reacts{};
  observer sees{};
  simulated body{bent, vector::Zero()};
  vector drive = cca::gravity_torques(cca::body_pose<arm>(bent)), external = vector::Zero();
  std::int64_t k = 0;
  cca::contact state = cca::contact::none;
  vector asked = vector::Zero();

  vector wish() const {
    vector q = bent;
    q[0] += 0.2 * std::sin(0.5 * 1e-3 * static_cast<double>(k));
    return q;
  }
  vector command() const {
    const cca::body_pose<arm> now(body.q);
    return cca::gravity_torques(now) + cca::mass_matrix(now) * vector(100 * (wish() - body.q) - 20 * body.dq);
  }
  void step() {
    const cca::beat now(k++, 1'000'000, 1);
    asked = command();
    const auto port = [](const vector& v) { return vector(v.reverse()); };
    external = in_order(std::get<0>(sees.process(angles_of(body.q), velocities_of(body.dq),
                                                 given<cca::in<"torques", torques>>(port(drive)), now, {}))
                            .vector());
    const auto [out, contact, status] = reacts.process(given<cca::in<"torques", torques>>(port(asked)),
                                                       given<cca::in<"external", torques>>(port(external)),
                                                       angles_of(body.q), velocities_of(body.dq), now, {});
    state = static_cast<cca::contact>(contact.vector()[0]);
    drive = in_order(out.vector());
    body.hold(drive, 1e-3);
  }
  void go(double seconds) {
    for (double t = 0; t < seconds; t += 1e-3) step();
  }
  void push(double newton) { body.world.wrench << 0, 0, 0, 0, newton, 0; }
};

}  // namespace

TEST_SUITE("contact reaction") {
  TEST_CASE("free motion is no contact, and the command passes as it is") {
    run one;
    for (int k = 0; k < 3000; ++k) {
      one.step();
      REQUIRE(one.state == cca::contact::none);
      REQUIRE(one.drive == one.asked);
    }
  }

  TEST_CASE("a push of 20 N is noticed within 20 ms") {
    run one;
    one.go(0.5);
    one.push(20);
    int beats = 0;
    while (one.state == cca::contact::none && beats < 1000) one.step(), ++beats;
    MESSAGE("noticed after " << beats << " ms");
    CHECK(beats < 20);
    CHECK(beats > 2);  // it has to be confirmed
  }

  TEST_CASE("stop holds where it was touched, yield gives way, follow gives way farther") {
    double moved[3];
    for (const auto how : {cca::reaction::stop, cca::reaction::yield, cca::reaction::follow}) {
      run one;
      one.reacts.p.reaction = how;
      one.reacts.p.stop_stiffness.setConstant(300);
      one.go(0.2);
      one.push(20);
      one.go(0.03);
      const vector there = one.body.q;
      one.go(0.2);
      CHECK(one.state == cca::contact::reacting);
      moved[static_cast<int>(how)] = (one.body.q - there).norm();
    }
    MESSAGE("moved within 0.2 s: stop " << moved[0] << " rad, yield " << moved[1] << ", follow " << moved[2]);
    CHECK(moved[0] < 0.06);
    CHECK(moved[1] > 3 * moved[0]);
    CHECK(moved[2] > 1.3 * moved[1]);
  }

  TEST_CASE("let go it waits, returns without a jump, and goes on with the command") {
    run one;
    one.reacts.p.release = 0.3, one.reacts.p.back = 0.5;
    one.go(0.2);
    one.push(20);
    one.go(0.15);
    CHECK(one.state == cca::contact::reacting);
    one.push(0);
    one.go(0.25);
    CHECK(one.state == cca::contact::reacting);
    double jump = 0;
    for (int k = 0; k < 200; ++k) {
      const vector before = one.drive;
      one.step();
      jump = std::max(jump, (one.drive - before).norm());
    }
    CHECK(one.state == cca::contact::returning);
    one.go(0.6);
    CHECK(one.state == cca::contact::none);
    one.go(3);
    CHECK(one.state == cca::contact::none);
    CHECK((one.body.q - one.wish()).norm() < 0.05);
    CHECK(jump < 5);
  }

  TEST_CASE("a new contact on the way back begins again, and a start forgets it") {
    run one;
    one.reacts.p.release = 0.1, one.reacts.p.back = 1;
    one.push(20);
    one.go(0.2);
    one.push(0);
    one.go(0.4);
    CHECK(one.state == cca::contact::returning);
    one.push(-20);
    one.go(0.1);
    CHECK(one.state == cca::contact::reacting);
    one.reacts.on_start();
    one.push(0);
    one.external.setZero(), one.sees.on_start();
    one.step();
    CHECK(one.state == cca::contact::none);
  }

  TEST_CASE("numbers that it can't use") {
    reaction one;
    const vector held = cca::gravity_torques(cca::body_pose<arm>(bent)), v = vector::Constant(0.3);
    const auto call = [&](const vector& t, const vector& e, const vector& q) {
      return one.process(given<cca::in<"torques", torques>>(vector(t.reverse())),
                         given<cca::in<"external", torques>>(e), angles_of(q), velocities_of(v),
                         {0, 1'000'000, 1}, {});
    };
    vector broken = vector::Zero();
    broken[1] = no_number;
    const auto blind = call(held, broken, bent);
    CHECK((in_order(std::get<0>(blind).vector()) - held).dot(v) < -0.1);  // it yields
    CHECK(is(std::get<2>(blind), cca::input_status::unreadable));
    const auto no_angles = call(held, vector::Zero(), broken);
    CHECK(std::get<0>(no_angles).vector().norm() == 0);
    const auto usable = call(held, vector::Zero(), bent);
    CHECK(in_order(std::get<0>(usable).vector()) == held);
    CHECK(is(std::get<1>(usable), cca::contact::none));
  }

  TEST_CASE("parameters that are refused") {
    reaction one;
    CHECK_NOTHROW(cca::check_parameters(one.p, "react", 1e-3));
    one.p.threshold[3] = 0;
    CHECK_THROWS_WITH_AS(cca::check_parameters(one.p, "react"), "react: a threshold is not above 0",
                         cca::refused);
    one.p.threshold[3] = 1, one.p.braking = 30;
    CHECK_THROWS_WITH_AS(
        cca::check_parameters(one.p, "react", 0.05),
        "react: `braking` is 30, but at 20 Hz it must be at most 20: run the node faster, or "
        "change it",
        cca::refused);
  }
}
