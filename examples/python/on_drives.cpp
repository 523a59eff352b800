// The policy that Python has trained walks on virtual drives: the architecture of examples/walking_policy
// with the robot of examples/hardware_in_the_loop, over five CAN buses in memory.
//
//   python_on_drives --weights examples/python/walk.policy
//
// Exit code 0: it has walked at 0.8 of the commanded speed or faster, has not fallen, and stopped in order.
#include <cstdio>
#include <string>

#include <cca/cca.hpp>
#include <cca/main.hpp>

#include "../hardware_in_the_loop/in_memory.hpp"
#include "../walking_policy/architecture.hpp"

namespace {

struct trained_gait : walking::gait_of<walking::policy, trot::stride_oscillator> {};  // as in task.hpp
struct walk_on_drives : walking::architecture<hil::oncilla<hil::memory_end>, trained_gait> {};

struct program : cca::robot_program<walk_on_drives> {
  program() {
    purpose = "a simulated Oncilla on virtual drives walks by the policy that Python has trained";
    settings.seconds = 10;
    settings.speed.reset();  // a fast run
  }

  void options(cca::command_line& line) override {
    line.text("--weights FILE", weights, "of the policy (walk.policy)");
    line.number("--walk V", wanted, 0.1, 1, "m/s (0.4)");
  }
  void prepare(controller_type& c) override {
    buses.connect(c);
    if (!c.get<"gait.policy">().p.file.assign(weights))
      throw cca::command_line_error(weights + ": this name is too long");
  }
  void loaded(controller_type& c) override {
    auto speed = c.get<"gait.throttle">().p;
    speed.speed = wanted;
    c.set<"gait.throttle">(speed);
  }
  bool between(controller_type&) override {
    buses.pass_millisecond();
    const auto& world = buses.world();
    if (world.time() < settled) start = world.trunk_position()[0], begun = world.time();
    fell = fell || world.fallen();
    return !fell;
  }
  void stop(controller_type& c) override {
    const auto& world = buses.world();
    if (world.time() > begun) cruise = (world.trunk_position()[0] - start) / (world.time() - begun);
    at = world.trunk_position();
    stopped = buses.shut_down(c);
  }
  int finish(controller_type&) override {
    std::printf("on drives: %s%.2f m forward, %.2f m aside, cruise %.3f m/s of %.3f\n%s\n",
                fell ? "FELL, " : "", at[0], at[1], cruise, wanted, stopped.text().c_str());
    return !fell && cruise >= 0.8 * wanted && stopped.complete() ? 0 : 1;
  }

private:
  static constexpr double settled = 2;  // s, until it walks

  std::string weights = "walk.policy";
  double wanted = 0.4, start = 0, begun = 0, cruise = 0;
  cca::sim::vector3 at{};
  bool fell = false;
  hil::memory_buses buses;
  cca::hardware::shut_down_report stopped;
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
