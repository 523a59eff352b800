// What is wrong with a reading has the size that was asked for: statistics of many readings, from fixed
// seeds.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <cca/base/math/random_numbers.hpp>
#include <cca/sim/uncertain/uncertainty.hpp>

#include "close_to.hpp"

namespace sim = cca::sim;

namespace {

using uncertain_test::close_to;

using angles = sim::uncertain_reading<cca::angle>;

struct moments {
  double mean = 0, deviation = 0;
};
moments moments_of(const std::vector<double>& all) {
  moments m;
  for (const double x : all) m.mean += x / static_cast<double>(all.size());
  double square = 0;
  for (const double x : all) square += (x - m.mean) * (x - m.mean);
  m.deviation = std::sqrt(square / static_cast<double>(all.size()));
  return m;
}

// Readings of the same true value, from one sensor.
std::vector<double> readings(const angles& p, double truth, std::size_t count, std::uint64_t seed) {
  cca::random_numbers draws(seed), noise(seed + 1);
  sim::detail::uncertain_channel<1> channel;
  channel.draw(draws);
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 1> x{truth};
    channel.change(x, p, noise);
    all.push_back(x[0]);
  }
  return all;
}
// One reading of each of many sensors.
std::vector<double> sensors(const angles& p, double truth, std::size_t count) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(readings(p, truth, 1, 1000 + 7 * i)[0]);
  return all;
}

std::string refusal(auto change) {
  sim::uncertainty u{};
  change(u);
  try {
    cca::check_parameters(u);
  } catch (const cca::refused& e) { return e.what(); }
  return "";
}

}  // namespace

