// What each transport between processes must do for modes with a free-running environment. `Meeting`: as in
// transport_laws.hpp.
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>

#include "../runtime/deployment/free_modes.hpp"
#include "process.hpp"

namespace free_mode_laws {

using namespace free_modes;

// What the components of one environment have seen, each as a number.
template <class D>
std::string told(auto& c, std::size_t environment) {
  std::ostringstream text;
  text << c.beat_index() << ' ' << c.mode();
  for_each_journal(c, [&](const char* name, const journal& j) {
    const auto node = static_cast<std::size_t>(cca::detail::node_at<D>(name));
    if (static_cast<std::size_t>(cca::detail::plan_of<D>.nodes[node].place) != environment) return;
    std::uint64_t hash = j.all.size();
    const auto add = [&](std::uint64_t word) { hash = (hash ^ word) * 0x9e3779b97f4a7c15ull; };
    for (const seen& one : j.all)
      for (const auto word : {static_cast<std::uint64_t>(one.beat), std::bit_cast<std::uint64_t>(one.x),
                              std::bit_cast<std::uint64_t>(one.dt), static_cast<std::uint64_t>(one.origin),
                              std::uint64_t{one.fresh}})
        add(word);
    text << ' ' << name << ' ' << hash;
  });
  return text.str();
}
// Components switch; so does one process between two runs.
template <class Played>
void story(Played& c, bool asks) {
  begin(c);
  int number = 0;
  for (const int beats : {1, 3, 60, 2, 100, 40}) {
    if (asks) c.switch_to(names[number++ % 4]);
    c.run(cca::for_some_beats{beats});
  }
}

template <class Meeting, class D = spread<>>
void has_the_bits_of_one_loop() {
  const std::string name = Meeting::other_name();
  const auto play = [&](const char* environment, std::size_t number) {
    cca::deployed<D> d(cca::only{environment}, Meeting::transport(name));
    story(d, number == 1);  // that of the eyes
    return told<D>(d, number);
  };
  process mind([&] { return play("mind", 2); });
  process eyes([&] { return play("eyes", 1); });
  process robot([&] { return play("robot", 0); });
  cca::controller<sees> loop;
  story(loop, true);
  CHECK_EQ(robot.said(), told<D>(loop, 0));
  CHECK_EQ(eyes.said(), told<D>(loop, 1));
  CHECK_EQ(mind.said(), told<D>(loop, 2));
}

// In a wall-clock run the results of cycles that began in an old mode come as they do in one process, and
// what reads them fires when they come. A mode lasts 70 ms, so that a busy machine still has cycles within
// it.
template <class Meeting>
void results_of_an_old_mode() {
  using D = turning_apart;
  const std::string name = Meeting::other_name();
  const cycles_of slow(9'000);
  process eyes([&] {
    cca::deployed<D> d(cca::only{"eyes"}, Meeting::transport(name));
    begin(d);
    d.run(cca::for_beats<200>{}, cca::at_speed(0.1));
    return d.get<"aims_left">().all.size() > 5 ? std::string() : std::string("few cycles");
  });
  process mind([&] {
    cca::deployed<D> d(cca::only{"mind"}, Meeting::transport(name));
    begin(d);
    d.run(cca::for_beats<200>{}, cca::at_speed(0.1));
    return complaint_about_firings(d);
  });
  process robot([&] {
    cca::deployed<D> d(cca::only{"robot"}, Meeting::transport(name));
    begin(d);
    d.run(cca::for_beats<200>{}, cca::at_speed(0.1));
    return complaint_about(d.get<"reader">()) + std::string(d.fault() ? d.fault().reason() : "");
  });
  CHECK_EQ(robot.said(), "");
  CHECK_EQ(mind.said(), "");
  CHECK_EQ(eyes.said(), "");
}

}  // namespace free_mode_laws
