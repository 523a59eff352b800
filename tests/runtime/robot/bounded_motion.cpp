// The limiter where axes limit acceleration and jerk: whatever is commanded, no difference of its output
// exceeds a limit, it stays in its range, and a command that stays is reached.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <cca/cca.hpp>
#include <cca/robot/bounded_motion.hpp>
#include <cca/robot/limiter.hpp>

namespace {

using cca::detail::bounded_motion;
using cca::detail::closed_range;
using cca::detail::motion_limits;
constexpr double inf = std::numeric_limits<double>::infinity(),
                 no_number = std::numeric_limits<double>::quiet_NaN();

// The differences of the last numbers against the limits.
struct judge {
  motion_limits most;
  std::array<double, 3> before;  // the last numbers, newest first

  judge(const motion_limits& m, double at) : most(m), before{at, at, at} {}
  // How far the worst of them is beyond its limit, as a part of it.
  double operator()(double x) {
    const auto [p, pp, ppp] = before;
    before = {x, p, pp};
    const double rounding = 4e-15 * (1 + std::abs(x));
    const auto beyond = [&](double d, closed_range r) {
      return d > r.upper   ? (d - r.upper - rounding) / r.upper
             : d < r.lower ? (r.lower - d - rounding) / -r.lower
                           : 0.0;
    };
    if (!most.range.holds(x)) return inf;
    return std::max({beyond(x - p, most.rate), beyond(x - 2 * p + pp, most.second),
                     beyond(x - 3 * p + 3 * pp - ppp, most.third)});
  }
};

struct dice {
  std::mt19937_64 random;
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  double spread(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
  int below(int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); }
  closed_range around_zero(double least, double most, double scale) {
    const double size = spread(least, most) * scale;
    return {-size * between(0.2, 1), size * between(0.2, 1)};
  }
};

// Limits per beat of a millisecond; one of them may be missing.
motion_limits random_limits(dice& d) {
  motion_limits m{d.around_zero(0.1, 4, 1), d.around_zero(0.1, 20, 1e-3), d.around_zero(1, 300, 1e-6),
                  d.around_zero(10, 50'000, 1e-9)};
  const closed_range none{-inf, inf};
  switch (d.below(6)) {
    case 0:
      m.third = none;
      break;
    case 1:
      m.second = none;
      break;
    case 2:
      m.rate = none;
      break;
    case 3:
      m.range = {-1e300, 1e300};
      break;
    default:
      break;
  }
  return m;
}

// Steps, sines, noise, ramps, reversals in each beat, and no number (NaN).
double command(dice& d, int mode, int k, double& goal) {
  switch (mode) {
    case 0:
      return goal;
    case 1:
      return goal + std::sin(0.02 * k);
    case 2:
      return d.between(-5, 5);
    case 3:
      return goal += d.between(-0.01, 0.01);
    case 4:
      return k % 2 == 0 ? 4 : -4;
    case 5:
      return no_number;
    default:
      return goal += 0.002;
  }
}

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-4, 4},
                                             cca::acceleration{-50, 40}, cca::jerk{-5000, 4000}};
};
struct knee : cca::dimension<"knee"> {  // nothing but a velocity
  static constexpr auto limits = cca::limits{cca::angle{-2, 0}, cca::velocity{-4, 4}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct hip_speed : cca::space<cca::joint_velocities, cca::axes<hip>, cca::rate<1000>> {};

template <class Space>
struct bench {
  cca::limiter<Space> limit;
  std::int64_t k = 0;
  typename Space::vector_type operator()(const typename Space::vector_type& command) {
    const std::int64_t now = k++ * 1'000'000;
    return limit.process({command, now, true}, {}, cca::beat{k, 1'000'000, 1}).vector();
  }
};

}  // namespace

TEST_SUITE("bounded motion") {
  TEST_CASE("whatever is commanded, no limit is exceeded - a command that stays is reached, and kept") {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      CAPTURE(seed);
      dice d{std::mt19937_64(seed)};
      const motion_limits most = random_limits(d);
      bounded_motion motion;
      const bool bounded = most.range.upper < 1e100;
      const double start = d.between(bounded ? most.range.lower : -4, bounded ? most.range.upper : 4);
      motion.rest_at(start);
      judge beyond(most, start);
      double worst = 0, goal = start;
      for (int k = 0, mode = 0; k < 4000; ++k) {
        if (d.below(200) == 0) mode = d.below(7), goal = d.between(-4, 4);
        const double wanted = command(d, mode, k, goal);
        worst = std::max(worst, beyond(std::isfinite(wanted) ? motion.go_to(most.range.nearest(wanted), most)
                                                             : motion.brake(most)));
      }
      goal = most.range.nearest(d.between(-4, 4));
      int beats = 0;
      for (; motion.at() != goal && beats < 400'000; ++beats)
        worst = std::max(worst, beyond(motion.go_to(goal, most)));
      CHECK(motion.at() == goal);
      for (int k = 0; k < 100; ++k) {
        worst = std::max(worst, beyond(motion.go_to(goal, most)));
        CHECK(motion.at() == goal);
      }
      CHECK(worst < 1e-6);
    }
  }

  TEST_CASE("a step from rest starts with bounded jerk and takes about as long as the limits demand") {
    bench<leg_angles> b;
    b({0, -1});
    int beats = 0;
    CHECK(b({0.8, -1})[0] == doctest::Approx(4000e-9));
    CHECK(b({0.8, -1})[0] == doctest::Approx(4 * 4000e-9));
    for (beats = 2; b({0.8, -1})[0] != 0.8; ++beats) REQUIRE(beats < 1000);
    // In continuous time: it stops at -50 and speeds up at 40 rad/s^2, and each change takes a jerk's time.
    const double top = std::sqrt(2 * 0.8 / (1 / 40.0 + 1 / 50.0)), in_theory = top / 40 + top / 50;
    CHECK(beats * 1e-3 > in_theory);
    CHECK(beats * 1e-3 < 1.25 * in_theory);
  }

  TEST_CASE("a command that keeps the limits passes as it is, bit for bit") {
    bench<leg_angles> b;
    for (int k = 0; k < 3000; ++k) {
      const double angle = 0.5 * std::pow(std::sin(4e-3 * k), 3);
      const Eigen::Vector2d wanted(angle, -1 + angle);
      REQUIRE(b(wanted) == wanted);
    }
    CHECK(b.limit.interventions() == 0);
  }

  TEST_CASE("after a step it catches up with a command that moves, and then passes it") {
    bench<leg_angles> b;
    b({-0.9, -1});
    int late = 0;
    for (int k = 0; k < 1000; ++k) {
      const double wanted = -0.5 + 0.001 * k;  // 1 rad/s
      late += b({wanted, -1})[0] != wanted;
    }
    CHECK(late < 400);
    CHECK(late > 50);
  }

  TEST_CASE("at full speed it brakes before the end of its range, and NaN makes it brake") {
    for (const double then : {inf, 1e300, 2.0, no_number}) {
      bench<leg_angles> b;
      b({-1, -1});
      double most = -1, last = -1, fastest = 0;
      for (int k = 0; k < 2000; ++k) {
        const double x = b({k < 450 ? 5 : then, -1})[0];
        fastest = std::max(fastest, x - last);
        last = x, most = std::max(most, x);
      }
      CHECK(fastest > 3.9e-3);
      CHECK(fastest <= 4e-3 * (1 + 1e-6));
      CHECK(most <= 1);
      if (std::isfinite(then)) CHECK(last == 1);
    }
  }

  TEST_CASE("a velocity changes by its acceleration, and that by its jerk") {
    bench<hip_speed> b;
    using one = hip_speed::vector_type;
    b(one(0));
    CHECK(b(one(3))[0] == doctest::Approx(4e-3));
    CHECK(b(one(3))[0] == doctest::Approx(12e-3));
    for (int k = 0; k < 200; ++k) b(one(3));
    CHECK(b(one(3))[0] == 3);
    for (int k = 0; k < 200; ++k) b(one(no_number));
    CHECK(b(one(no_number))[0] == 0);
  }
}
