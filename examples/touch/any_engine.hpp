#pragma once
// One run of the demonstrator in a simulator, whatever its physics. It needs no engine; rollout.hpp has the
// Open Dynamics Engine's arm.
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "architecture.hpp"
#include "learn.hpp"
#include "referee.hpp"
#include "scene.hpp"

namespace touch {

// Where the arm is: in the simulator of either engine, as a node of the controller.
struct in_simulator {
  template <class Controller, class World>
  static void put_down(Controller& c, World&& world) {
    c.template get<"robot.simulator">().put_down(std::forward<World>(world));
  }
  template <class Controller>
  static auto& world(Controller& c) {
    return c.template get<"robot.simulator">().world();
  }
  template <class Controller>
  static void after_beat(Controller&) {}
};

// What happens around the arm in a run, beat by beat. A value: a copy goes on from here.
class course {
public:
  explicit course(std::uint64_t seed) : around(seed) {}

  template <class World>
  void before_beat(World& world) {
    around.act(world, step, in_step());
  }
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
  using world_type = std::remove_cvref_t<decltype(place.world(c))>;
  place.put_down(c, scene::arm_in_room<world_type>());
  auto orders = c.template get<"orders">().p;
  orders.shift = run.around.shift;
  c.template set<"orders">(orders);
  referee judge(seed, c.template get<"guard">().p.energy);
  c.start();
  constexpr int most_beats = 90'000, stopped_for = 2000;
  for (int k = 0, stopped = 0; k < most_beats && stopped < stopped_for; ++k) {
    world_type& world = place.world(c);
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
