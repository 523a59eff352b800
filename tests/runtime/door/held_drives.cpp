// A robot on virtual drives, whose drive fails: who looks through the door is told why, mends it, and starts.
#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include <cca/cca.hpp>
#include <cca/door.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/main.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robot/watchdog.hpp>

#include "../programs/child.hpp"
#include "../robot_on_drives/torque_pendulum.hpp"
#include "client.hpp"
#include "where_in.hpp"

using door_test::client;
using door_test::json;
using programs_test::child;

namespace {

using namespace pendulum_test;

struct on_drive : hw::robot<pendulum, hw::virtual_bus_end, swing_joint> {};

// Its command is made from what the drive measures: while the drive is silent there is none.
struct damper {
  auto process(cca::in<"angle", robots::angles<pendulum>> angle) -> cca::out<"torque", torque> {
    return -0.1 * angle.vector()[0];
  }
};
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"damper", damper>,
                                 cca::node<"watchdog", cca::watchdog<torque, 100>>,
                                 cca::node<"limits", cca::unlimited<torque>>,
                                 cca::node<"robot", on_drive>,
                                 cca::wire<"robot.angles", "damper.angle">,
                                 cca::wire<"damper.torque", "watchdog.command">,
                                 cca::wire<"watchdog.fresh", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">>,
                      cca::recordable {};

// The drive is in this process; a client can pull its cable, and break it.
struct on_bus : cca::robot_program<architecture> {
  on_bus() {
    settings.seconds = 60;
    settings.quiet = true;
    offers.push_back({.name = "pull",
                      .help = "pulls the cable of the drive",
                      .begin = [this](controller_type&, auto) { far.drive<swing>().go_silent(true); },
                      .end = [this](controller_type&) { plug_in(); }});
    offers.push_back({.name = "break", .begin = [this](controller_type&, auto) {
                        far.drive<swing>().fail(0x2310);  // overcurrent
                      }});
    far.plant.put_at<swing>(0.3);
  }
  void prepare(controller_type& c) override { far.connect(c.get<"robot.synchronizer">()); }
  void started(controller_type&) override { say("started\n"); }
  bool between(controller_type& c) override { return pass(c), true; }
  void rests(controller_type& c) override { pass(c); }
  void stop(controller_type& c) override {
    say(hw::shut_down(c, far.pace()).complete() ? "all drives are off\n" : "a drive is on\n");
  }

private:
  void plug_in() { far.drive<swing>().go_silent(false); }
  void pass(controller_type& c) {
    far.step();
    const auto phase = c.get<"robot.synchronizer">().phase();
    if (phase == before) return;
    before = phase;
    if (phase == hw::motion_phase::running) say("the drive follows\n");
    if (phase == hw::motion_phase::stopped) say("the drive is being stopped\n");
  }
  static void say(const char* what) {
    std::fputs(what, stdout);
    std::fflush(stdout);
  }

  hw::motion_phase before = hw::motion_phase::stopped;
  hw::virtual_hardware<on_drive, hw::virtual_motors<on_drive::joints>> far;
};

struct laboratory {
  laboratory() {
    walk.wait_for("the drive follows");
    const auto at = door_test::where_in(walk.out);
    user.emplace(at.port, at.token);
    REQUIRE(user->call("/cca/take_command") == "");
    user->subscribe(9, user->channel("/cca/status"));
  }
  // The next status in this state; its causes in one text.
  std::string causes(const std::string& state, bool is_paused = false) {
    std::string found = "no such status";
    user->samples.clear();
    user->waits([&] {
      for (const auto& one : user->samples)
        if (one.subscription == 9)
          if (const json now = json::parse(one.data); now["state"] == state && now["is_paused"] == is_paused)
            return found = now["causes"].dump(), true;
      user->samples.clear();
      return false;
    });
    return found;
  }
  void wait_for_more(const std::string& what) {
    walk.out.clear();
    walk.wait_for(what);
  }

  child walk{cca::robot_main<on_bus>, {"--door", "0", "--on-fault", "hold"}};
  std::optional<client> user{};
};

}  // namespace

TEST_CASE("door: a drive whose cable was pulled is named, and starts anew when it is back") {
  laboratory r;
  CHECK(r.user->call("/cca/command/pull") == "");
  r.walk.wait_for_error("holds after the fault");
  const std::string causes = r.causes("faulted");
  CHECK(causes.find("swing: its drive (id 0x201 on bus 0) is silent") != causes.npos);
  CHECK(causes.find("fault in `watchdog.watch`") != causes.npos);
  // At the fault what was held has ended, so the cable is in again.
  SUBCASE("by a start: the drive is enabled again") {
    CHECK(r.user->call("/cca/start") == "");
    r.wait_for_more("the drive follows");
    CHECK(r.user->call("/cca/pause") == "");
    CHECK(r.causes("running", true) == "[]");
  }
  SUBCASE("a resume lets the program go on, and moves nothing") {
    CHECK(r.user->call("/cca/resume") == "");
    CHECK(r.user->call("/cca/pause") == "");
    CHECK(r.causes("running", true).find("is silent") != std::string::npos);  // why it does not move
    CHECK(r.walk.out.find("the drive follows", r.walk.out.find("being stopped")) == std::string::npos);
    CHECK(r.user->call("/cca/start") == "");
    r.wait_for_more("the drive follows");
  }
  CHECK(r.user->call("/cca/stop") == "");
  CHECK(r.walk.code() == 1);
  CHECK(r.walk.out.find("all drives are off") != std::string::npos);
}

TEST_CASE("door: a drive that says it is broken stops without a fault, and starts anew after a pause") {
  laboratory r;
  CHECK(r.user->call("/cca/command/break") == "");
  r.walk.wait_for("the drive is being stopped");
  CHECK(r.user->call("/cca/resume") == "resume: nothing has faulted");
  CHECK(r.user->call("/cca/start").find("after a pause") != std::string::npos);
  CHECK(r.user->call("/cca/pause") == "");
  CHECK(r.causes("running", true).find("reports a fault") != std::string::npos);
  CHECK(r.user->call("/cca/start") == "");  // enabling clears it
  r.wait_for_more("the drive follows");
  CHECK(r.user->call("/cca/stop") == "");
  CHECK(r.walk.code() == 0);
  CHECK(r.walk.out.find("all drives are off") != std::string::npos);
}

TEST_CASE("door: ended while a fault is held, the drives are shut down in order") {
  laboratory r;
  CHECK(r.user->call("/cca/command/pull") == "");
  r.walk.wait_for_error("holds after the fault");
  r.walk.send(SIGINT);
  CHECK(r.walk.code() == 1);
  CHECK(r.walk.out.find("all drives are off") != std::string::npos);
}
