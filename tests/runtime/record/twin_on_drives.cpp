// The twin of a robot on virtual drives: it has the robot's graph, and buses that are connected to nothing.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/record.hpp>
#include <cca/record/twin.hpp>
#include <cca/robot/limiter.hpp>

#include "../robot_on_drives/torque_pendulum.hpp"
#include "twin_stream.hpp"

namespace {

using namespace pendulum_test;
using record_test::bytes;

struct damper {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
  parameters p{0.1};
  auto process(cca::in<"angle", robots::angles<pendulum>> angle) -> cca::out<"torque", torque> {
    return -p.gain * angle.vector()[0];
  }
};

template <class Bus>
struct on_drive : hw::robot<pendulum, Bus, swing_joint> {};
template <class Bus>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"damper", damper>,
                                 cca::node<"limits", cca::unlimited<torque>>,
                                 cca::node<"robot", on_drive<Bus>>,
                                 cca::wire<"robot.angles", "damper.angle">,
                                 cca::wire<"damper.torque", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">>,
                      cca::recordable {};
using on_virtual_drive = architecture<hw::virtual_bus_end>;

// Connected to nothing. It counts who uses it.
struct no_bus {
  hw::send_result send(std::span<const hw::can_frame>) noexcept { return ++uses, hw::send_result{}; }
  std::size_t receive(std::span<hw::received_frame>) noexcept { return ++uses, 0; }
  hw::bus_state state() const noexcept { return ++uses, hw::bus_state{}; }
  hw::bus_counters counters() const noexcept { return ++uses, hw::bus_counters{}; }
  std::uint64_t in_flight() const noexcept { return ++uses, 0; }
  static inline int uses = 0;
};
using on_no_bus = architecture<no_bus>;

// One bit of the sample of the topic `changed` in beat 700 is another one. Another gain from the middle of
// the run on.
bytes run(const std::string& changed = "") {
  hw::virtual_hardware<on_drive<hw::virtual_bus_end>,
                       hw::virtual_motors<on_drive<hw::virtual_bus_end>::joints>>
      far;
  far.plant.put_at<swing>(0.3);
  cca::controller<on_virtual_drive> c;
  far.connect(c.get<"robot.synchronizer">());
  const auto run_on = [&](int beats) {
    for (int k = 0; k < beats; ++k) c.step(), far.step();
  };
  const auto change = [&](const std::string& topic, std::int64_t beat, bytes& message) {
    if (topic == changed && beat == 700) message.at(4 + 16) ^= 1;
    return true;
  };
  return record_test::stream_of(c, change, [&] {
    run_on(500);
    REQUIRE(c.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    c.set<"damper">({0.4});
    run_on(500);
  });
}

cca::recording::replay_result twin_of(const bytes& stream) {
  cca::recording::twin<on_no_bus> twin;
  return twin.take(stream);
}

}  // namespace

TEST_CASE("the twin of a robot on virtual drives uses no bus, and computes the same bits") {
  const auto result = twin_of(run());
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 999);  // the last one is compared when the next one comes
  CHECK(result.samples > 5 * result.beats);
  CHECK(no_bus::uses == 0);
}

TEST_CASE("one bit of what the robot was told is the first difference") {
  const auto result = twin_of(run("/limits/safe"));
  CHECK(result.component == "limits");
  CHECK(result.port == "safe");
  CHECK(result.beat == 700);
}

TEST_CASE("one bit of what a drive measured is found in the beat in which it was measured") {
  const auto result = twin_of(run("/robot/swing/angle"));
  INFO(result);
  CHECK_FALSE(result);
  CHECK(result.beat == 700);
}
