// What each transport between processes must do for a free-running environment. `Meeting` is that of
// transport_laws.hpp.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>

#include "../runtime/deployment/free_running.hpp"
#include "transport_laws.hpp"

namespace free_running_laws {

using namespace deployment_test;
using namespace std::chrono_literals;
using transport_laws::milestone;
using transport_laws::opened;
using transport_laws::state_of;

// In a wall-clock run the robot and the mind wait longer for each other than any test lasts.
struct patient_eyes
    : cca::deployment<seeing,
                      cca::environment<"robot", cca::nodes<"device", "reflex">>,
                      cca::environment<"eyes", cca::nodes<"eyes", "memory", "history">, cca::free_running>,
                      cca::environment<"mind", cca::other_nodes>,
                      cca::tolerate<1000000>> {};

constexpr auto tell_robot = [](const auto& c) {
  std::ostringstream text;
  text << state_of(c) << std::hexfloat << c.template get<"device">().command << ' '
       << c.template get<"device">().faults << ' ' << c.template get<"reflex">().seen << '\n';
  return text.str();
};
constexpr auto tell_eyes = [](const auto& c) {
  const auto& eyes = c.template get<"eyes">();
  std::ostringstream text;
  text << state_of(c) << std::hexfloat << eyes.kept << ' ' << eyes.cycles << ' ' << eyes.fresh << ' '
       << eyes.seconds << ' ' << eyes.last << ' ' << c.template get<"memory">().sum << ' '
       << c.template get<"history">().sum << '\n';
  return text.str();
};
constexpr auto tell_mind = [](const auto& c) {
  std::ostringstream text;
  text << state_of(c) << std::hexfloat << c.template get<"glancer">().last << ' '
       << c.template get<"glancer">().glances << ' ' << c.template get<"slow">().sum << ' '
       << c.template get<"log">().sum << '\n';
  return text.str();
};

// Runs of several lengths. The last ends with a fault of the eyes.
template <class Played, class F>
std::string story(Played& c, F tell) {
  std::string all;
  c.load();
  c.start();
  for (const int beats : {1, 7, 100, 33, 300}) {
    if (beats == 300) try {
        c.template set<"eyes">({0.0045, 0.5});
      } catch (const cca::refused&) {}  // another process has them
    c.run(cca::for_some_beats{beats});
    all += tell(c);
  }
  return all;
}

template <class Meeting>
void has_the_bits_of_one_loop() {
  const std::string name = Meeting::other_name();
  const auto play = [&](const char* environment, auto tell) {
    auto d = opened<Meeting, with_eyes>(environment, name);
    return story(d, tell);
  };
  process mind([&] { return play("mind", tell_mind); });
  process eyes([&] { return play("eyes", tell_eyes); });
  process robot([&] { return play("robot", tell_robot); });
  cca::controller<seeing> one, other, third;
  const std::string of_robot = story(one, tell_robot);
  CHECK(of_robot.find("faulted dazzled") != std::string::npos);
  CHECK_EQ(robot.said(), of_robot);
  CHECK_EQ(eyes.said(), story(other, tell_eyes));
  CHECK_EQ(mind.said(), story(third, tell_mind));
}

// Cycles of many beats: the robot keeps its own, results arrive at the robot and the mind, nothing is late.
template <class Meeting>
void runs_freely_at_wall_clock_speed() {
  const std::string name = Meeting::other_name();
  const auto run = [&](const char* environment, auto tell) {
    cycle_in_us = 12'000;
    auto d = opened<Meeting, patient_eyes>(environment, name);
    d.load();
    d.start();
    for (int i = 0; i < 3 && d.state() == cca::state::started; ++i)
      d.run(cca::for_beats<100>{}, cca::at_wall_clock());
    std::ostringstream text;
    const auto figures = d.figures();
    for (const auto& from : figures[0].channels)
      if (from.from == "eyes") text << from.late << " late ";
    text << cca::to_string(d.state()) << ' ' << d.beat_index() << ' ' << tell(d);
    return text.str();
  };
  process mind([&] { return run("mind", [](auto& d) { return d.template get<"glancer">().last; }); });
  process eyes([&] { return run("eyes", [](auto& d) { return d.template get<"eyes">().cycles; }); });
  process robot([&] { return run("robot", [](auto& d) { return d.template get<"reflex">().seen; }); });
  std::istringstream of_robot(robot.said()), of_eyes(eyes.said()), of_mind(mind.said());
  CAPTURE(of_robot.str());
  CAPTURE(of_eyes.str());
  CAPTURE(of_mind.str());
  std::string late, state;
  std::int64_t count = -1, beats = 0, cycles = 0, seen = 0;
  double level = 0;
  of_robot >> count >> late >> state >> beats >> seen;
  CHECK_EQ(count, 0);
  CHECK_EQ(state, "started");
  CHECK_EQ(beats, 300);
  of_eyes >> count >> late >> state >> beats >> cycles;
  CHECK_EQ(beats, 300);
  CHECK_GE(cycles, 3);
  CHECK_GE(seen, 2);
  CHECK_LE(seen, cycles);
  of_mind >> count >> late >> state >> beats >> level;
  CHECK_EQ(state, "started");
  CHECK_NE(level, 0);
}

// What is left when SIGKILL ends the eyes, or the robot.
template <class Meeting>
void loses_contact_with_the_killed() {
  for (const bool kills_eyes : {true, false}) {
    const std::string name = Meeting::other_name();
    const milestone all_run;
    const auto run = [&](const char* environment) {
      auto d = opened<Meeting, patient_eyes>(environment, name);
      d.load();
      d.start();
      d.run(cca::for_beats<5>{}, cca::at_wall_clock());
      all_run.reached();
      d.run(cca::without_end{}, cca::at_wall_clock());
      return state_of(d);
    };
    process mind([&] { return run("mind"); });
    process eyes([&] { return run("eyes"); });
    process robot([&] { return run("robot"); });
    all_run.wait_for(3);
    std::this_thread::sleep_for(200ms);
    (kills_eyes ? eyes : robot).kill();
    const std::string said = (kills_eyes ? robot : eyes).said();
    CAPTURE(said);
    const std::string lost =
        kills_eyes ? "faulted lost contact with `eyes`" : "faulted lost contact with `robot`";
    CHECK(said.find(lost) != std::string::npos);
  }
}

}  // namespace free_running_laws
