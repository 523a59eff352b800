// The limiter: for any input its output is finite, within the limits, and changes no faster than allowed.
#include <doctest/doctest.h>

#include <bit>
#include <random>

#include "joints.hpp"

using namespace robot_test;

namespace {

// Calls a limiter directly, beat by beat.
template <class Space>
struct bench {
  using vector = typename Space::vector_type;
  cca::limiter<Space> under_test;
  std::int64_t k = 0;

  vector operator()(const vector& command, std::int64_t beats_since = 1, bool fresh = true) {
    return give(command, cca::optional_in<"measured", Space>(), beats_since, fresh);
  }
  vector operator()(const vector& command, const vector& measured, bool fresh = true) {
    cca::optional_in<"measured", Space> port(measured, k * millisecond, true);
    port.set_wired();
    return give(command, port, 1, fresh);
  }

private:
  vector give(const vector& command,
              const cca::optional_in<"measured", Space>& measured,
              std::int64_t beats_since,
              bool fresh) {
    const cca::in<"command", Space> port(command, fresh ? k * millisecond : cca::never, fresh);
    const vector safe = under_test.process(port, measured, cca::beat{k, millisecond, beats_since}).vector();
    ++k;
    return safe;
  }
};

// The header's definition, computed slowly: the allowed number nearest to the command.
template <class Space>
double expected(int axis, double command, double last, double dt) {
  using quantity = typename Space::domain::quantity;
  const auto at = static_cast<std::size_t>(axis);
  double low = cca::detail::lower_limits<Space, quantity>[at],
         high = cca::detail::upper_limits<Space, quantity>[at];
  double goal = command;
  const bool stays = std::is_same_v<quantity, cca::angle> || std::is_same_v<quantity, cca::stiffness>;
  if (!std::isfinite(command)) goal = stays ? last : 0;
  double most_down = -inf, most_up = inf;
  if (axis == 0 && std::is_same_v<quantity, cca::angle>) most_down = -5, most_up = 4;
  if (axis == 0 && std::is_same_v<quantity, cca::velocity>) most_down = -50, most_up = 40;
  if (axis == 0 && std::is_same_v<quantity, cca::torque>) most_down = -100, most_up = 200;
  low = std::max(low, last + most_down * dt);
  high = std::min(high, last + most_up * dt);
  REQUIRE_LE(low, high);
  return std::min(std::max(goal, low), high);
}

template <class Space>
void sweep() {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> near(-4, 4);
  const std::array<double, 12> odd{no_number, -no_number, inf,   -inf,   0.0, -0.0,
                                   5e-324,    -5e-324,    1e308, -1e308, 0.8, -1.8};
  bench<Space> limit;
  typename Space::vector_type last = limit({0.5, 1});
  CHECK(cca::sample<Space>(last).within_limits());
  std::int64_t changed = limit.under_test.interventions();
  for (int i = 0; i < 20000; ++i) {
    typename Space::vector_type command;
    for (int a = 0; a < 2; ++a)
      command[a] = random() % 4 == 0 ? odd[random() % odd.size()]
                   : random() % 2    ? near(random)
                                     : last[a] + 1e-3 * near(random);
    const auto safe = limit(command);
    for (int a = 0; a < 2; ++a) {
      CAPTURE(command[a]);
      CAPTURE(last[a]);
      CHECK_EQ(safe[a], expected<Space>(a, command[a], last[a], 1e-3));
      changed += safe[a] != command[a];
    }
    REQUIRE(cca::sample<Space>(safe).within_limits());
    last = safe;
  }
  CHECK_EQ(limit.under_test.interventions(), changed);
  CHECK_GT(changed, 10000);
}

// [limiter]
struct reckless {  // commands more than the hip can do, and NaN once
  auto process(cca::beat now) -> cca::out<"angles", leg_angles> {
    if (now.index() == 70) return leg_angles::vector_type{no_number, -1};
    return leg_angles::vector_type{0.1 + 0.01 * static_cast<double>(now.index()), -1};
  }
};

struct careful : cca::graph<cca::node<"gait", reckless>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"leg", perfect_leg>,
                            cca::wire<"gait.angles", "limits.command">,
                            cca::wire<"leg.angles", "limits.measured">,  // it begins where the leg is
                            cca::wire<"limits.safe", "leg.command">> {};
// [limiter end]

struct torque_leg {
  void act(cca::in<"command", leg_torques> to) { at = to.vector(); }
  leg_torques::vector_type at{};
};
struct pusher {
  auto process() -> cca::out<"torques", leg_torques> { return leg_torques::vector_type{0, 0}; }
};
struct as_it_is : cca::graph<cca::node<"pusher", pusher>,
                             cca::node<"off", cca::unlimited<leg_torques>>,
                             cca::node<"leg", torque_leg>,
                             cca::wire<"pusher.torques", "off.command">,
                             cca::wire<"off.safe", "leg.command">> {};
struct bare : cca::graph<cca::node<"pusher", pusher>,
                         cca::node<"leg", torque_leg>,
                         cca::wire<"pusher.torques", "leg.command">> {};
static_assert(cca::well_formed<as_it_is>);
static_assert(cca::diagnosis<bare>.rule == "robot.unlimited_command");

}  // namespace

