// What a declared test of an input costs a beat: the axis of examples/tuning, with and without it.
//
//   bench_input_test <what> <beats>   plain: without the declaration; off: with it; running: a sine
//
// Count the instructions of `one_beat`:
//   valgrind --tool=callgrind --toggle-collect='*one_beat*' bench_input_test off 10000
#include <cstdlib>
#include <memory>
#include <string_view>

#include "../examples/tuning/axis.hpp"

namespace bench {

struct plain : cca::graph<cca::node<"plan", tuning::rest>,
                          cca::node<"servo", cca::pid<tuning::arm_angle, tuning::arm_torque>>,
                          cca::node<"limits", cca::limiter<tuning::arm_torque>>,
                          cca::node<"drive", tuning::virtual_axis>,
                          cca::wire<"plan.angle", "servo.reference">,
                          cca::wire<"drive.angle", "servo.measured">,
                          cca::wire<"servo.command", "limits.command">,
                          cca::wire<"limits.safe", "drive.torque">> {};
struct tested : cca::graph<cca::node<"plan", tuning::rest>,
                           cca::node<"servo", cca::pid<tuning::arm_angle, tuning::arm_torque>>,
                           cca::node<"limits", cca::limiter<tuning::arm_torque>>,
                           cca::node<"drive", tuning::virtual_axis>,
                           cca::wire<"plan.angle", "servo.reference">,
                           cca::wire<"drive.angle", "servo.measured">,
                           cca::wire<"servo.command", "limits.command">,
                           cca::wire<"limits.safe", "drive.torque">,
                           cca::test_input<"servo.reference", cca::up_to<0.2>>> {};

template <class Controller>
[[gnu::noinline]] void one_beat(Controller& c) {
  c.step();
}
template <class Graph>
void run(int beats, bool tests) {
  const auto c = std::make_unique<cca::controller<Graph>>();
  c->load();
  c->start();
  if constexpr (std::is_same_v<Graph, tested>)
    if (tests) {
      auto p = c->template get<"test_servo_reference">().p;
      p.signal = cca::test_signal::sine, p.amplitude = 0.1, p.duration = 600, p.run = 1;
      c->template set<"test_servo_reference">(p);
    }
  for (int k = 0; k < beats; ++k) one_beat(*c);
}

}  // namespace bench

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string_view what = argv[1];
  const int beats = std::atoi(argv[2]);
  if (what == "plain") bench::run<bench::plain>(beats, false);
  else if (what == "off" || what == "running") bench::run<bench::tested>(beats, what == "running");
  else return 2;
}
