// Tutorial, step 9: a motor on a CAN bus, both in memory. docs/tutorial/9_drives.md
#include <cstdio>

#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/virtual_mit.hpp>

#include "motor_on_bus.hpp"

// [graph]
using bus_type = cca::hardware::memory_bus<>::end_type;  // on a real robot: cca::hardware::socket_can

struct goal {
  auto process(cca::in<"measured", hip_angle>) -> cca::out<"angle", hip_angle> { return 0.5; }
};

struct one_motor : cca::graph<cca::node<"motor", motor_on_bus<bus_type>>,
                              cca::node<"goal", goal>,
                              cca::node<"limits", cca::limiter<hip_angle>>,
                              cca::wire<"motor.angle", "goal.measured">,
                              cca::wire<"goal.angle", "limits.command">,
                              cca::wire<"motor.angle", "limits.measured">,
                              cca::wire<"limits.safe", "motor.command">> {};
// [graph end]

// [program]
int main() {
  cca::hardware::memory_bus<> wire;  // 1 Mbit/s, two ends, virtual time
  bus_type near = wire.end(0), far = wire.end(1);
  cca::hardware::virtual_mit<hip_drive> firmware;  // what the drive does with its frames
  cca::hardware::virtual_motor mechanics;          // what its motor does

  cca::controller<one_motor> c;
  c.get<"motor">().bus = &near;
  c.load();
  c.start();
  for (std::int64_t beat = 1; beat <= 300; ++beat) {
    const std::int64_t now = beat * c.period();
    c.step();
    wire.advance(now);
    std::array<cca::hardware::received_frame, 8> inbox;
    const std::size_t count = far.receive(inbox);
    for (std::size_t i = 0; i < count; ++i) firmware.hear(inbox[i].frame, now);
    mechanics.advance(firmware.law(now), 0, 1e-3);
    far.send(firmware.answer(mechanics.now));
    if (beat % 50 == 0)
      std::printf("%3lld ms  measured %.3f rad, true %.3f rad\n", static_cast<long long>(beat),
                  c.get<"motor">().report.position, mechanics.now.position);
  }
  c.stop();  // sends the frames that switch the drive off
  wire.advance(301 * c.period());
  std::array<cca::hardware::received_frame, 8> last;
  for (std::size_t i = 0, count = far.receive(last); i < count; ++i)
    firmware.hear(last[i].frame, 301 * c.period());
  std::printf("after stop() the drive is %s\n", firmware.enabled() ? "still enabled" : "disabled");
}
// [program end]
