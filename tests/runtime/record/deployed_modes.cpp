// The recording of a deployment of modes: one file with all environments and the switches of the mode,
// replayed in one loop.
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>
#include <cca/runtime/transports/shared_memory.hpp>
#include <cca/trace.hpp>

#include "../../laws/process.hpp"
#include "two_modes.hpp"

using namespace record_test;

namespace {

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"gait", gait>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"leg.angles", "gait.x", cca::delayed<1>>,
                         cca::wire<"gait.angles", "limits.command", cca::delayed<2>>,
                         cca::wire<"limits.safe", "leg.command">> {};
struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"leg", leg>,
                          cca::node<"stance", stance>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::wire<"leg.angles", "stance.x", cca::delayed<1>>,
                          cca::wire<"stance.angles", "limits.command", cca::delayed<2>>,
                          cca::wire<"limits.safe", "leg.command">> {};

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>> {};
using robot = cca::environment<"robot", cca::nodes<"leg", "limits">>;
using mind = cca::environment<"mind", cca::other_nodes>;
struct split : cca::deployment<legs, robot, mind>, cca::recordable {};
struct traced : cca::deployment<legs, robot, mind>, cca::recordable, cca::traceable {};

// Components switch in the beats 200 and 300, the program before beat 500.
template <class Played>
std::vector<double> drive(Played& c) {
  std::vector<double> at;
  const auto note = [&](Played& running) { at.push_back(running.template get<"leg">().at[0]); };
  c.load();
  c.start();
  c.run(cca::for_beats<250>{}, {}, note);
  c.template set<"gait">({0.4});
  c.run(cca::for_beats<250>{});
  c.template switch_to<"stand">();
  c.run(cca::for_beats<100>{}, {}, note);
  c.stop();
  return at;
}

}  // namespace

TEST_CASE("the recording of a deployment of modes has each switch once, and is replayed bit for bit") {
  const temporary_file file("deployed_modes");
  {
    cca::deployed<split> d;
    cca::recording::recorder recording(d, file.path, {.waits = true});
    cca::controller<legs> plain;
    CHECK(drive(d) == drive(plain));
    recording.close();
    CHECK(recording.problem() == "");
    CHECK(recording.lost_beats() == 0);
  }
  auto [modes, count] = modes_recorded_in(file.path);
  CHECK(modes == std::vector<switched>{
                     {0, "walk", false}, {201, "stand", true}, {301, "walk", true}, {500, "stand", false}});
  CHECK(count["/gait/angles"] == 200 + 199);
  CHECK(count["/stance/height"] == 100 + 100);
  CHECK(count["/leg/angles"] == 600);
  CHECK(count["/limits/safe"] == 597 - 3 * 2);  // it waits for the first sample of what comes

  const auto result = cca::recording::replay<split>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 600);

  const auto other =
      cca::recording::replay<split>(file.path, [](auto& c) { c.template get<"stance">().sum = 1e-3; });
  CHECK(other.component == "stance");
  CHECK(other.beat == 201);
}

TEST_CASE("over processes each records what it runs, and a replay needs only the robot's file") {
  const temporary_file of_robot("modes_of_robot"), of_mind("modes_of_mind");
  const std::string memory = "/cca_recorded_modes_" + std::to_string(::getpid());
  const auto run = [&](const char* environment, const std::string& into) {
    cca::deployed<split> d(cca::only{environment}, cca::shared_memory(memory));
    cca::recording::recorder recording(d, into, {.waits = true});
    d.load();
    d.start();
    d.run(cca::for_beats<250>{});
    if (std::string_view(environment) == "mind") d.switch_to<"walk">();  // of both
    d.run(cca::for_beats<150>{});
    d.stop();
    recording.close();
    return recording.problem();
  };
  {
    process mind([&] { return run("mind", of_mind.path); });
    process robot([&] { return run("robot", of_robot.path); });
    CHECK(robot.said() == "");
    CHECK(mind.said() == "");
  }
  auto [modes, count] = modes_recorded_in(of_robot.path);
  CHECK(modes == std::vector<switched>{{0, "walk", false}, {201, "stand", true}, {250, "walk", false}});
  CHECK(count["/leg/angles"] == 400);
  CHECK(count["/gait/angles"] == 0);
  const auto result = cca::recording::replay<split>(of_robot.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 400);
}

TEST_CASE("a deployment of modes is traced: each environment tells the switch") {
  const temporary_file file("traced_modes"), recorded("traced_and_recorded_modes");
  cca::deployed<traced> d;
  {
    cca::tracer trace(d, file.path, {.waits = true});
    cca::recording::recorder recording(d, recorded.path, {.waits = true});
    drive(d);
    trace.close();
    CHECK(trace.problem() == "");
    CHECK(trace.lost_beats() == 0);
  }
  const auto result = cca::recording::replay<traced>(recorded.path);
  INFO(result);
  CHECK(result);
}