TEST_SUITE("uncertain: readings") {
  TEST_CASE("random numbers are the ones of SplitMix64, uniform and normal") {
    cca::random_numbers random(0);  // the published first numbers of the seed 0
    CHECK(random.bits() == 0xe220a8397b1dcdafu);
    CHECK(random.bits() == 0x6e789e6aa1b965f4u);
    CHECK(random.bits() == 0x06c45d188009454fu);
    std::vector<double> uniform, normal, third;
    std::size_t beyond = 0, happened = 0;
    for (int i = 0; i < 100000; ++i) {
      uniform.push_back(random.uniform());
      normal.push_back(random.normal());
      third.push_back(std::pow(normal.back(), 3));
      beyond += std::abs(normal.back()) > 2;
      happened += random.happens(0.2);
      REQUIRE(uniform.back() >= 0);
      REQUIRE(uniform.back() < 1);
      REQUIRE(random.below(6) < 6);
    }
    CHECK(close_to(moments_of(uniform).mean, 0.5, 0.01));
    CHECK(close_to(moments_of(uniform).deviation, std::sqrt(1.0 / 12), 0.01));
    CHECK(std::abs(moments_of(normal).mean) < 0.01);
    CHECK(close_to(moments_of(normal).deviation, 1, 0.01));
    CHECK(std::abs(moments_of(third).mean) < 0.05);
    CHECK(close_to(static_cast<double>(beyond) / 1e5, 0.0455, 0.05));
    CHECK(close_to(static_cast<double>(happened) / 1e5, 0.2, 0.02));
  }

  TEST_CASE("noise has the deviation that was asked for, and no mean") {
    angles p{};
    p.noise = 0.03;
    const moments m = moments_of(readings(p, 0.5, 20000, 1));
    CHECK(close_to(m.mean, 0.5, 0.002));
    CHECK(close_to(m.deviation, 0.03, 0.02));
  }

  TEST_CASE("a bias and a scale are drawn once for each sensor, with the spread that was asked for") {
    angles p{};
    p.bias = 0.02;
    const auto same = readings(p, 0.5, 100, 3);
    CHECK(moments_of(same).deviation < 1e-15);
    CHECK(std::abs(same[0] - 0.5) > 1e-4);
    CHECK(close_to(moments_of(sensors(p, 0.5, 5000)).deviation, 0.02, 0.05));
    p = {};
    p.scale = 0.1;
    CHECK(close_to(moments_of(sensors(p, 2, 5000)).deviation, 0.2, 0.05));
    CHECK(moments_of(sensors(p, 0, 100)).deviation == 0);
    // Twice the spread is twice as far.
    angles more = p;
    more.scale = 0.2;
    CHECK(close_to(sensors(more, 2, 3)[2] - 2, 2 * (sensors(p, 2, 3)[2] - 2)));
  }

  TEST_CASE("a resolution rounds") {
    angles p{};
    p.resolution = 0.1;
    CHECK(close_to(readings(p, 0.264, 1, 1)[0], 0.3));
    CHECK(close_to(readings(p, -0.26, 1, 1)[0], -0.3));
  }

  TEST_CASE("a lost reading is the last one again") {
    angles p{};
    p.loss = 0.3;
    cca::random_numbers draws(1), noise(2);
    sim::detail::uncertain_channel<1> channel;
    channel.draw(draws);
    double last = -1;
    int lost = 0;
    for (int i = 0; i < 10000; ++i) {
      std::array<double, 1> x{static_cast<double>(i)};
      channel.change(x, p, noise);
      const bool is_last = x[0] == last && i > 0;
      REQUIRE((is_last || x[0] == i));
      lost += is_last, last = x[0];
    }
    CHECK(close_to(lost / 10000.0, 0.3, 0.05));
  }

  TEST_CASE("an orientation is turned by the noise, and stays a unit quaternion") {
    sim::uncertain_orientation p{};
    p.noise = 0.05;
    cca::random_numbers draws(1), noise(2);
    sim::detail::uncertain_channel<4> channel;
    channel.draw(draws);
    std::vector<double> about_x;
    for (int i = 0; i < 5000; ++i) {
      std::array<double, 4> q{0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // a quarter turn about z
      channel.change(q, p, noise);
      const Eigen::Vector4d back(0, 0, -std::sqrt(0.5), std::sqrt(0.5));
      const Eigen::Vector4d now = Eigen::Vector4d::Map(q.data());
      REQUIRE(close_to(now.norm(), 1, 1e-12));
      about_x.push_back(cca::rotation::log<double>(cca::rotation::product(now, back))[0]);
    }
    CHECK(std::abs(moments_of(about_x).mean) < 0.003);
    CHECK(close_to(moments_of(about_x).deviation, 0.05, 0.05));
    p = {};
    p.bias = 0.1;
    std::array<double, 4> a{0, 0, 0, 1}, b = a;
    channel.change(a, p, noise), channel.change(b, p, noise);
    CHECK(a == b);
    CHECK(a[3] < 1);
  }

  TEST_CASE("a delay is whole beats, and the first value lasts until then") {
    sim::detail::delay_line<int, 251> line;
    for (int i = 0; i < 1000; ++i) {
      line.add() = i;
      REQUIRE(line.before(0, 0.001) == i);
      REQUIRE(line.before(0.007, 0.001) == std::max(0, i - 7));
      REQUIRE(line.before(0.0074, 0.001) == std::max(0, i - 7));
      REQUIRE(line.before(0.25, 0.001) == std::max(0, i - 250));
    }
    line.clear();
    line.add() = 5;
    CHECK(line.before(0.1, 0.001) == 5);
  }

  TEST_CASE("masses and ground are drawn with the spread that was asked for") {
    std::vector<double> masses, frictions, slopes, steps;
    for (int seed = 0; seed < 400; ++seed) {
      sim::uncertainty u{};
      u.seed = seed, u.body.mass = 0.1, u.ground.friction = 0.2, u.ground.slope = 0.05;
      const auto s = sim::drawn_settings(u);
      for (int link = -1; link < 10; ++link) masses.push_back(s.body.mass_factor(link));
      CHECK_FALSE(s.body.has_lengths());
      const sim::terrain ground = sim::drawn_ground(u, sim::terrain::flat().with_friction(0.5));
      frictions.push_back(ground.friction());
      slopes.push_back(ground.profile().pitch);
      u.ground.slope = 0, u.ground.step = 0.01;
      steps.push_back(sim::drawn_ground(u).profile().rise);
    }
    CHECK(close_to(moments_of(masses).mean, 1, 0.01));
    CHECK(close_to(moments_of(masses).deviation, 0.1, 0.05));
    CHECK(close_to(moments_of(frictions).deviation, 0.1, 0.1));
    CHECK(close_to(moments_of(slopes).deviation, 0.05, 0.1));
    CHECK(close_to(moments_of(steps).deviation, 0.01, 0.1));
    // The same seed gives the same, and nothing that is not uncertain changes.
    sim::uncertainty u{};
    u.seed = 3;
    CHECK(sim::drawn_ground(u).friction() == sim::terrain::flat().friction());
    CHECK(sim::drawn_settings(u).body.mass == sim::body_factors().mass);
    u.body.mass = 0.1;
    const auto once = sim::drawn_settings(u).body.mass, again = sim::drawn_settings(u).body.mass;
    u.seed = 4;
    CHECK(once == again);
    CHECK(once != sim::drawn_settings(u).body.mass);
  }

  TEST_CASE("what can't be is refused in a sentence") {
    CHECK(refusal([](auto&) {}).empty());
    CHECK(refusal([](auto& u) {
            u.angle.noise = -0.1;
          }).find("angle.noise: -0.1 rad is out of range, expected 0 to") != std::string::npos);
    CHECK(refusal([](auto& u) {
            u.orientation.noise = std::nan("");
          }).find("orientation.noise: nan rad is not allowed") != std::string::npos);
    CHECK(refusal([](auto& u) {
            u.angle.loss = 1.5;
          }).find("angle.loss: 1.5 is out of range, expected 0 to 1") != std::string::npos);
    CHECK(refusal([](auto& u) {
            u.drives.delay = 1;
          }).find("drives.delay: 1 s is out of range, expected 0 to 0.25") != std::string::npos);
    CHECK(refusal([](auto& u) {
            u.battery.resistance = 1;
          }).find("a battery with a resistance needs its open_circuit voltage") != std::string::npos);
    CHECK(refusal([](auto& u) {
            u.ground.slope = 0.1, u.ground.step = 0.01;
          }).find("a ground has a slope or steps, not both") != std::string::npos);
  }
}
