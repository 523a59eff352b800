// What each transport between processes must do for queues to and from free-running environments. `Meeting`
// is that of transport_laws.hpp.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <sstream>
#include <string>

#include "../runtime/deployment/free_running_queues.hpp"
#include "transport_laws.hpp"

namespace free_running_laws {

struct queues_apart : free_queues::spread<cca::tolerate<1000000>> {};

template <class Played>
std::string told_by(const Played& c, const char* environment) {
  std::ostringstream text;
  text << transport_laws::state_of(c) << std::hexfloat;
  const std::string here = environment;
  [[maybe_unused]] const auto tell = [&](const free_queues::logbook& one) {
    text << one.hash << ' ' << one.seen << ' ' << one.last << ' ' << one.lost << ' ';
  };
  if (here == "robot") tell(c.template get<"merged">());
  if (here == "eyes") {
    tell(c.template get<"inside">());
    text << c.template get<"eyes">().cycles;
  }
  if (here == "counts") {
    tell(c.template get<"counts">());
    text << c.template get<"hears_freely">().hash;
  }
  if (here == "mind") {
    tell(c.template get<"mind">());
    tell(c.template get<"newest">());
    tell(c.template get<"late">());
    tell(c.template get<"rare">());
    text << c.template get<"hears">().hash;
  }
  return text.str() + '\n';
}

template <class Meeting>
void queues_have_the_bits_of_one_loop() {
  const std::string name = Meeting::other_name();
  const auto story = [](auto& c, const char* environment) {
    std::string all;
    c.load();
    c.start();
    for (const int beats : {1, 7, 100, 33}) {
      c.run(cca::for_some_beats{beats});
      all += told_by(c, environment);
    }
    return all;
  };
  const auto play = [&](const char* environment) {
    auto d = transport_laws::opened<Meeting, queues_apart>(environment, name);
    return story(d, environment);
  };
  process mind([&] { return play("mind"); });
  process eyes([&] { return play("eyes"); });
  process counts([&] { return play("counts"); });
  process robot([&] { return play("robot"); });
  const auto one_loop = [&](const char* environment) {
    cca::controller<free_queues::architecture> one;
    return story(one, environment);
  };
  CHECK_EQ(robot.said(), one_loop("robot"));
  CHECK_EQ(eyes.said(), one_loop("eyes"));
  CHECK_EQ(counts.said(), one_loop("counts"));
  CHECK_EQ(mind.said(), one_loop("mind"));
}

// Many cycles in a beat: each sample is taken, or lost and counted.
template <class Meeting>
void queues_count_what_they_lose() {
  const std::string name = Meeting::other_name();
  const auto run = [&](const char* environment) {
    free_queues::cycle_in_us = 200;
    auto d = transport_laws::opened<Meeting, queues_apart>(environment, name);
    d.load();
    d.start();
    d.run(cca::for_beats<300>{}, cca::at_wall_clock());
    std::ostringstream text;
    text << cca::to_string(d.state()) << ' ';
    if (std::string(environment) == "mind")
      for (const auto* one : {&d.template get<"newest">(), &d.template get<"late">()})
        text << one->seen << ' ' << one->last << ' ' << one->lost << ' ';
    if (std::string(environment) == "eyes") text << d.template get<"eyes">().cycles;
    return text.str();
  };
  process mind([&] { return run("mind"); });
  process eyes([&] { return run("eyes"); });
  process counts([&] { return run("counts"); });
  process robot([&] { return run("robot"); });
  const std::string of_robot = robot.said(), of_mind = mind.said(), of_eyes = eyes.said();
  CAPTURE(of_robot);
  CAPTURE(of_mind);
  CAPTURE(of_eyes);
  std::string state;
  double cycles = 0;
  std::istringstream eyes_text(of_eyes), mind_text(of_mind);
  eyes_text >> state >> cycles;
  CHECK_GT(cycles, 100);
  struct {
    double seen = 0, last = 0;
    std::int64_t lost = 0;
  } newest, late;
  mind_text >> state >> newest.seen >> newest.last >> newest.lost >> late.seen >> late.last >> late.lost;
  CHECK_EQ(state, "started");
  CHECK_GT(late.lost, 10);
  CHECK_EQ(late.last - late.seen, static_cast<double>(late.lost));
  CHECK_LE(newest.last - newest.seen, static_cast<double>(newest.lost));
  CHECK_LE(newest.seen + static_cast<double>(newest.lost), cycles);
  CHECK_LE(late.last, cycles);
}

}  // namespace free_running_laws
