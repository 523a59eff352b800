// The parts of the walking policy's example alone: what it observes, how it is fitted, and how it evolves.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <doctest/doctest.h>

#include "../../../examples/walking_policy/evolution.hpp"
#include "../../../examples/walking_policy/imitation.hpp"

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

  TEST_CASE("the course: yaw, its integral within bounds, and the mean pitch; held while there is none") {
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

  TEST_CASE("the random search climbs") {
    Eigen::VectorXd top(20);
    for (int i = 0; i < top.size(); ++i) top[i] = std::sin(i);
    const auto value = [&](const Eigen::VectorXd& x) { return -(x - top).squaredNorm(); };
    walking::augmented_random_search search(Eigen::VectorXd::Zero(20), {16, 8, 0.03, 0.02}, 1);
    for (int generation = 0; generation < 300; ++generation) {
      std::vector<double> values;
      for (const auto& x : search.ask()) values.push_back(value(x));
      search.tell(values);
    }
    CHECK(value(search.mean()) > 0.02 * value(Eigen::VectorXd::Zero(20)));
  }
}
