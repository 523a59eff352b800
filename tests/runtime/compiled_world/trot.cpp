// The trot of examples/trot on both engines: one program, one report.
#include <doctest/doctest.h>

#include <cmath>
#include <type_traits>

#include <cca/sim/oncilla/compiled_oncilla.hpp>
// Before anything else brings it:
#ifdef _ODE_ODE_H_
#error "the compiled Oncilla includes the engine"
#endif

#include "../../../examples/trot/report/engine.hpp"
#include "../../../examples/trot/report/statistics.hpp"
#include "../../../examples/trot/rollout.hpp"

namespace {

namespace sim = cca::sim;

static_assert(std::is_trivially_copyable_v<sim::compiled_oncilla_world>);

struct compiled_trot : trot::architecture<sim::compiled_oncilla> {};

template <class Architecture>
trot::statistics figures_of(double seconds, const sim::disturbance& d) {
  cca::controller<Architecture> c;
  c.load();
  return trot::evaluate(
      trot::roll_out(c, sim::terrain::flat(), d, seconds, [](const auto&, double) { return true; }));
}

}  // namespace

TEST_SUITE("compiled world: trot") {
  TEST_CASE("on flat ground it trots in both engines, as fast, without a fall, with little slip") {
    const trot::statistics engine = figures_of<trot::simulated_trot>(12, sim::disturbance::none()),
                           compiled = figures_of<compiled_trot>(12, sim::disturbance::none());
    for (const auto& s : {engine, compiled}) {
      MESSAGE("cruise ", s.cruise, " m/s, slip ", s.foot_slip, " m/s, friction ", s.friction_power,
              " W, cost of transport ", s.cost_of_transport, ", drift ", s.drift, " m, strides ",
              s.stride_frequency, " Hz, roll ", s.max_roll, " rad, duty ", s.duty_factor[0], " ",
              s.duty_factor[1], " ", s.duty_factor[2], " ", s.duty_factor[3]);
      CHECK(!s.fell);
      CHECK(s.cruise == doctest::Approx(trot::throttle{}.p.speed).epsilon(0.06));
      CHECK(s.foot_slip > 0.01);
      CHECK(s.foot_slip <= 0.1);
      CHECK(s.stride_frequency == doctest::Approx(4).epsilon(0.01));
    }
    CHECK(compiled.cruise == doctest::Approx(engine.cruise).epsilon(0.05));
    CHECK(compiled.cost_of_transport == doctest::Approx(engine.cost_of_transport).epsilon(0.2));
    CHECK(compiled.friction_power == doctest::Approx(engine.friction_power).epsilon(0.5));
    // Of one foot it depends on how it treads on: of the fore feet, of the hind feet.
    for (const std::size_t i : {0U, 2U})
      CHECK(std::abs(compiled.duty_factor[i] + compiled.duty_factor[i + 1] - engine.duty_factor[i] -
                     engine.duty_factor[i + 1]) < 0.2);
  }

  TEST_CASE("disturbed, too") {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
      const auto s = figures_of<compiled_trot>(20, sim::disturbance::from_seed(seed, 20));
      MESSAGE("seed ", seed, ": cruise ", s.cruise, " m/s, slip ", s.foot_slip, " m/s, drift ", s.drift,
              " m");
      CHECK(!s.fell);
      CHECK(s.cruise >= 0.7);
      CHECK(s.foot_slip <= 0.1);
    }
  }

  TEST_CASE("an Oncilla is put down as in the engine, and falls as there") {
    const sim::initial_posture posture = sim::standing_posture();
    const sim::terrain hill = sim::terrain::slope(0.05, -1);
    sim::compiled_oncilla_world a(hill, posture);
    const sim::world b(hill, posture);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(a.trunk_position()[k] == doctest::Approx(b.trunk_position()[k]));
      CHECK(a.foot_position(2)[k] == doctest::Approx(b.foot_position(2)[k]));
    }
    CHECK(a.hip_height() == doctest::Approx(b.hip_height()));
    CHECK(a.reading().legs[1].knee.angle == b.reading().legs[1].knee.angle);
    CHECK(!a.fallen());
    for (int k = 0; k < 1000; ++k) a.advance({});  // no drive holds it
    CHECK(a.fallen());
  }

  TEST_CASE("the words choose the engine") {
    const char* space[]{"trot", "--seed", "1", "--engine", "compiled"};
    const char* sign[]{"trot", "--engine=compiled"};
    const char* ode[]{"trot", "--engine", "ode"};
    const char* none[]{"trot", "--seed", "1"};
    const char* other[]{"trot", "--engine", "bullet"};
    CHECK(trot::engine_in(5, space) == trot::engine::compiled);
    CHECK(trot::engine_in(2, sign) == trot::engine::compiled);
    CHECK(trot::engine_in(3, ode) == trot::engine::ode);
    CHECK(trot::engine_in(3, none) == trot::engine::ode);
    CHECK(trot::engine_in(3, other) == trot::engine::ode);  // refused when the options are read
    CHECK(trot::engine_in(2, other) == trot::engine::ode);
  }
}
