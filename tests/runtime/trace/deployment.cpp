// Traces of deployments: a track for each environment, waits, late samples and overruns; in one process and
// in two. Traces of sets of modes.
#include <chrono>
#include <thread>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "../deployment/robot_and_mind.hpp"
#include "traced_file.hpp"

using namespace trace_test;

namespace {

struct split : deployment_test::two, cca::traceable {};
struct patient : cca::deployment<deployment_test::architecture,
                                 cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                 cca::environment<"mind", cca::other_nodes>,
                                 cca::tolerate<100'000>>,
                 cca::traceable {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"plant", plant>,
                         cca::node<"pair", pair>,
                         cca::wire<"plant.y", "pair.x">,
                         cca::wire<"pair.y", "plant.u">> {};
struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"hold", gain>,
                          cca::node<"plant", plant>,
                          cca::wire<"plant.y", "hold.x">,
                          cca::wire<"hold.y", "plant.u">> {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>>, cca::traceable {};

}  // namespace

TEST_CASE("a deployment has a track for each environment") {
  const temporary_file file;
  cca::deployed<split> d;
  cca::controller<deployment_test::architecture> plain;
  cca::tracer trace(d, file.path, {.waits = true});
  d.load(), plain.load();
  d.start(), plain.start();
  d.run(cca::for_beats<200>{});
  plain.run(cca::for_beats<200>{});
  trace.close();
  CHECK(d.get<"device">().command == plain.get<"device">().command);
  const auto all = events_of(file.path);
  const int robot = track_named(all, "robot"), mind = track_named(all, "mind");
  REQUIRE(robot > 0);
  REQUIRE(mind > 0);
  CHECK(robot != mind);
  const auto on_robot = beats_of(all, robot), on_mind = beats_of(all, mind);
  REQUIRE(on_robot.size() == 200);
  for (std::size_t k = 0; k < on_robot.size(); ++k) {
    CHECK(on_robot[k].number == static_cast<std::int64_t>(k));
    CHECK(on_robot[k].fired == std::vector<std::string>{"device (sense)", "filter", "guard", "device (act)"});
  }
  const auto thought = firings_in(on_mind);
  CHECK(thought.at("thinker") == 40);
  CHECK(thought.at("slow") > 30);
  CHECK(thought.size() == 2);
  const auto summary = trace.summary();
  REQUIRE(summary.environments.size() == 2);
  CHECK(summary.environments[0].name == "robot");
  CHECK(summary.environments[0].beats.all.count() == 200);
  CHECK(summary.environments[1].name == "mind");
}

TEST_CASE("late samples and overruns are marks, as many as are counted") {
  const temporary_file file;
  cca::deployed<patient> d;
  cca::tracer trace(d, file.path);
  d.load();
  d.start();
  deployment_test::stall_in_ms = 30;
  deployment_test::beat_that_stalls = 40;
  d.run(cca::for_beats<200>{}, cca::at_wall_clock());
  trace.close();
  CHECK(d.late() > 0);
  CHECK(d.overruns() > 0);
  const auto all = events_of(file.path);
  CHECK(count_of(all, "late sample") == d.late());
  CHECK(count_of(all, "overrun") == d.overruns());
  for (const auto& figures : d.figures()) {
    const int track = track_named(all, std::string(figures.name));
    CHECK(count_of(all, "overrun", track) == figures.overruns);
    for (const auto& channel : figures.channels) {
      std::int64_t late = 0;
      for (const event& e : all)
        late += e.name == "late sample" && e.track == track && e.arguments.at("from") == channel.from;
      CHECK(late == channel.late);
    }
  }
  CHECK(count_of(all, "late sample", track_named(all, "robot")) > 0);  // the mind's
  const auto summary = trace.summary();
  CHECK(summary.environments[0].late + summary.environments[1].late == d.late());
  beats_of(all, track_named(all, "robot"));  // nested
  beats_of(all, track_named(all, "mind"));
}

TEST_CASE("a fault of a deployment is a mark of its environment") {
  const temporary_file file;
  cca::deployed<split> d;
  cca::tracer trace(d, file.path, {.waits = true});
  d.load();
  d.set<"guard">({-1.0});
  d.start();
  CHECK(d.run(cca::for_beats<100>{}) == cca::state::faulted);
  trace.close();
  const auto all = events_of(file.path);
  CHECK(count_of(all, "faulted") == 1);
  bool is_there = false;
  for (const event& e : all)
    if (e.name == "fault" && e.track == track_named(all, "robot"))
      is_there = e.arguments.at("component") == "guard" && e.arguments.at("reason") == "too much";
  CHECK(is_there);
}

TEST_CASE("components of modes have the same name in each mode") {
  const temporary_file file;
  cca::controller<legs> c;
  cca::tracer trace(c, file.path, {.waits = true});
  c.load();
  c.start();
  c.run(cca::for_beats<20>{});
  c.switch_to<"stand">();
  c.run(cca::for_beats<30>{});
  trace.close();
  const auto all = events_of(file.path);
  const auto beats = beats_of(all, 1);
  REQUIRE(beats.size() == 50);
  CHECK(beats[19].fired ==
        std::vector<std::string>{"plant (sense)", "pair.first", "pair.second", "plant (act)"});
  CHECK(beats[20].fired == std::vector<std::string>{"plant (sense)", "hold", "plant (act)"});
  std::vector<std::string> modes;
  for (const event& e : all)
    if (e.name == "mode") modes.push_back(e.arguments.at("mode"));
  CHECK(modes == std::vector<std::string>{"stand"});
  const auto summary = trace.summary();
  for (const auto& row : summary.environments[0].components)
    CHECK(row.firings.all.count() == (row.path == "plant" ? 50 : row.path == "hold" ? 30 : 20));
}
