// The parts of the walking policy's example alone: what it observes, how it is fitted, and how it evolves.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <doctest/doctest.h>

#include "../../../examples/walking_policy/evolution.hpp"
#include "../../../examples/walking_policy/imitation.hpp"
#include "../../../examples/walking_policy/trial.hpp"
#include "../../../examples/walking_policy/worth.hpp"

namespace {

struct trunk {
  walking::attitude attitude{};
  std::int64_t k = 0;
  Eigen::Vector3d down{}, course{};

  trunk& hold(const Eigen::Vector4d& orientation, int firings) {
    for (int i = 0; i < firings; ++i, k += walking::period) {
      const cca::beat now(k, 1'000'000, walking::period);
      const auto [d, c] = attitude.process({orientation, now.time(), true}, now);
      down = d.vector(), course = c.vector();
    }
    return *this;
  }
};

walking::lesson lesson_about(const walking::policy::network::input& x) {
  walking::lesson one{x, {}};
  for (int i = 0; i < one.answer.size(); ++i)
    one.answer[i] = 1 + 0.2 * std::sin(2 * x[i]) * x[i + 1] + 0.1 * x[i + 2];
  return one;
}

std::vector<walking::lesson> lessons(int count, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::vector<walking::lesson> all;
  for (int i = 0; i < count; ++i) {
    walking::policy::network::input x;
    for (double& number : x) number = 2 * static_cast<double>(bits() >> 11) * 0x1p-53 - 1;
    all.push_back(lesson_about(x));
  }
  return all;
}

}  // namespace

