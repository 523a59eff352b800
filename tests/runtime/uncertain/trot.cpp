// The trot of a robot that differs from its description (examples/trot/uncertain.hpp): what is drawn, and
// that all of it comes to the run.
#include <doctest/doctest.h>

#include <algorithm>
#include <tuple>

#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../../../examples/trot/engines/any.hpp"
#include "../../../examples/trot/report/statistics.hpp"
#include "../../../examples/trot/uncertain.hpp"

namespace {

namespace sim = cca::sim;

struct plain_trot : trot::architecture<sim::compiled_oncilla> {};
using uncertain_controller = cca::controller<trot::uncertain_trot<sim::compiled_oncilla_world>>;

constexpr double seconds = 3;
const sim::disturbance disturbed = sim::disturbance::from_seed(5, seconds);
const sim::terrain hill = sim::terrain::slope(0.05, 0.2);

constexpr auto to_its_end = [](const auto&, double) { return true; };

auto bits(const trot::recording& run) {
  const trot::moment& last = run.moments.back();
  return std::tuple{run.moments.size(), last.position, run.work, run.feet[0].slip, run.feet[3].load};
}

auto rolled = [](auto& c, const auto& ground, const auto& disturbance, const auto& settings) {
  return bits(trot::roll_out(c, ground, disturbance, seconds, to_its_end, settings));
};

auto run_with(const sim::uncertainty& u) {
  uncertain_controller c;
  c.load();
  return trot::on_drawn_ground(c, u, disturbed, hill, rolled);
}

}  // namespace

TEST_SUITE("uncertain: trot") {
  TEST_CASE("with nothing uncertain it has the bits of the robot as described") {
    cca::controller<plain_trot> c;
    c.load();
    const auto plain = bits(trot::roll_out(c, hill, disturbed, seconds, to_its_end));
    CHECK(std::get<0>(plain) > 500);
    CHECK(run_with({}) == plain);
    CHECK(run_with(trot::uncertainty_of(7, 0)) == plain);
  }

  TEST_CASE("a number has its own robot and ground, the same each time") {
    const auto one = run_with(trot::drawn_uncertainty(7));
    CHECK(run_with(trot::drawn_uncertainty(7)) == one);
    CHECK(run_with(trot::drawn_uncertainty(8)) != one);
    sim::uncertainty as_another = trot::drawn_uncertainty(7);
    as_another.seed = 8;
    CHECK(run_with(as_another) != one);
  }

  TEST_CASE("the share is drawn between none and all") {
    double least = 1, most = 0;
    for (std::uint64_t number = 0; number < 100; ++number) {
      const double share = trot::drawn_uncertainty(number).ground.friction / 0.15;
      least = std::min(least, share), most = std::max(most, share);
    }
    CHECK(least >= 0);
    CHECK(least < 0.1);
    CHECK(most > 0.9);
    CHECK(most <= 1);
  }

  TEST_CASE("sensors, drives, ground and body of the run are as drawn") {
    const sim::uncertainty u = trot::uncertainty_of(7, 1);
    uncertain_controller c;
    c.load();
    const auto looked = [&](auto& begun, const auto& ground, const auto& disturbance, const auto& settings) {
      const auto& p = begun.template get<"robot.simulator">().p;
      CHECK(p.seed == 7);
      CHECK(p.drives.delay == u.drives.delay);
      CHECK(p.orientation.noise == u.orientation.noise);
      CHECK(ground.friction() != disturbed.friction);
      CHECK(ground.friction() == doctest::Approx(disturbed.friction).epsilon(0.5));
      CHECK(disturbance.friction == ground.friction());
      CHECK(disturbance.pushes[1].force == disturbed.pushes[1].force);
      CHECK(ground.name() == hill.name());
      CHECK(settings.body.mass == sim::drawn_settings(u).body.mass);
      CHECK(settings.body.mass != sim::robot_world_settings{}.body.mass);
      return true;
    };
    CHECK(trot::on_drawn_ground(c, u, disturbed, hill, looked));
  }
}
