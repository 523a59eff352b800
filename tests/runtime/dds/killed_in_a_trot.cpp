// The gait of the trot on drives is a process of its own, and is killed in the middle of a trot: the robot's
// side stops the drives in order, over each transport.
#include <doctest/doctest.h>

#include <signal.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/dds.hpp>

#include "../../../examples/hardware_in_the_loop/two_environments.hpp"
#include "../../laws/process.hpp"
#include "over_dds.hpp"

namespace {

using trot_in_two = cca::deployed<hil::two_environments<hil::memory_end>>;

// Between two beats a millisecond passes for the drives.
struct time_of_drives {
  hil::memory_buses& far;
  void begin() const {}
  void wait(std::int64_t since) const {
    if (since > 0) far.pass_millisecond();
  }
};

bool is_driven(const hil::memory_buses& far) {
  return std::any_of(far.laws.begin(), far.laws.end(), [](const auto& law) { return law.stiffness > 0; });
}

constexpr std::int64_t middle = 1500;

// What the robot's side says at its end. Before: it trots. After: within 2 ms no drive holds a position any
// more.
template <class Transport>
std::string robot_whose_gait_is_killed(const Transport& transport) {
  trot_in_two robot(cca::only{"buses"}, transport);
  hil::memory_buses far;
  far.connect(robot);
  robot.load();
  robot.start();
  bool was_driven = false;
  robot.run(cca::for_some_beats{20'000}, time_of_drives{far}, [&](const auto& c) {
    if (c.beat_index() == middle) was_driven = is_driven(far) && far.world().trunk_position()[0] > 0.3;
    return true;
  });
  std::ostringstream said;
  said << (was_driven ? "trots; " : "does not trot; ") << robot.fault().reason();
  if (robot.beat_index() > middle + 20) said << " only in beat " << robot.beat_index();
  int driven = 0;
  for (int ms = 0; ms < 300; ++ms) {  // the frames of on_fault are on the buses
    far.pass_millisecond();
    if (is_driven(far)) ++driven;
    robot.step();
  }
  if (driven > 2) said << "; driven for " << driven << " ms";
  const auto off = far.shut_down(robot);
  said << "; " << (off.complete() ? "all drives are off" : off.text());
  return said.str();
}

template <class Open>
std::string trot_with_killed_gait(Open open) {
  process gait([&] {
    trot_in_two d(cca::only{"gait"}, open());
    d.load();
    d.start();
    d.run(cca::without_end{}, cca::as_fast_as_possible{}, [](const auto& c) {
      if (c.beat_index() == middle) ::raise(SIGKILL);
      return true;
    });
    return "it was not killed";
  });
  process robot([&] { return robot_whose_gait_is_killed(open()); });
  CHECK_EQ(gait.said(), "");
  return robot.said();
}

constexpr std::string_view expected = "trots; lost contact with `gait`; all drives are off";

}  // namespace

TEST_SUITE("a trot whose gait is killed") {
  TEST_CASE("over shared memory") {
    const std::string name = "/cca_test_killed_" + std::to_string(::getpid());
    CHECK_EQ(trot_with_killed_gait([&] { return cca::shared_memory(name); }), expected);
  }
  TEST_CASE("over DDS") {
    const std::string name = over_dds::other_name();
    CHECK_EQ(trot_with_killed_gait([&] { return over_dds::transport(name); }), expected);
  }
}