TEST_SUITE("limiter") {
  TEST_CASE("for any input the output is the nearest allowed number") {
    SUBCASE("angles") { sweep<leg<cca::joint_angles>>(); }
    SUBCASE("velocities") { sweep<hip_and_wheel>(); }
    SUBCASE("torques") { sweep<leg<cca::joint_torques>>(); }
    SUBCASE("stiffness") { sweep<leg<cca::joint_stiffness>>(); }
  }

  TEST_CASE("NaN and infinity: an angle keeps its last value") {
    bench<leg_angles> limit;
    limit({0.3, -1});
    for (const double lost : {no_number, inf, -inf}) CHECK_EQ(limit({lost, lost}), Eigen::Vector2d(0.3, -1));
    CHECK_EQ(limit({no_number, -1.2}), Eigen::Vector2d(0.3, -1.2));
    CHECK_EQ(limit.under_test.interventions(), 7);
    CHECK(limit.under_test.first_intervention().cause == cca::limited_by::finite);
    CHECK_EQ(limit.under_test.first_intervention().axis, 0);
    CHECK_EQ(limit.under_test.first_intervention().beat, 1);
  }

  TEST_CASE("NaN: a torque goes to zero as fast as allowed") {
    bench<leg_torques> limit;
    limit({1, 1});
    CHECK_EQ(limit({no_number, no_number}),
             Eigen::Vector2d(0.9, 0));  // the hip falls at 100 N m/s, the knee has no rate limit
    CHECK_EQ(limit({no_number, no_number}), Eigen::Vector2d(0.9 - 0.1, 0));
  }

  TEST_CASE("NaN as first command: the allowed numbers nearest to zero, or the measurement") {
    bench<leg_angles> limit, informed;
    CHECK_EQ(limit({no_number, inf}), Eigen::Vector2d(0, -0.2));
    CHECK_EQ(informed({no_number, inf}, {0.3, -1}), Eigen::Vector2d(0.3, -1));
  }

  TEST_CASE("a measurement counts once it has arrived, and before that the first command is taken as it is") {
    cca::limiter<leg_angles> limit;
    cca::optional_in<"measured", leg_angles> none;
    none.set_wired();
    const auto after = [&](const Eigen::Vector2d& command, std::int64_t k) {
      return limit.process({command, k * millisecond, true}, none, cca::beat{k, millisecond, 1}).vector();
    };
    CHECK_EQ(after({0.5, -1.2}, 0), Eigen::Vector2d(0.5, -1.2));
    CHECK(limit.interventions() == 0);
  }

  TEST_CASE("an allowed command passes unchanged, bit for bit") {
    bench<leg_torques> limit;
    for (const double small : {5e-324, -5e-324, -0.0, 0.0, 1e-310}) {
      const auto safe = limit({small, small});
      CHECK_EQ(std::bit_cast<std::uint64_t>(safe[0]), std::bit_cast<std::uint64_t>(small));
      CHECK_EQ(std::bit_cast<std::uint64_t>(safe[1]), std::bit_cast<std::uint64_t>(small));
    }
    CHECK_EQ(limit.under_test.interventions(), 0);
    CHECK(limit.under_test.first_intervention().cause == cca::limited_by::nothing);
    bench<leg_angles> edges;
    CHECK_EQ(edges({0.8, -0.2}), Eigen::Vector2d(0.8, -0.2));
    CHECK_EQ(edges.under_test.interventions(), 0);
  }

  TEST_CASE("the first cause is kept, with axis and beat") {
    bench<leg_angles> limit;
    limit({0.1, -1});
    limit({0.1 + 0.004, -1});
    CHECK_EQ(limit.under_test.interventions(), 0);
    limit({0.5, -1});
    limit({no_number, 1});
    CHECK_EQ(limit.under_test.interventions(), 3);
    CHECK(limit.under_test.first_intervention().cause == cca::limited_by::rate);
    CHECK_EQ(limit.under_test.first_intervention().axis, 0);
    CHECK_EQ(limit.under_test.first_intervention().beat, 2);

    bench<leg_angles> far;  // too far and too fast: the cause is the range
    far({0.1, -1});
    far({7, -1});
    CHECK(far.under_test.first_intervention().cause == cca::limited_by::range);
    bench<leg_angles> other;
    other({0, 1});
    CHECK_EQ(other.under_test.first_intervention().axis, 1);
  }

  TEST_CASE("the rate counts from the last safe command, not from the measurement") {
    bench<leg_angles> limit;
    limit({0, -1}, {0, -1});
    for (int i = 1; i <= 100; ++i)
      CHECK_EQ(limit({0.8, -1}, {0, -1})[0], doctest::Approx(0.004 * i));  // the joint is stuck
  }

  TEST_CASE("it begins where the joint is, and stays there until the first command") {
    bench<leg_angles> limit;
    CHECK_EQ(limit({0, 0}, {0.5, -1}, false), Eigen::Vector2d(0.5, -1));
    CHECK_EQ(limit({0, 0}, {0.4, -1.1}, false), Eigen::Vector2d(0.4, -1.1));  // moved by hand
    CHECK_EQ(limit.under_test.interventions(), 0);
    CHECK_EQ(limit({-0.5, -1}, {0.4, -1.1}), Eigen::Vector2d(0.4 - 0.005, -1));
    bench<leg_angles> outside;  // pushed beyond its range
    CHECK_EQ(outside({0, -1}, {1.5, -1}), Eigen::Vector2d(0.8 - 0.005, -1));
    bench<leg_angles> blind;  // a broken sensor counts as none
    CHECK_EQ(blind({0.5, -1}, {no_number, -1}), Eigen::Vector2d(0.5, -1));
  }

  TEST_CASE("after a pause it continues without a jump") {
    bench<leg_angles> limit;  // 1 kHz
    limit({0, -1});
    CHECK_EQ(limit({0.8, -1}, 500)[0], 0.004);
    struct slow : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
    bench<slow> unstated;
    unstated({0, -1});
    CHECK_EQ(unstated({0.8, -1}, 10)[0],
             0.04);  // the space has no rate: the time since the last firing counts
  }

  TEST_CASE("in zero time an axis with a rate limit stays, and one without may jump") {
    bench<leg_angles> limit;
    limit({0.3, -1});
    CHECK_EQ(limit({0.8, -1.5}, 0), Eigen::Vector2d(0.3, -1.5));
    CHECK_EQ(limit({0.3, 1}, 0), Eigen::Vector2d(0.3, -0.2));
    CHECK_EQ(limit({no_number, no_number}, 0), Eigen::Vector2d(0.3, -0.2));
  }

  TEST_CASE("a quantity of one's own: its `rate` says which limits bound its change") {
    bench<tank_level> limit;
    using level = tank_level::vector_type;
    CHECK_EQ(limit(level(5))[0], 5);
    CHECK_EQ(limit(level(9))[0], doctest::Approx(5.03));
    CHECK_EQ(limit(level(0))[0], doctest::Approx(5.01));
    CHECK(limit.under_test.first_intervention().cause == cca::limited_by::rate);
  }

  TEST_CASE("in a loop") {
    cca::controller<careful> c;
    c.load();
    c.start();
    double before = 0.1;
    c.run(cca::for_beats<200>{}, cca::as_fast_as_possible{}, [&](auto& running) {
      const double hip_angle = running.template get<"leg">().at[0];
      CHECK_LE(hip_angle - before, 0.004 + 1e-15);  // the gait commands 10 rad/s, the hip allows 4
      CHECK_LE(hip_angle, 0.8);
      before = hip_angle;
    });
    CHECK_EQ(before, 0.8);
    CHECK(c.get<"limits">().first_intervention().cause == cca::limited_by::rate);
    CHECK_EQ(c.get<"limits">().first_intervention().beat, 1);
    CHECK_GT(c.get<"limits">().interventions(), 190);

    // After a stop and a start it begins where the leg is then.
    c.stop();
    c.get<"leg">().at[0] = -0.5;
    c.start();
    CHECK_EQ(c.get<"limits">().interventions(), 0);
    c.step();
    CHECK_EQ(c.get<"leg">().at[0], -0.5 + 0.004);
  }
}
