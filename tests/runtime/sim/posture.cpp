// The trot's posture alone: the signs of heading and leaning, their bounds, and an orientation that is NaN.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <doctest/doctest.h>

#include "../../../examples/trot/posture.hpp"
#include "../../../examples/trot/stride_oscillator.hpp"

namespace {

// The posture on a constant orientation, at 100 Hz.
struct trunk {
  trot::posture posture{};
  std::int64_t k = 0;

  struct output {
    double turn, hips, knees;
  };
  output hold(const Eigen::Vector4d& orientation, int firings) {
    output last{};
    for (int i = 0; i < firings; ++i, k += 10) {
      const cca::beat now(k, 1'000'000, 10);
      const auto [turn, lean] = posture.process({orientation, now.time(), true}, now);
      last = {turn.vector()[0], lean.vector()[0], lean.vector()[1]};
    }
    return last;
  }
  output hold(double roll, double pitch, double yaw, int firings) {
    return hold(cca::rotation::from_roll_pitch_yaw(roll, pitch, yaw), firings);
  }
};

constexpr int settled = 1000;  // 10 s

}  // namespace

TEST_SUITE("posture") {
  TEST_CASE("after a start the posture and the gait's oscillator begin as the first time") {
    trunk used;
    used.hold(0.1, 0.2, 0.3, settled);
    used.posture.on_start();
    const auto again = used.hold(0.05, 0.1, 0.1, 1), first = trunk().hold(0.05, 0.1, 0.1, 1);
    CHECK(again.turn == first.turn);
    CHECK(again.hips == first.hips);
    CHECK(again.knees == first.knees);

    trot::stride_oscillator gait;
    const auto beats = [&](int count) {
      double phase = 0, amplitude = 0;
      for (std::int64_t k = 0; k < count; ++k) {
        const cca::beat now(k, 1'000'000, 1);
        const auto [at, radius] =
            gait.process({trot::wanted_amplitude::vector_type(1.0), now.time(), true}, now);
        phase = at.vector()[0], amplitude = radius.vector()[0];
      }
      return std::pair(phase, amplitude);
    };
    const auto begun = beats(1), went_on = beats(1000);
    CHECK(went_on.second > 0.9);
    gait.on_start();
    CHECK(beats(1) == begun);
  }

  TEST_CASE("it turns against the yaw") {
    CHECK(trunk().hold(0, 0, 0.1, 1).turn < 0);  // to the left: to the right
    CHECK(trunk().hold(0, 0, -0.1, 1).turn > 0);
  }

  TEST_CASE("the hips follow the mean pitch: uphill the feet move back, under the weight") {
    const auto p = trot::posture{}.p;
    CHECK(trunk().hold(0, -0.1, 0, settled).hips == doctest::Approx(-0.1 * p.upright).epsilon(0.01));
    CHECK(trunk().hold(0, 0.1, 0, settled).hips == doctest::Approx(0.1 * p.upright).epsilon(0.01));
    CHECK(std::abs(trunk().hold(0, -0.1, 0, 1).hips) < 0.02 * 0.1 * p.upright);
  }

  TEST_CASE("the knees counter roll, and its rate") {
    // Positive roll: the right side is low. A positive `lean` flexes the left knees and extends the right
    // ones.
    const auto p = trot::posture{}.p;
    CHECK(trunk().hold(0.1, 0, 0, settled).knees == doctest::Approx(0.1 * p.level));
    CHECK(trunk().hold(-0.1, 0, 0, settled).knees == doctest::Approx(-0.1 * p.level));
    trunk rolls;
    rolls.hold(0, 0, 0, 1);
    const double rate = 0.001 / 0.01;  // rad/s
    CHECK(rolls.hold(0.001, 0, 0, 1).knees == doctest::Approx(0.001 * p.level + rate * p.damp));
  }

  TEST_CASE("turn and lean are bounded, also when the roll jumps by a whole turn") {
    const auto p = trot::posture{}.p;
    trunk t;
    const double far = 3.1;
    for (const double side : {+1.0, -1.0, +1.0}) {
      const auto is = t.hold(side * far, side * 1.5, side * far, settled);
      CHECK(std::abs(is.turn) == doctest::Approx(p.most));
      CHECK(is.hips == doctest::Approx(side * std::min<double>(p.most_lean, p.upright * 1.5)));
      CHECK(is.knees == doctest::Approx(side * p.most_lean));
    }
    CHECK(t.hold(-far, 0, 0, 1).knees >= -p.most_lean);
  }

  TEST_CASE("an orientation that is NaN does not pass: the outputs stay, and go on with the orientation") {
    for (int i = 0; i < 4; ++i) {
      CAPTURE(i);
      trunk disturbed, undisturbed;
      const auto before = disturbed.hold(0.05, 0.03, 0.02, 100);
      undisturbed.hold(0.05, 0.03, 0.02, 100);
      Eigen::Vector4d bad = cca::rotation::from_roll_pitch_yaw(0.05, 0.03, 0.02);
      bad[i] = std::numeric_limits<double>::quiet_NaN();
      const auto meanwhile = disturbed.hold(bad, 50);
      CHECK(meanwhile.turn == before.turn);
      CHECK(meanwhile.hips == before.hips);
      CHECK(meanwhile.knees == before.knees);
      const auto after = disturbed.hold(0.05, 0.03, 0.02, 1),
                 expected = undisturbed.hold(0.05, 0.03, 0.02, 1);
      CHECK(after.turn == expected.turn);
      CHECK(after.hips == expected.hips);
      CHECK(after.knees == expected.knees);
    }
  }
}
