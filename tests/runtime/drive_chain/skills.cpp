// The Combination of Skills on virtual drives: the controller that reaches for a ball in the simulator does
// so over CAN.
#include <string>
#include <type_traits>

#include <doctest/doctest.h>

#include <cca/config.hpp>

#include "../../../examples/combination_of_skills/summary.hpp"
#include "../../../examples/hardware_in_the_loop/on_drives.hpp"

namespace {

namespace hw = cca::hardware;
static_assert(cca::well_formed<hil::skills_on_drives>);

const std::string shape = CCA_EXAMPLES "/combination_of_skills/trot.shape";

}  // namespace

TEST_SUITE("skills on drives") {
  TEST_CASE("the controller that reaches for a ball in the simulator does so on drives, and trots on") {
    hil::skills_in_memory robot;
    hil::load(robot, shape, {});
    skills::circumstances c{
        .seed = 1, .paw = skills::paw_side::left, .where = skills::target::ahead, .push = 0};
    skills::set_seconds(c, 1.5);
    const auto& stop = robot.controller.get<"robot.emergency_stop">();
    bool moved = false;
    const auto r = skills::act(robot, c, [&](const auto&) {
      moved = moved || stop.mode() == hw::motion_mode::run;
      if (moved) REQUIRE(stop.first_cause().rule == hw::safety_rule::none);
    });
    MESSAGE("ball " << r.reach_error * 1e3 << " mm off on average, " << r.worst_error * 1e3 << " at most, in "
                    << r.reach_time << " s; then " << r.speed_after << " m/s");
    CHECK(!r.fell);
    CHECK(r.last == skills::plan::at<"trot on">);
    CHECK(r.reach_error < 0.002);
    CHECK(r.worst_error < 0.005);
    CHECK(r.reach_time < 3);
    CHECK(r.speed_after > 0.2);
    for (std::size_t i = 0; i + 1 < r.skills.size(); ++i) {
      CAPTURE(skills::plan::table[i].name);
      CHECK(r.skills[i].how == skills::outcome::done);
    }
  }

  TEST_CASE(
      "until all drives and the board have reported, nothing is commanded - then motion begins where the "
      "joints are") {
    hil::skills_in_memory robot;
    hil::load(robot, shape, {});
    std::get<5>(robot.far.drives).go_silent(true);
    robot.controller.start();
    const auto& limits = robot.controller.get<"limits">();
    for (int k = 0; k < 100; ++k) REQUIRE(robot.step());
    CHECK(robot.controller.get<"robot.synchronizer">().phase() == hw::motion_phase::enabling);
    std::get<5>(robot.far.drives).clear();
    double jump = 0;
    for (int k = 0; k < 60; ++k) {
      const auto former = robot.laws;
      REQUIRE(robot.step());
      for (std::size_t i = 0; i < 8; ++i)
        if (former[i].stiffness > 0 && robot.laws[i].stiffness > 0)
          jump = std::max(jump, std::abs(robot.laws[i].position - former[i].position));
    }
    CHECK(robot.controller.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    CHECK(limits.first_intervention().cause != cca::limited_by::finite);
    CHECK(jump < 0.01);
  }
}
