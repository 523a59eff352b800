// The balance reflex alone: the sign of its correction, its size, its filter, and rates that are not finite.
#include <limits>

#include <doctest/doctest.h>

#include "../../../examples/combination_of_skills/trunk.hpp"

namespace {

using legs = skills::oncilla::leg_angles;  // hips, then knees; each left front, right front, left, right hind

// The reflex on constant rates of turn; `corrections` is what it adds to the command.
struct reflex {
  skills::balance balance{};
  Eigen::Vector4d standing = Eigen::Vector4d::Ones();
  std::int64_t k = 0;

  legs::vector_type corrections(const Eigen::Vector3d& rates, int beats) {
    const legs::vector_type command = legs::vector_type::LinSpaced(0.5, 1.5);
    legs::vector_type angles = command;
    for (int i = 0; i < beats; ++i, ++k) {
      const cca::beat now(k, 1'000'000, 1);
      angles = balance
                   .process({rates, now.time(), true}, {standing, now.time(), true},
                            {command, now.time(), true}, now)
                   .vector();
    }
    return angles - command;
  }
};

constexpr int settled = 200;  // ms, 20 times the time constant of the filter
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_SUITE("balance reflex") {
  TEST_CASE("where the trunk sinks the knees stretch, where it rises they flex, and the hips stay") {
    // Knees: negative is stretched.
    const auto to_left = reflex().corrections({-0.3, 0, 0}, settled);
    const auto nose_down = reflex().corrections({0, 0.3, 0}, settled);
    for (const int left : {4, 6}) CHECK(to_left[left] < -0.001);
    for (const int right : {5, 7}) CHECK(to_left[right] > 0.001);
    for (const int front : {4, 5}) CHECK(nose_down[front] < -0.001);
    for (const int hind : {6, 7}) CHECK(nose_down[hind] > 0.001);
    CHECK(to_left.head<4>().norm() == 0);
    CHECK(nose_down.head<4>().norm() == 0);
    CHECK(reflex().corrections({0, 0, 0.3}, settled).norm() == 0);  // turning about the vertical

    // The speed of the hip, 75 mm from the middle, times `time` / `lever`.
    const auto p = skills::balance{}.p;
    CHECK(to_left[5] == doctest::Approx(p.time / p.lever * 0.3 * 0.075).epsilon(1e-6));
  }

  TEST_CASE("the rates are low-passed, and a leg in the air stays as it is") {
    const auto p = skills::balance{}.p;
    const double at_last = reflex().corrections({0.3, 0, 0}, settled)[4];
    CHECK(reflex().corrections({0.3, 0, 0}, 1)[4] == doctest::Approx(0.001 / p.smoothing * at_last));
    reflex lifted;
    lifted.standing[1] = 0;
    const auto corrections = lifted.corrections({0.3, 0, 0}, settled);
    CHECK(corrections[5] == 0);
    CHECK(corrections[7] < 0);
  }

  TEST_CASE("the correction is bounded, at any rate and any smoothing") {
    const double most = skills::balance{}.p.most;
    for (const double rate : {10.0, 1e6, 1e300}) {
      CAPTURE(rate);
      const auto corrections = reflex().corrections({rate, -rate, rate}, settled);
      CHECK(corrections.tail<4>().cwiseAbs().maxCoeff() == doctest::Approx(most));
    }
    reflex quick;
    quick.balance.p.smoothing = 0.001;
    CHECK(quick.corrections({-0.3, 0, 0}, 1)[4] < 0);
    CHECK(quick.corrections({0, 0, 0}, 1).norm() == 0);
  }

  TEST_CASE("a rate that is not finite does not pass: the correction fades, and comes back with the rates") {
    for (const double bad : {not_a_number, infinite, -infinite})
      for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(bad);
        CAPTURE(axis);
        reflex r;
        const auto before = r.corrections({0.3, 0.1, 0}, settled);
        Eigen::Vector3d rates(0.3, 0.1, 0);
        rates[axis] = bad;
        const auto at_once = r.corrections(rates, 1);
        CHECK(at_once.allFinite());
        CHECK((at_once - before).norm() < 0.2 * before.norm());
        CHECK(r.corrections(rates, settled).norm() < 1e-6);
        CHECK((r.corrections({0.3, 0.1, 0}, settled) - before).norm() < 1e-6);
      }
  }
}
