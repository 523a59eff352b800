#pragma once
// One run of the demonstrator in the simulator.
#include <memory>
#include <string>
#include <utility>

#include <cca/sim/robot.hpp>

#include "architecture.hpp"
#include "learn.hpp"
#include "referee.hpp"
#include "scene.hpp"

namespace touch {

struct simulated : architecture<cca::sim::robot<arm::description>> {};

// Where the arm is: in the simulator, as a node of the controller.
struct in_simulator {
  template <class Controller>
  static void put_down(Controller& c, arm_world&& world) {
    c.template get<"robot.simulator">().put_down(std::move(world));
  }
  template <class Controller>
  static arm_world& world(Controller& c) {
    return c.template get<"robot.simulator">().world();
  }
  template <class Controller>
  static void after_beat(Controller&) {}
};

// What happens around the arm in a run, beat by beat. A value: a copy goes on from here.
class course {
public:
  explicit course(std::uint64_t seed) : around(seed) {}

  void before_beat(arm_world& world) { around.act(world, step, in_step()); }
  // Learns, where the plan says so.
  template <class Controller>
  void after_beat(Controller& c) {
    ++beats;
    const int now = c.template get<"sequencer">().steps.step();
    if (now == step) return;
    step = now, began = beats;
    if (step == plan::at<"learn">) learn(c);
  }

  double in_step() const { return 0.001 * (beats - began); }  // s since the step began

  scene around;
  int step = 0;  // of the plan

private:
  int beats = 0, began = 0;
};

// `between(controller, step)` after each beat; the run ends early if it returns false. `Place`: where the arm
// is.
template <class Controller, class Between, class Place = in_simulator>
result roll_out(Controller& c, std::uint64_t seed, Between between, Place&& place = {}) {
  course run(seed);
  place.put_down(c, arm_world(cca::sim::model_of<arm::description>(), scene::room()));
  auto orders = c.template get<"orders">().p;
  orders.shift = run.around.shift;
  c.template set<"orders">(orders);
  referee judge(seed, c.template get<"guard">().p.energy);
  c.start();
  constexpr int most_beats = 90'000, stopped_for = 2000;
  for (int k = 0, stopped = 0; k < most_beats && stopped < stopped_for; ++k) {
    arm_world& world = place.world(c);
    run.before_beat(world);
    c.step();
    place.after_beat(c);
    if (c.state() == cca::state::faulted) break;
    judge.note(c, world, run.around, run.step, run.in_step(), stopped > stopped_for / 2);
    run.after_beat(c);
    if (run.step == plan::at<"rest">) {
      c.template get<"operator">().pressed = true;
      // Somebody pulls at the stopped arm, and lets go.
      run.around.another = ++stopped < 300 ? Eigen::Vector3d(10, 10, 0) : Eigen::Vector3d(0, 0, 0);
    }
    if (!between(c, run.step)) break;
  }
  c.stop();
  return judge.end();
}

}  // namespace touch
