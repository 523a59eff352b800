// Tutorial, step 7: an adaptive component learns to carry the leg's weight. docs/tutorial/7_adaptive.md
#include <cstdio>
#include <string>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/reaching_criterion.hpp>

#include "holding.hpp"
#include "simple_leg.hpp"

// [graph]
struct hold : cca::adaptive_component<holding, cca::reaching_goal<leg_angles>> {};

struct goal {
  auto process() -> cca::out<"posture", leg_target> { return posture; }
  Eigen::Vector2d posture{0, -0.5};
};

struct learning_leg : cca::graph<cca::rate<1000>,
                                 cca::node<"goal", goal>,
                                 cca::node<"hold", hold>,
                                 cca::node<"limits", cca::limiter<leg_currents>>,
                                 cca::node<"leg", simple_leg>,
                                 cca::wire<"goal.posture", "hold.reference">,
                                 cca::wire<"leg.angles", "hold.feedback">,
                                 cca::wire<"leg.velocities", "hold.velocities">,
                                 cca::wire<"hold.command", "limits.command">,
                                 cca::wire<"limits.safe", "leg.currents">,
                                 cca::observe<"hold.status.*">> {};
// [graph end]

// [program]
void move_to(cca::controller<learning_leg>& c, Eigen::Vector2d posture) {
  c.get<"goal">().posture = posture;
  c.run(cca::for_<3>{});
  std::string status;
  c.observed([&](const cca::observation& one) {
    if (one.path == "hold.status.component")
      status = to_string(static_cast<cca::component_status>(one.values[0]));
  });
  const double error = (c.get<"leg">().angles - posture).norm();
  std::printf("  to (%4.1f, %4.1f): %4.1f mrad off, %s\n", posture[0], posture[1], 1000 * error,
              status.c_str());
}

int main() {
  cca::controller<learning_leg> c;
  c.set<"hold.criterion">({{0.005, 0.01, 1.0, 0.1}});  // reached: within 5 mrad for 0.1 s
  c.load();
  c.start();
  std::printf("before:\n");
  move_to(c, {0.5, -0.8});
  move_to(c, {-0.4, -1.2});
  c.get<"hold.module">().learning.learn();
  std::printf("while it learns:\n");
  move_to(c, {0.5, -0.8});
  move_to(c, {-0.4, -1.2});
  c.get<"hold.module">().learning.rest();
  std::printf("afterwards, a posture that it has not held before:\n");
  move_to(c, {0.3, -0.2});
}
// [program end]