TEST_SUITE("walking policy") {
  TEST_CASE("down is the way of gravity along the axes of the trunk") {
    for (const auto& [roll, pitch, yaw] :
         {std::array{0.0, 0.0, 0.0}, std::array{0.3, -0.2, 1.0}, std::array{-0.4, 0.5, -2.0}}) {
      const Eigen::Vector4d q = cca::rotation::from_roll_pitch_yaw(roll, pitch, yaw);
      const Eigen::Vector3d expected =
          Eigen::Quaterniond(q).toRotationMatrix().transpose() * Eigen::Vector3d(0, 0, -1);
      CHECK((trunk().hold(q, 1).down - expected).norm() < 1e-12);
    }
  }

  TEST_CASE("the course: yaw, its integral within bounds, and the mean pitch - held while there is none") {
    trunk t;
    t.hold(cca::rotation::from_roll_pitch_yaw(0.0, 0.1, 0.2), 100);  // 1 s
    CHECK(t.course[0] == doctest::Approx(0.2));
    CHECK(t.course[1] == doctest::Approx(0.2 * 1).epsilon(0.02));
    CHECK(t.course[2] == doctest::Approx(0.1 * (1 - std::exp(-1))).epsilon(0.02));
    const Eigen::Vector3d before = t.course;
    t.hold(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()), 10);
    CHECK(t.course == before);
    CHECK(std::isnan(t.down[0]));
    t.hold(cca::rotation::from_roll_pitch_yaw(0.0, 0.1, 0.2), 5000);
    CHECK(t.course[1] == t.attitude.p.farthest);
    CHECK(t.course[2] == doctest::Approx(0.1));
  }

  TEST_CASE("the clock is the phase on a circle, with the amplitude") {
    using number = Eigen::Matrix<double, 1, 1>;
    const auto now = walking::clock().process({number(2.0), 0, true}, {number(0.7), 0, true});
    CHECK(now.vector() == Eigen::Vector3d(std::cos(2.0), std::sin(2.0), 0.7));
  }

  TEST_CASE("imitation fits lessons that it has not seen, with the same bits each time") {
    const auto shown = lessons(4000, 1), others = lessons(1000, 2);
    walking::policy::network::parameters once, again, other;
    walking::imitation fit(once, shown, 1);
    const double untrained = fit.error(others);
    fit.learn(shown, 60);
    const double trained = fit.error(others);
    MESSAGE("error ", untrained, ", after the training ", trained);
    CHECK(trained < untrained / 4);
    walking::imitation(again, shown, 1).learn(shown, 60);
    CHECK(once.weights == again.weights);
    walking::imitation(other, shown, 2).learn(shown, 60);
    CHECK(once.weights != other.weights);
  }

  TEST_CASE("the evolution strategy climbs, though the circumstances of each direction shift its values") {
    Eigen::VectorXd top(20);
    for (int i = 0; i < top.size(); ++i) top[i] = std::sin(i);
    const auto value = [&](const Eigen::VectorXd& x) { return -(x - top).squaredNorm(); };
    const auto climbed = [&](std::uint64_t seed) {
      walking::evolution_strategy search(
          Eigen::VectorXd::Zero(20), {.directions = 16, .noise = 0.03, .length = 0.02, .kept = 0.8}, seed);
      for (int generation = 0; generation < 200; ++generation) {
        std::vector<double> values;
        for (const auto& x : search.ask())
          values.push_back(value(x) + 100 * static_cast<double>(values.size() / 2));
        search.tell(values);
      }
      return search.mean();
    };
    CHECK(value(climbed(1)) > 0.02 * value(Eigen::VectorXd::Zero(20)));
    CHECK(climbed(1) == climbed(1));
    CHECK(climbed(1) != climbed(2));
  }

  TEST_CASE("a point that falls neither leads the evolution alone nor silences the other directions") {
    walking::evolution_strategy search(Eigen::VectorXd::Zero(5),
                                       {.directions = 10, .noise = 0.1, .length = 0.1, .kept = 0}, 1);
    const auto points = search.ask();
    std::vector<double> values(points.size(), 0.0);
    values[0] = -1e6;
    Eigen::VectorXd expected = -3 * points[0];  // at most three times the median
    for (std::size_t i = 2; i < values.size(); i += 2) values[i] = 0.01, expected += points[i];
    search.tell(values);
    CHECK((search.mean() - expected / 10).norm() < 1e-12);  // a direction is a point / 0.1
  }

  TEST_CASE("the helm shows the trunk from a heading that turns as commanded, after the start") {
    walking::helm helm;
    helm.p.turn = 0.5, helm.p.start = 0.2;
    const auto shown = [&](std::int64_t k, double roll, double pitch, double yaw) {
      const cca::beat now(k, 1'000'000, 1);
      const auto q = cca::rotation::from_roll_pitch_yaw(roll, pitch, yaw);
      return std::get<0>(helm.process({q, now.time(), true}, now));
    };
    for (std::int64_t k = 0; k < 200; ++k)
      CHECK(shown(k, 0.1, 0.2, 0.3).vector() == cca::rotation::from_roll_pitch_yaw(0.1, 0.2, 0.3));
    for (std::int64_t k = 200; k < 10'200; ++k) {
      const double heading = 0.5 * static_cast<double>(k - 199) * 1e-3;
      const Eigen::Vector4d relative = shown(k, 0.1, 0.2, heading + 0.3).vector();
      // A quaternion and its negative are the same orientation.
      REQUIRE(std::abs(relative.dot(cca::rotation::from_roll_pitch_yaw(0.1, 0.2, 0.3))) ==
              doctest::Approx(1).epsilon(1e-12));
    }
    // Down is the same from every heading.
    const Eigen::Vector4d q = cca::rotation::from_roll_pitch_yaw(0.3, -0.2, 1.0);
    const cca::beat now(10'200, 1'000'000, 1);
    const auto [relative, turn] = helm.process({q, now.time(), true}, now);
    CHECK((trunk().hold(relative.vector(), 1).down - trunk().hold(q, 1).down).norm() < 1e-12);
    CHECK(turn[trot::yaw{}] == 0.5);
    const Eigen::Vector4d none = Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN());
    CHECK(std::isnan(std::get<0>(helm.process({none, now.time(), true}, now)).vector()[0]));
    const cca::beat first(0, 1'000'000, 1);
    CHECK(std::get<1>(walking::helm{helm}.process({q, first.time(), true}, first))[trot::yaw{}] == 0);
  }

  TEST_CASE("the odometer measures the speed of a trunk whose feet stand still, as it pitches and turns") {
    using namespace cca::robots::oncilla;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    walking::odometer meter;
    meter.p.scale = 1;
    std::int64_t k = 0;
    leg_angles::vector_type angles;
    leg_velocities::vector_type velocities;
    angles << 0.9, 0.6, 0.5, 0.8, 1.6, 1.4, 1.5, 1.7;
    velocities << -2.5, 1, 3, -2.0, 0.4, 5, -7, -0.3;
    Eigen::Vector3d rates(0, 0, 0);
    foot_loads::vector_type loads;
    const auto measured = [&](int beats) {
      double speed = 0;
      for (int i = 0; i < beats; ++i, ++k) {
        const cca::beat now(k, 1'000'000, 1);
        speed = meter.process({angles, now.time(), true}, {velocities, now.time(), true},
                              {rates, now.time(), true}, {loads, now.time(), true}, now)[walking::forward{}];
      }
      return speed;
    };
    // The lowest point of the ball, by differences: where the segments carry it, and how far it rolls.
    const auto against = [&](std::size_t leg) {
      const auto at = [&](double t) {
        const double hip = angles[hip_of(leg)] + t * velocities[hip_of(leg)],
                     knee = angles[knee_of(leg)] + t * velocities[knee_of(leg)];
        const auto& m = cca::sim::oncilla_model{};
        const auto foot = cca::sim::foot_position(m, {hip, knee});
        const double x = foot.x, z = foot.z - body.trunk_above_hips - body.foot_radius,
                     y = side_of(leg) * body.hip_y;
        return x + body.foot_radius * t * velocities[hip_of(leg)] + t * (rates[1] * z - rates[2] * y);
      };
      return -(at(1e-6) - at(-1e-6)) / 2e-6;
    };
    loads << 0, 0, 0, 0;
    CHECK(measured(10) == 0);                    // in the air: none yet
    for (std::size_t leg = 0; leg < 4; ++leg) {  // one foot carries: all that counts
      loads.setZero(), loads[leg] = 25, rates << 0.3, 0.4, -0.5;
      CHECK(measured(4000) == doctest::Approx(against(leg)).epsilon(1e-6));
    }
    const double before = measured(1);
    loads.setZero();
    CHECK(measured(4000) == doctest::Approx(before));  // in the air: that of before
    // Feet count as the squares of their loads, front feet less.
    loads << 10, 0, 0, 20;
    meter.p.front = 0.5;
    CHECK(measured(4000) ==
          doctest::Approx((0.5 * 100 * against(0) + 400 * against(3)) / (0.5 * 100 + 400)).epsilon(1e-6));
    const double held = measured(1);
    rates[1] = nan;
    CHECK(measured(100) == held);
    rates[1] = 0.4, loads[1] = nan;
    CHECK(measured(100) == held);
    // A mean over `average`, and `scale` times as much.
    walking::odometer fresh;
    fresh.p.scale = 2, fresh.p.average = 0.5;
    loads << 0, 0, 0, 20;
    meter = fresh;
    CHECK(measured(500) == doctest::Approx(2 * (1 - std::exp(-1)) * against(3)).epsilon(0.01));
  }

  TEST_CASE("the throttle is the straight line of the trot, and corrects it where the speed is measured") {
    const auto asked = [](walking::throttle& t, double at, std::int64_t k, bool wired) {
      cca::optional_in<"speed", walking::trunk_speed> speed(Eigen::Matrix<double, 1, 1>(at), 0, true);
      if (wired) speed.set_wired();
      return t.process(speed, cca::beat(k, 1'000'000, 10)).vector()[0];
    };
    walking::throttle t;
    t.p.speed = 0.4;
    const double line = t.p.intercept + t.p.slope * t.p.speed;
    std::int64_t k = 0;
    for (; k < 200; k += 10) CHECK(asked(t, 0, k, true) == -1);  // it stands first, and gathers nothing
    for (; k < 1200; k += 10) CHECK(asked(t, 0.1, k, false) == line);
    CHECK(asked(t, 0.4, k, true) == doctest::Approx(line));
    for (int i = 0; i < 10; ++i, k += 10) CHECK(asked(t, 0.3, k, true) > line);  // 0.1 s, too slow by 0.1
    CHECK(asked(t, 0.4, k, true) == doctest::Approx(line + t.p.slope * t.p.gain * 0.1 * 0.1));
    CHECK(asked(t, std::numeric_limits<double>::quiet_NaN(), k, true) ==
          doctest::Approx(line + t.p.slope * t.p.gain * 0.1 * 0.1));
    for (int i = 0; i < 2000; ++i, k += 10)
      CHECK(asked(t, 0, k, true) <= line + t.p.slope * t.p.most + 1e-12);
    CHECK(asked(t, 0, k, true) == doctest::Approx(line + t.p.slope * t.p.most));
    CHECK(asked(t, 0.5, k, true) < line + t.p.slope * t.p.most);  // it has not wound up
    for (int i = 0; i < 2000; ++i, k += 10) asked(t, 0.9, k, true);
    CHECK(asked(t, 0.9, k, true) == doctest::Approx(line - t.p.slope * t.p.most));
    t.p.speed = 0;
    CHECK(asked(t, 0.9, k, true) == -1);
    t.p.speed = 0.4;
    CHECK(asked(t, 0.4, k, true) == doctest::Approx(line));  // from the line again
  }

  TEST_CASE("the symmetric policy does on the left what it does on the right, half a stride later") {
    using network = walking::policy::network;
    walking::symmetric_policy both;
    walking::policy one;
    std::mt19937_64 bits(3);
    const auto number = [&] { return 2 * static_cast<double>(bits() >> 11) * 0x1p-53 - 1; };
    for (double& w : both.weights.weights) w = 0.3 * number();
    both.weights.offset << 0.8, 0.8, 0.6, 0.6, 1.6, 1.6, 1.5, 1.5;
    both.weights.gain.setConstant(0.1);
    one.weights = both.weights;
    const auto answer = [](auto& policy, const network::input& x) {
      return std::get<0>(policy.process({x.segment<3>(0), 0, true}, {x.segment<3>(3), 0, true},
                                        {x.segment<3>(6), 0, true}, {x.segment<3>(9), 0, true},
                                        {x.segment<8>(12), 0, true}));
    };
    // Numbers that change their sign; then left and right change places.
    const auto mirror = [](network::input x) {
      for (const int i : {0, 1, 4, 6, 8, 9, 10}) x[i] = -x[i];
      for (const int i : {12, 14, 16, 18}) std::swap(x[i], x[i + 1]);
      return x;
    };
    const auto swapped = [](network::output y) {
      for (const int i : {0, 2, 4, 6}) std::swap(y[i], y[i + 1]);
      return y;
    };
    for (int i = 0; i < 20; ++i) {
      network::input x;
      for (double& v : x) v = number();
      x.tail<8>() += both.weights.offset;
      const network::output y = answer(both, x).vector(), of_one = answer(one, x).vector(),
                            of_image = answer(one, mirror(x)).vector();
      CHECK(y.isApprox(0.5 * (of_one + swapped(of_image)), 1e-12));
      CHECK(answer(both, mirror(x)).vector().isApprox(swapped(y), 1e-12));
      CHECK(!of_one.isApprox(swapped(of_image), 1e-3));
      both.p.symmetric = false;
      CHECK(answer(both, x).vector() == of_one);
      both.p.symmetric = true;
      x[7] = std::numeric_limits<double>::quiet_NaN();
      CHECK(!answer(both, x));
    }
  }

  TEST_CASE("in a circle the feet step aside, so that they stand still on the ground") {
    using number = Eigen::Matrix<double, 1, 1>;
    walking::sidestep s;
    s.p.share = 1;
    const double turn = 0.4, frequency = s.p.duty / s.p.stance, whole = 2 * std::numbers::pi;
    const auto abduction = [&](double phase, double amplitude, double turning) {
      return s.process({number(phase), 0, true}, {number(amplitude), 0, true}, {number(turning), 0, true})
          .vector();
    };
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const double x = leg < 2 ? s.p.front : s.p.hind, side = leg % 2 == 0 ? 1 : -1;
      const auto at = [&](double own) {
        return side * s.p.height *
               abduction(cca::wrap_signed(whole * (own - s.p.offsets[leg])), 1, turn)[leg];
      };
      // In stance it moves as the ground does under a trunk that turns: -turn * x; over a stride, nowhere.
      const double step = 0.01;
      CHECK((at(0.4) - at(0.4 - step)) / (step / frequency) == doctest::Approx(-turn * x));
      CHECK(at(0.5 * s.p.duty) == doctest::Approx(0).epsilon(1e-9));
      CHECK(at(0) == doctest::Approx(-at(s.p.duty)));
      CHECK(at(0.5 * (1 + s.p.duty)) == doctest::Approx(0).epsilon(1e-9));
      CHECK(at(1 - 1e-9) == doctest::Approx(at(0)));
    }
    CHECK(abduction(0.3, 1, 0).isZero());
    CHECK(abduction(0.3, 0, turn).isZero());
    CHECK(abduction(0.3, 0.5 * s.p.full, turn).isApprox(0.5 * abduction(0.3, 1, turn)));
    CHECK(abduction(0.3, 1, -turn).isApprox(-abduction(0.3, 1, turn)));
    CHECK(abduction(0.3, 5, turn) == abduction(0.3, s.p.full, turn));
  }

  TEST_CASE("the figures along a circle: speed towards the nose, turn, and cost of transport") {
    trot::recording run;
    run.mass = 2, run.work = 30;
    const double speed = 0.4, turn = -0.5;
    for (int k = 0; k <= 10'000; ++k) {  // 10 s, more than once past the yaw of pi
      const double t = 1e-3 * k, yaw = turn * t;
      trot::moment m{};
      m.time = t;
      m.position = {speed / turn * std::sin(yaw), speed / turn * (1 - std::cos(yaw)), 0.2};
      m.attitude = {0.01 * std::sin(t), 0.02, cca::wrap_signed(yaw)};
      run.moments.push_back(m);
    }
    walking::figures f = walking::along_its_way(run);
    CHECK(f.cruise == doctest::Approx(0.4).epsilon(1e-6));
    CHECK(f.turn == doctest::Approx(-0.5).epsilon(1e-6));
    CHECK(f.way == doctest::Approx(4).epsilon(1e-6));
    CHECK(f.transport == doctest::Approx(30 / (2 * 9.81 * 4)));
    CHECK(f.max_pitch == 0.02);
    CHECK(walking::walks(f, {0.4, -0.5}));
    CHECK(walking::walks(f, {0.44, -0.54}));
    CHECK(!walking::walks(f, {0.46, -0.5}));
    CHECK(!walking::walks(f, {0.34, -0.5}));
    CHECK(!walking::walks(f, {0.4, -0.44}));
    CHECK(!walking::walks(f, {0.4, 0}));
    // More of the bounds, each alone; a figure that is NaN keeps none.
    const auto with = [&](auto change) {
      walking::figures changed = f;
      changed.turn = 0;
      change(changed);
      return walking::walks(changed, {0.4, 0});
    };
    CHECK(with([](auto& g) { g.drift = 0.1; }));
    CHECK(!with([](auto& g) { g.drift = 0.7; }));
    CHECK(!with([](auto& g) { g.slip = 0.16; }));
    CHECK(!with([](auto& g) { g.fell = true; }));
    CHECK(!with([](auto& g) { g.cruise = std::numeric_limits<double>::quiet_NaN(); }));
    CHECK(!with([](auto& g) { g.slip = std::numeric_limits<double>::quiet_NaN(); }));
    CHECK(walking::worth(f, {0.4, -0.5}, 10) > walking::worth(f, {0.5, -0.5}, 10));
    CHECK(walking::worth(f, {0.4, -0.5}, 10) > walking::worth(f, {0.4, -0.4}, 10));
    const double walked = walking::worth(f, {0.6, -0.3}, 10);
    f.fell = true;
    CHECK(walking::worth(f, {0.4, -0.5}, 10) < walked);
  }

  TEST_CASE("a trial is drawn from its number alone") {
    int straight = 0, left = 0;
    double slowest = 1, fastest = 0;
    for (std::uint64_t n = walking::first_of_training; n < walking::first_of_training + 300; ++n) {
      const walking::trial t = walking::drawn_trial(n), again = walking::drawn_trial(n);
      CHECK(t.wanted.speed == again.wanted.speed);
      CHECK(t.uncertain.drives.delay == again.uncertain.drives.delay);
      CHECK(static_cast<std::uint64_t>(t.uncertain.seed.value()) == n);
      straight += t.wanted.turn == 0, left += t.wanted.turn > 0;
      slowest = std::min(slowest, t.wanted.speed), fastest = std::max(fastest, t.wanted.speed);
    }
    CHECK(straight == 100);
    CHECK(left > 80);
    CHECK(left < 120);
    CHECK(slowest < 0.17);
    CHECK(fastest > 0.68);
  }
}
