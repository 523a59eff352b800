// The trot's controller drives virtual drives around the simulated Oncilla, at the other end of CAN buses.
//
//   hardware_in_the_loop [--seconds N]                                 both ends in this process, on buses in memory
//   hardware_in_the_loop --role drives --buses vcan0,...,vcan4         the far end: drives, sensor board, mechanics
//   hardware_in_the_loop --role robot  --buses vcan0,...,vcan4         the controller, in a second process
//
// The role `robot` is the program that drives the real robot: it can't tell the difference. Ends with 0 if nothing tripped (and,
// where it sees it, the robot has not fallen).
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/cca.hpp>
#include <cca/hardware/socket_can.hpp>

#include "in_memory.hpp"

namespace {

using namespace hil;

struct options {
  std::int64_t seconds = 5;
  std::string role;
  std::vector<std::string> names;
};

options parse(int count, char** words) {
  options o;
  for (int i = 1; i < count; i += 2) {
    const std::string_view key = words[i];
    if (i + 1 == count) throw std::runtime_error(std::string(key) + ": needs a value");
    const std::string value = words[i + 1];
    if (key == "--seconds") {
      o.seconds = std::atoll(value.c_str());
    } else if (key == "--role") {
      o.role = value;
    } else if (key == "--buses") {
      for (std::size_t from = 0; from <= value.size();) {
        const std::size_t to = std::min(value.find(',', from), value.size());
        o.names.push_back(value.substr(from, to - from));
        from = to + 1;
      }
    } else {
      throw std::runtime_error(std::string(key) + ": is none of --seconds, --role, --buses");
    }
  }
  if (!o.role.empty() && (o.names.size() != buses || (o.role != "robot" && o.role != "drives")))
    throw std::runtime_error("--role is robot or drives, and comes with --buses and five names");
  return o;
}

template <class Controller>
int told(Controller& c) {
  const auto& stop = c.template get<"robot.emergency_stop">();
  const hw::safety_event cause = stop.first_cause();
  const bool runs = stop.mode() == hw::motion_mode::run;
  if (runs) std::printf("robot: runs, nothing tripped\n");
  else
    std::printf("robot: stopped; first cause: %s%s%s, beat %lld\n", std::string(hw::name_of(cause.rule)).c_str(),
                cause.joint < 0 ? "" : " of ",
                cause.joint < 0 ? "" : std::string(joints::names[static_cast<std::size_t>(cause.joint)]).c_str(),
                static_cast<long long>(cause.beat));
  return runs ? 0 : 1;
}

int in_one_process(std::int64_t seconds) {
  std::printf("no buses given: both ends in this process, on five buses in memory of 1 Mbit/s\n");
  in_memory<> run;
  run.controller.load();
  run.controller.start();
  for (std::int64_t k = 1; k <= seconds * 1000; ++k) {
    run.step();
    if (k % 1000 == 0) std::printf("%2lld s: %.2f m\n", static_cast<long long>(k / 1000), run.robot.world.trunk_position()[0]);
  }
  if (run.robot.world.fallen()) std::printf("the robot fell\n");
  return told(run.controller) + (run.robot.world.fallen() ? 1 : 0);
}

struct trot_over_socket_can : trot::architecture<oncilla<hw::socket_can>> {};

std::vector<hw::socket_can> open(const options& o) {
  std::vector<hw::socket_can> all;
  for (const std::string& name : o.names) all.emplace_back(name);
  return all;
}

int as_robot(const options& o) {
  auto bus = open(o);
  cca::controller<trot_over_socket_can> c;
  c.get<"robot.synchronizer">().connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  c.load();
  c.start();
  c.run(cca::for_some_beats{o.seconds * 1000}, cca::at_wall_clock());
  const int result = told(c);
  c.stop();
  return result;
}

int as_drives(const options& o) {
  auto bus = open(o);
  far_side<hw::socket_can> far;
  far.connect(bus[0], bus[1], bus[2], bus[3], bus[4]);
  mechanics robot(put_down());
  using clock = std::chrono::steady_clock;
  auto next = clock::now();
  for (std::int64_t k = 1; k <= o.seconds * 1000; ++k) {
    const std::int64_t now = std::chrono::duration_cast<std::chrono::nanoseconds>(next.time_since_epoch()).count();
    far.listen(now);
    robot.advance(far.laws(now), far.abduction);
    far.tell(robot.joints(), robot.board());
    if (k % 1000 == 0)
      std::printf("drives: %2lld s: %.2f m\n", static_cast<long long>(k / 1000), robot.world.trunk_position()[0]);
    next += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(next);
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    const options o = parse(count, words);
    if (o.role.empty()) return in_one_process(o.seconds);
    return o.role == "robot" ? as_robot(o) : as_drives(o);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hardware_in_the_loop: %s\n", error.what());
    return 3;
  }
}
