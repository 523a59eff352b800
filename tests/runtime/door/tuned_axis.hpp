// The axis of docs/tuning.md with soft gains, running ten times as fast as the clock behind a door.
#pragma once

#include <thread>

#include <cca/door.hpp>

#include "../../../examples/tuning/axis.hpp"
#include "client.hpp"

namespace door_test {

struct tuned_axis {
  using controller = cca::controller<tuning::axis>;

  tuned_axis() : door(started(), {.port = 0, .tells_where = false}) {
    loop = std::thread([this] { c.run(cca::without_end{}, cca::at_speed(10), door); });
  }
  ~tuned_axis() { end(); }
  tuned_axis(const tuned_axis&) = delete;
  tuned_axis& operator=(const tuned_axis&) = delete;
  void end() {
    if (!loop.joinable()) return;
    client last(door.port(), door.token());
    last.call("/cca/stop");
    loop.join();
  }

  controller c;
  cca::door<controller> door;

private:
  std::thread loop;

  controller& started() {  // before the door is made: it knows the parameters of then
    c.load();
    auto gains = c.get<"servo">().p;
    gains.proportional[0] = 1, gains.derivative[0] = 0.05, gains.filter = 0.001;
    c.set<"servo">(gains);
    c.get<"drive">().motor.now.position = 0.5;
    c.start();
    return c;
  }
};

}  // namespace door_test
