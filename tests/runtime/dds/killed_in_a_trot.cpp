// The gait of the trot on drives is a process of its own. One of the two is killed in the middle of a trot,
// over each transport. Without the gait the robot's side stops the drives in order, also in a wall-clock run.
// Without the robot's side the gait ends; the drives stop by their own watchdogs (docs/hardware.md), which
// the fault campaign tests.
#include <doctest/doctest.h>

#include <signal.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/dds.hpp>

#include "../../laws/process.hpp"
#include "../../laws/trot_in_two.hpp"
#include "over_dds.hpp"

namespace {

using laws::trot_in_two;

constexpr std::int64_t middle = 1500;
constexpr std::int64_t begin_of_clock = middle - 20;  // before, in a fast run

// What the robot's side says at its end. Before: it trots. After: within 2 ms no drive holds a position any
// more.
template <class Transport>
std::string robot_whose_gait_is_killed(const Transport& transport, bool is_on_clock) {
  trot_in_two robot(cca::only{"buses"}, transport);
  hil::memory_buses far;
  far.connect(robot);
  robot.load();
  robot.start();
  bool was_driven = false;
  const auto look = [&](const auto& c) {
    if (c.beat_index() == middle) was_driven = laws::trots(far);
    return true;
  };
  if (is_on_clock) {
    robot.run(cca::for_some_beats{begin_of_clock}, far.pace(), look);
    far.pass_millisecond();
    robot.run(cca::for_some_beats{20'000}, laws::clock_of_drives(far), look);
  } else {
    robot.run(cca::for_some_beats{20'000}, far.pace(), look);
  }
  std::ostringstream said;
  said << (was_driven ? "trots; " : "does not trot; ") << robot.fault().reason();
  if (robot.beat_index() > middle + (is_on_clock ? laws::tolerated_late_beats + 2 : 20))
    said << " only in beat " << robot.beat_index();
  const int driven = laws::driven_after(robot, far);
  if (driven > 2) said << "; driven for " << driven << " ms";
  const auto off = far.shut_down(robot);
  said << "; " << (off.complete() ? "all drives are off" : off.text());
  return said.str();
}

constexpr auto die_in_the_middle = [](const auto& c) {
  if (c.beat_index() == middle) ::raise(SIGKILL);
  return true;
};

template <class Open>
std::string trot_with_killed_gait(Open open, bool is_on_clock = false) {
  process gait([&] {
    trot_in_two d(cca::only{"gait"}, open());
    d.load();
    d.start();
    if (is_on_clock) d.run(cca::for_some_beats{begin_of_clock});
    d.run(cca::without_end{}, cca::as_fast_as_possible{}, die_in_the_middle);
    return "it was not killed";
  });
  process robot([&] { return robot_whose_gait_is_killed(open(), is_on_clock); });
  CHECK_EQ(gait.said(), "");
  return robot.said();
}

constexpr std::string_view expected = "trots; lost contact with `gait`; all drives are off";

// What the gait's side says at its end.
template <class Open>
std::string trot_with_killed_buses(Open open) {
  process buses([&] {
    trot_in_two robot(cca::only{"buses"}, open());
    hil::memory_buses far;
    far.connect(robot);
    robot.load();
    robot.start();
    robot.run(cca::for_some_beats{20'000}, far.pace(), die_in_the_middle);
    return "it was not killed";
  });
  process gait([&] {
    trot_in_two d(cca::only{"gait"}, open());
    d.load();
    d.start();
    d.run(cca::without_end{});
    std::ostringstream said;
    said << cca::to_string(d.state()) << ' ' << d.fault().reason();
    if (d.beat_index() < middle || d.beat_index() > middle + 20) said << " in beat " << d.beat_index();
    const std::int64_t beats = d.beat_index();
    if (d.step() || d.beat_index() != beats) said << ", and goes on";
    return said.str();
  });
  CHECK_EQ(buses.said(), "");
  return gait.said();
}

std::string memory_name() {
  static int made = 0;
  return "/cca_test_killed_" + std::to_string(::getpid()) + "_" + std::to_string(made++);
}

}  // namespace

TEST_SUITE("a trot whose gait or robot is killed") {
  TEST_CASE("the gait, over shared memory") {
    CHECK_EQ(trot_with_killed_gait([name = memory_name()] { return cca::shared_memory(name); }), expected);
  }
  TEST_CASE("the gait, over DDS") {
    CHECK_EQ(trot_with_killed_gait([name = over_dds::other_name()] { return over_dds::transport(name); }),
             expected);
  }
  TEST_CASE("the gait, in a wall-clock run: the drives are safe within two beats more than are tolerated") {
    CHECK_EQ(trot_with_killed_gait([name = memory_name()] { return cca::shared_memory(name); }, true),
             expected);
    CHECK_EQ(
        trot_with_killed_gait([name = over_dds::other_name()] { return over_dds::transport(name); }, true),
        expected);
  }
  TEST_CASE("the robot's side: the gait has lost contact, and stops") {
    CHECK_EQ(trot_with_killed_buses([name = memory_name()] { return cca::shared_memory(name); }),
             "faulted lost contact with `buses`");
    CHECK_EQ(trot_with_killed_buses([name = over_dds::other_name()] { return over_dds::transport(name); }),
             "faulted lost contact with `buses`");
  }
}
