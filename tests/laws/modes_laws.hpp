// What each transport between processes must do with a deployment of modes: all environments switch in the
// same beat, whoever asks. `Meeting`: as in transport_laws.hpp.
#pragma once

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include <cca/runtime/live/live_access.hpp>

#include "../runtime/deployment/modes_rig.hpp"
#include "process.hpp"

namespace modes_laws {

using namespace modes_test;

inline constexpr const char* names[] = {"walk", "stand", "fall"};

inline void tell(std::ostringstream& to, const journal& one) {
  to << std::hexfloat << one.all.size();
  for (const auto& s : one.all)
    to << ' ' << s.beat << ' ' << s.x << ' ' << s.dt << ' ' << s.origin << ' ' << s.fresh;
  to << '\n';
}
template <class Played>
std::string robot_of(const Played& c) {
  std::ostringstream text;
  text << c.beat_index() << ' ' << c.mode() << '\n';
  tell(text, c.template get<"robot">());
  tell(text, c.template get<"asks">());
  tell(text, c.template get<"maybe">());
  tell(text, c.template get<"queued">());
  return text.str();
}
template <class Played>
std::string mind_of(const Played& c) {
  std::ostringstream text;
  text << c.beat_index() << ' ' << c.mode() << '\n';
  tell(text, c.template get<"mind.deep.both">());
  tell(text, c.template get<"mind.deep.steady">());
  tell(text, c.template get<"plan">());
  tell(text, c.template get<"stance">());
  tell(text, c.template get<"slow">());
  tell(text, c.template get<"after_slow">());
  tell(text, c.template get<"pair">());
  tell(text, c.template get<"third">());
  tell(text, c.template get<"old">());
  return text.str();
}
constexpr auto tell_robot = [](const auto& c) { return robot_of(c); };
constexpr auto tell_mind = [](const auto& c) { return mind_of(c); };

// Runs, and switches between two of them and between two beats; components switch, too. `asks(i)`: whether
// the i-th switch is asked for here.
template <class Played, class Asks, class Tell>
std::string story(Played& c, Asks asks, Tell tell) {
  begin(c);
  int number = 0;
  const auto next = [&](auto& now) {
    const int i = number++;
    if (asks(i)) now.switch_to(names[static_cast<unsigned>(i) * 7 % 11 % 3]);
  };
  for (const int beats : {1, 3, 60, 2, 100, 1, 40}) {
    next(c);
    c.run(cca::for_some_beats{beats});
    int made = 0;
    c.run(cca::for_some_beats{beats}, cca::as_fast_as_possible(), [&](auto& now) {
      if (++made % 9 == 2) next(now);
      return true;
    });
  }
  return tell(c);
}

template <class Meeting>
cca::deployed<in_two> opened(const char* environment, const std::string& name) {
  return cca::deployed<in_two>(cca::only{environment}, Meeting::transport(name));
}

template <class Meeting>
void switches_in_the_same_beat() {
  const std::string name = Meeting::other_name();
  process mind([&] {
    auto d = opened<Meeting>("mind", name);
    return story(d, [](int i) { return i % 3 == 1; }, tell_mind);
  });
  process robot([&] {
    auto d = opened<Meeting>("robot", name);
    return story(d, [](int i) { return i % 3 != 1; }, tell_robot);
  });
  cca::controller<moves> one, other;
  const auto always = [](int) { return true; };
  CHECK_EQ(robot.said(), story(one, always, tell_robot));
  CHECK_EQ(mind.said(), story(other, always, tell_mind));
}

// In a wall-clock run an order comes into all environments in the same beat, as long as nothing is late.
template <class Meeting>
void switches_in_the_same_beat_of_a_wall_clock_run() {
  constexpr std::int64_t beats = 80;
  const auto prepare = [](auto& c) {
    begin(c);
    try {
      c.template get<"asks">().asks = false;
    } catch (const cca::refused&) {}  // another process has it
    try {
      c.template get<"also_asks">().asks = false;
    } catch (const cca::refused&) {}
  };
  cca::controller<moves> c;
  prepare(c);
  c.run(cca::for_some_beats{1 + cca::detail::beat_of_order<in_two>(0, false)});
  c.switch_to<"stand">();
  c.run(cca::for_some_beats{beats - c.beat_index()});
  for (const double speed : {0.1, 0.05, 0.02}) {
    const std::string name = Meeting::other_name();
    const auto run = [&](const char* environment, bool asks, auto tell) {
      auto d = opened<Meeting>(environment, name);
      prepare(d);
      cca::live_access live(d);
      if (asks) CHECK(live.switch_to("stand"));  // taken after the first beat
      d.run(cca::for_beats<beats>{}, cca::at_speed(speed), live);
      return d.late() > 0 || d.figures()[1].lost_periods > 0 || d.fault() ? std::string("late") : tell(d);
    };
    process mind([&] { return run("mind", false, tell_mind); });
    process robot([&] { return run("robot", true, tell_robot); });
    const std::string of_robot = robot.said(), of_mind = mind.said();
    if (of_robot == "late" || of_mind == "late") continue;
    CHECK_EQ(of_robot, robot_of(c));
    CHECK_EQ(of_mind, mind_of(c));
    return;
  }
  MESSAGE("something was late each time: nothing to compare");
}

// A process that comes again begins in the mode of the others.
template <class Meeting>
void joins_the_mode_of_the_others() {
  const std::string name = Meeting::other_name();
  const auto run_mind = [&] {
    auto d = opened<Meeting>("mind", name);
    begin(d);
    d.template get<"also_asks">().asks = false;
    d.run(cca::for_beats<20>{});
    return std::string(d.mode());
  };
  process robot([&] {
    auto d = opened<Meeting>("robot", name);
    begin(d);
    d.template get<"asks">().asks = false;
    d.template switch_to<"fall">();
    d.run(cca::for_beats<20>{});
    d.template switch_to<"stand">();
    d.run(cca::for_beats<20>{});
    return std::string(d.mode());
  });
  process first(run_mind);
  CHECK_EQ(first.said(), "fall");
  process second(run_mind);
  CHECK_EQ(second.said(), "stand");
  CHECK_EQ(robot.said(), "stand");
}

}  // namespace modes_laws
