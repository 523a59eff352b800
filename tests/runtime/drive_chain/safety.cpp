// The safety chain around the trot on virtual drives: what trips it, what it records, and how motion comes
// back.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include <doctest/doctest.h>

#include <cca/config.hpp>

#include "../../../examples/hardware_in_the_loop/campaign_run.hpp"

namespace laws {
std::size_t allocations();
}

namespace {

namespace hw = cca::hardware;

template <class Run>
void go(Run& run, int beats) {
  for (int k = 0; k < beats; ++k) run.step();
}

// A run that has trotted for 500 beats: the next beat has the index 500.
template <class Architecture = hil::trot_on_drives>
struct trotting : hil::in_memory<Architecture> {
  trotting() {
    this->controller.load();
    this->controller.start();
    go(*this, 500);
    REQUIRE(stop().mode() == hw::motion_mode::run);
  }
  auto& stop() { return this->controller.template get<"robot.emergency_stop">(); }
  auto& synchronizer() { return this->controller.template get<"robot.synchronizer">(); }
};

void is(const hw::safety_event& cause, hw::safety_rule rule, int joint, std::int64_t beat) {
  CHECK(cause.rule == rule);
  CHECK(cause.joint == joint);
  CHECK(cause.beat == beat);
}

}  // namespace

TEST_SUITE("safety chain") {
  TEST_CASE("nothing is enabled, and nothing moves, before the controller is started") {
    hil::in_memory<> run;
    run.controller.load();
    for (int k = 0; k < 50; ++k) run.step(false);
    CHECK(!std::get<0>(run.far.drives).enabled());
    for (const auto& w : run.wires) CHECK(const_cast<hw::virtual_bus&>(w).end(0).counters().sent == 0);
  }

  TEST_CASE("a start makes no jump: each joint begins where it is") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    auto before = run.plant.motions();
    double fastest = 0;
    for (int k = 0; k < 150; ++k) {  // the gait waits for 0.2 s
      run.step();
      const auto now = run.plant.motions();
      for (std::size_t i = 0; i < 8; ++i) fastest = std::max(fastest, std::abs(now[i].torque));
      before = now;
    }
    CHECK(fastest < 5);
    CHECK(run.controller.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
  }

  TEST_CASE("a silent drive: all are damped, the first cause is kept, and only a start leads back") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    go(run, 500);
    auto& stop = run.controller.get<"robot.emergency_stop">();
    REQUIRE(stop.mode() == hw::motion_mode::run);
    std::get<2>(run.far.drives).go_silent(true);
    go(run, 10);
    CHECK(stop.mode() == hw::motion_mode::damped);
    CHECK(stop.first_cause().rule == hw::safety_rule::silent);
    CHECK(stop.first_cause().joint == 2);
    CHECK(stop.first_cause().beat >= 500);
    CHECK(stop.first_cause().beat <= 504);
    for (const auto& law : run.laws) {
      CHECK(law.stiffness == 0);
      CHECK(std::abs(law.velocity) < 0.02);
    }
    std::get<2>(run.far.drives).clear();
    go(run, 300);
    CHECK(stop.mode() == hw::motion_mode::damped);  // the cause is gone, but nobody has started it
    const auto first = stop.first_cause();
    std::get<4>(run.far.drives).fail(0xB);
    go(run, 10);
    CHECK(stop.first_cause().rule == first.rule);  // the first one stays
    std::get<4>(run.far.drives).clear();
    run.controller.get<"robot.synchronizer">().start();
    go(run, 50);
    CHECK(stop.mode() == hw::motion_mode::run);
    CHECK(stop.first_cause().rule == hw::safety_rule::none);
  }

  TEST_CASE("a sensor board that is silent or faulty trips by its own rule, and no joint is named") {
    trotting<> silent;
    silent.far.board_silent = true;
    go(silent, 11);  // in the first beat its last frames are still on the way
    CHECK(silent.stop().mode() == hw::motion_mode::run);
    go(silent, 1);
    is(silent.stop().first_cause(), hw::safety_rule::sensor_board, -1, 511);
    CHECK(hw::name_of(hw::safety_rule::sensor_board) == "sensor board");
    go(silent, 2);
    CHECK(silent.stop().mode() == hw::motion_mode::damped);
    for (const auto& law : silent.laws) CHECK(law.stiffness == 0);

    trotting<> faulty;
    faulty.far.board_silent = true;  // the test sends in its place
    auto reading = faulty.plant.board();
    reading.status = 1;
    faulty.wires[4].end(2).send(hil::board::frames(reading, 0));
    go(faulty, 2);
    is(faulty.stop().first_cause(), hw::safety_rule::sensor_board, -1, 501);
  }

  TEST_CASE("a drive that reports a jump: after three answers it trips") {
    trotting<> run;
    auto& drive = std::get<6>(run.far.drives);
    const double told = run.synchronizer().report(6).position;
    REQUIRE(std::abs(told) > 0.2);
    drive.hear(hw::mit_special_frame(hil::left_hind_knee::drive::request_id, hw::mit_special::set_zero),
               run.now);
    drive.answer({.position = told});  // the answer to a frame of the test
    go(run, 3);
    CHECK(run.stop().mode() == hw::motion_mode::run);
    CHECK(run.synchronizer().report(6).position ==
          doctest::Approx(told).epsilon(0.1));  // the jump is not taken for a motion
    go(run, 1);
    is(run.stop().first_cause(), hw::safety_rule::implausible, 6, 503);
    CHECK(run.stop().mode() == hw::motion_mode::damped);
  }

  TEST_CASE("a start without a drive or without the board: it is given up and reported, and nothing moves") {
    for (const bool of_drive : {true, false}) {
      CAPTURE(of_drive);
      hil::in_memory<> run;
      const auto& drives = run.controller.get<"robot.synchronizer">();
      const auto& stop = run.controller.get<"robot.emergency_stop">();
      if (of_drive) std::get<3>(run.far.drives).go_silent(true);
      else run.far.board_silent = true;
      run.controller.load();
      run.controller.start();
      bool moved = false;
      for (int k = 0; k < 1000; ++k) {
        CHECK(drives.refusal() == hw::safety_rule::none);
        run.step();
        for (const auto& law : run.laws) moved = moved || law.stiffness != 0;
        if (k < 999) CHECK(drives.phase() == hw::motion_phase::enabling);
      }
      CHECK(drives.phase() == hw::motion_phase::stopped);
      CHECK(drives.refusal() == hw::safety_rule::enabling);
      CHECK_FALSE(moved);
      CHECK(stop.mode() == hw::motion_mode::damped);
      is(stop.first_cause(), hw::safety_rule::none, -1,
         -1);  // it did not run, so nothing stopped it
      go(run, 2);
      CHECK(!std::get<0>(run.far.drives).enabled());
      std::get<3>(run.far.drives).clear();
      run.far.board_silent = false;
      run.controller.get<"robot.synchronizer">().start();
      go(run, 50);
      CHECK(drives.refusal() == hw::safety_rule::none);
      CHECK(drives.phase() == hw::motion_phase::running);
      CHECK(stop.mode() == hw::motion_mode::run);
    }
  }

  TEST_CASE("commands from old data: a soft stop once they are older than 50 ms") {
    trotting<hil::limited<cca::latest>> run;
    run.controller.get<"saboteur">().stuck = true;
    go(run, 40);
    CHECK(run.stop().mode() == hw::motion_mode::run);
    go(run, 11);  // they are made from the posture, which is read each 10 beats
    CHECK(run.stop().mode() == hw::motion_mode::soft);
    const auto cause = run.stop().first_cause();
    is(cause, hw::safety_rule::stale, -1, std::clamp<std::int64_t>(cause.beat, 540, 550));
    const auto& guard = run.controller.get<"robot.stale">().record();
    is(guard.first, hw::safety_rule::stale, -1, cause.beat);
  }

  TEST_CASE("a command that is NaN, where no limiter holds it: a soft stop in the same beat") {
    trotting<hil::unlimited<cca::latest>> run;
    run.controller.get<"saboteur">().not_a_number = true;
    go(run, 1);
    is(run.stop().first_cause(), hw::safety_rule::not_finite, 2, 500);
    CHECK(run.stop().mode() == hw::motion_mode::soft);
    is(run.controller.get<"robot.finite">().record().first, hw::safety_rule::not_finite, 2, 500);
    for (const auto& law : run.laws) CHECK(std::isfinite(law.position));
  }

  TEST_CASE("somebody else sends our frames: all are damped in the beat in which the bus reports it") {
    trotting<> run;
    // tests/runtime/hardware/socket_can.cpp tests how a socket counts them. A bus in memory does not.
    ++const_cast<hw::bus_counters&>(run.wires[1].end(0).counters()).intruders;
    go(run, 1);
    is(run.stop().first_cause(), hw::safety_rule::link, -1, 500);
    CHECK(run.stop().mode() == hw::motion_mode::damped);
    CHECK(run.synchronizer().link(1).first_cause() == hw::link_cause::intruder);
    CHECK(run.synchronizer().link(0).first_cause() == hw::link_cause::none);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);
  }

  TEST_CASE(
      "a set point that would come too late is dropped: two in a row are lost, the third is the link's "
      "fault") {
    trotting<> run;
    auto near = run.wires[0].end(0);
    const std::array<hw::can_frame, 1> waiting{{{.id = hw::standard(0x7FF), .length = 8}}};
    const auto with_one_waiting = [&] {
      const auto before = near.counters().sent;
      near.send(waiting);
      run.step();
      return near.counters().sent - before - 1;
    };
    for (const int in_a_row : {1, 2}) {
      for (int k = 0; k < in_a_row; ++k) CHECK(with_one_waiting() == 0);
      go(run, 10);
      CHECK(run.stop().mode() == hw::motion_mode::run);
    }
    CHECK(run.synchronizer().link(0).dropped_batches() == 3);
    for (int k = 0; k < 3; ++k) CHECK(with_one_waiting() == 0);
    CHECK(run.stop().mode() == hw::motion_mode::run);
    go(run, 1);
    is(run.stop().first_cause(), hw::safety_rule::link, -1, 526);  // 523 to 525 were full
    CHECK(run.stop().mode() == hw::motion_mode::damped);
    CHECK(run.synchronizer().link(0).first_cause() == hw::link_cause::queue_full);
  }

  TEST_CASE("the pressed emergency stop outlasts a start") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    go(run, 300);
    auto& stop = run.controller.get<"robot.emergency_stop">();
    stop.press();
    go(run, 2);
    CHECK(stop.mode() == hw::motion_mode::damped);
    run.controller.get<"robot.synchronizer">().start();
    go(run, 100);
    CHECK(stop.mode() == hw::motion_mode::damped);
    CHECK(stop.first_cause().rule == hw::safety_rule::pressed);
    stop.release();
    go(run, 50);
    CHECK(stop.mode() == hw::motion_mode::damped);
    run.controller.get<"robot.synchronizer">().start();
    go(run, 50);
    CHECK(stop.mode() == hw::motion_mode::run);
  }

  TEST_CASE("a soft stop holds, gets softer, and ends damped") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    go(run, 1000);
    run.controller.get<"robot.emergency_stop">().stop_softly();
    go(run, 2);
    const double begun = run.laws[0].stiffness;
    CHECK(begun > 5);
    go(run, 50);
    CHECK(run.laws[0].stiffness < 0.7 * begun);
    go(run, 60);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);
    CHECK(run.laws[0].damping == doctest::Approx(1).epsilon(0.01));
  }

  TEST_CASE(
      "a link that was away for a beat: no command goes out until the start, which begins where the joints "
      "are") {
    std::array<hw::bus_fault, 1> script{
        {{.what = hw::bus_trouble::link_down, .from = 600'000'000, .until = 600'400'000, .end = 0}}};
    hil::in_memory<> run(script);
    run.controller.load();
    run.controller.start();
    go(run, 1000);
    CHECK(run.controller.get<"robot.emergency_stop">().first_cause().rule == hw::safety_rule::link);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);

    run.controller.stop();
    run.controller.start();
    const auto& drives = run.controller.get<"robot.synchronizer">();
    while (drives.phase() != hw::motion_phase::running && run.now < 1'200'000'000) run.step();
    REQUIRE(drives.phase() == hw::motion_phase::running);
    for (std::size_t i = 0; i < 4; ++i) {
      CHECK(run.laws[i].stiffness > 0);
      CHECK(std::abs(run.laws[i].position - run.plant.motions()[i].position) < 0.05);
    }
    go(run, 2500);
    CHECK(run.controller.get<"robot.emergency_stop">().mode() == hw::motion_mode::run);
  }

  TEST_CASE("after another node's frames waits one batch at most, and the damping frames come last") {
    hil::in_memory<> run({}, false);  // controllers that repeat frames
    run.controller.load();
    run.controller.start();
    go(run, 500);
    const auto& stop = run.controller.get<"robot.emergency_stop">();
    REQUIRE(stop.mode() == hw::motion_mode::run);
    auto near = run.wires[0].end(0), other = run.wires[0].end(2);
    std::array<hw::can_frame, 8> noise;
    noise.fill({.id = hw::standard(0), .length = 8});
    for (int k = 0; k < 100; ++k) {
      other.send(noise);
      run.step();
      // Two drives on this bus: their set points, then the frames that damp them, once.
      CHECK(near.in_flight() <= (stop.mode() == hw::motion_mode::run ? 2 : 4));
      if (k >= 3) CHECK(stop.mode() == hw::motion_mode::damped);
    }
    go(run, 10);
    CHECK(near.in_flight() == 0);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);
    run.controller.stop();
    run.controller.start();
    go(run, 100);
    CHECK(stop.mode() == hw::motion_mode::run);
  }

  TEST_CASE("a fault of the controller damps in the same beat, and resuming alone moves nothing") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    go(run, 500);
    run.controller.get<"robot.synchronizer">().on_fault();
    run.step(false);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);
    go(run, 100);
    for (const auto& law : run.laws) CHECK(law.stiffness == 0);
  }

  TEST_CASE("the campaign's counter works: it sees a set point beyond its limits") {
    hil::in_memory<hil::limited<cca::latest>> run;
    run.controller.load();
    run.controller.start();
    hil::spy watcher;
    for (int k = 0; k < 300; ++k) run.step(), watcher.look(run);
    CHECK(watcher.sent > 2000);
    CHECK(watcher.outside == 0);
    using hip = hil::left_front_hip;
    const auto wild = hip::drive::set_point(hip::to_drive({.position = 2, .stiffness = 30, .damping = 0.4}));
    run.wires[0].end(0).send(wild.frames);
    run.step(), watcher.look(run);
    CHECK(watcher.outside == 1);
  }

  TEST_CASE("a calibration file: offsets of the joints, checked at load") {
    const auto path =
        std::filesystem::temp_directory_path() / ("cca_calibration_" + std::to_string(::getpid()) + ".toml");
    const auto file = [&](const char* first) {
      std::ofstream(path)
          << "[robot.synchronizer]\noffset = [\"" << first
          << "\", \"0 deg\", \"0 deg\", \"0 deg\", \"0 deg\", \"0 deg\", \"0 deg\", \"0 deg\"]\n";
      return path.string();
    };
    hil::in_memory<> run;
    CHECK_THROWS_WITH_AS(run.controller.load(file("90 deg")), doctest::Contains("offset"), cca::refused);
    run.controller.load(file("-4 deg"));
    std::filesystem::remove(path);
    run.controller.start();
    go(run, 50);
    REQUIRE(run.controller.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    // Its position is reported with the offset, and its command leads back to where it is.
    const double degree = cca::sim::degrees(1);
    const auto& report = run.controller.get<"robot.synchronizer">().report(0);
    CHECK(hil::left_front_hip::angle_of(report.position) ==
          doctest::Approx(run.plant.motions()[0].position).epsilon(0.01));
    CHECK(std::abs(run.laws[0].position - (hil::front_stance.hip + 4 * degree)) < 1 * degree);
  }

  TEST_CASE("a beat allocates nothing, while moving, tripping or damped") {
    hil::in_memory<> run;
    run.controller.load();
    run.controller.start();
    std::size_t allocated = 0;
    for (int k = 0; k < 400; ++k) {
      if (k == 200) std::get<3>(run.far.drives).go_silent(true);
      const std::size_t before = laws::allocations();
      run.controller.step();
      allocated += laws::allocations() - before;
      run.step(false);
    }
    CHECK(allocated == 0);
    CHECK(run.controller.get<"robot.emergency_stop">().first_cause().rule == hw::safety_rule::silent);
  }

  TEST_CASE("the most important rows of the campaign") {
    using scenario = hil::scenario<hil::limited<cca::latest>>;
    const auto off =
        hil::run(scenario{.fault = "bus off", .script = {{.what = hw::bus_trouble::bus_off, .end = 0}}});
    CHECK(off.good());
    const auto stalled = hil::run(scenario{.fault = "stalled", .beats = 10, .stands_still = 10});
    CHECK(stalled.good());
    CHECK(stalled.first_cause == "stalled");
    CHECK(stalled.beats_to_detect == 4);  // by the drives' watchdogs
    const auto killed = hil::run(scenario{.fault = "killed", .beats = 1, .killed = true});
    CHECK(killed.good());
    CHECK(killed.beats_to_detect == 4);
  }

  TEST_CASE("a run that goes on is compared with a run without the fault") {
    using scenario = hil::scenario<hil::limited<cca::latest>>;
    const auto warned =
        hil::run(scenario{.fault = "warning", .script = {{.what = hw::bus_trouble::warning, .end = 0}}});
    CHECK(warned.good());
    CHECK(warned.beats_to_detect == -1);
    CHECK(warned.max_excursion == 0);
    const auto late = hil::run(scenario{.fault = "stalled", .beats = 1, .stands_still = 1});
    CHECK(late.good());
    CHECK(late.beats_to_detect == -1);
    CHECK(late.max_excursion > 0.001);
    CHECK(late.max_excursion < 0.5);
  }
}
