// A simulated Oncilla walks by a policy that was trained with PyTorch; when its gyroscope fails, it stands.
// docs/tutorial/10_policy.md.
//
//   pytorch_walk build/walk.policy
#include <cstdio>
#include <exception>
#include <limits>
#include <string>

#include <cca/mapping/imported/policy_watchdog.hpp>
#include <cca/mapping/imported/setpoint_blend.hpp>
#include <cca/modes.hpp>
#include <cca/sim/oncilla/compiled_oncilla.hpp>

#include "../trot/engines/any.hpp"
#include "../walking_policy/teacher.hpp"
#include "robot.hpp"

#include "walk.hpp"  // by cca-policy, from walk.onnx

namespace {

using namespace pytorch_walk;

// [policy]
struct walking : cca::imported_policy<walk::contract, observations, targets> {};

// A sensor that can fail.
struct gyroscope {
  auto process(cca::in<"rates", oncilla::trunk_angular_velocity> w)
      -> cca::out<"rates", oncilla::trunk_angular_velocity> {
    if (fails) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()).eval();
    return w.vector();
  }
  bool fails = false;
};
// [policy end]

// [modes]
using blend = cca::setpoint_blend<oncilla::leg_angles>;

template <class... Items>
using mode_of = cca::graph<cca::rate<1000>,
                           Items...,
                           cca::node<"blend", blend, cca::timed<1>>,
                           cca::node<"limits", cca::limiter<oncilla::leg_angles>>,
                           cca::node<"robot", cca::sim::compiled_oncilla>,
                           cca::wire<"robot.angles", "blend.measured">,
                           cca::wire<"blend.target", "limits.command">,
                           cca::wire<"robot.angles", "limits.measured">,
                           cca::wire<"limits.safe", "robot.command">>;

struct walk_mode
    : mode_of<cca::node<"gait", gait_of<walking, cca::expose<"policy.term", "term">>>,
              cca::node<"gyroscope", gyroscope, cca::timed<1>>,
              cca::node<"setpoints",
                        cca::policy_setpoints<walk::contract, oncilla::leg_angles, oncilla::leg_angles>,
                        cca::timed<1>>,
              cca::node<"watchdog", cca::policy_watchdog<walking, "stand">, cca::timed<1>>,
              cca::wire<"robot.orientation", "gait.orientation", cca::latest>,
              cca::wire<"robot.angular_velocity", "gyroscope.rates">,
              cca::wire<"gyroscope.rates", "gait.rates", cca::latest>,
              cca::wire<"robot.angles", "gait.angles", cca::latest>,
              cca::wire<"gait.status", "watchdog.status", cca::latest>,
              cca::wire<"gait.term", "watchdog.term", cca::latest>,
              cca::wire<"gait.command", "setpoints.target">,
              cca::wire<"setpoints.target", "blend.target">,
              cca::wire<"setpoints.stiffness", "blend.stiffness">,
              cca::wire<"setpoints.damping", "blend.damping">,
              cca::wire<"setpoints.begins", "blend.begins">> {};

struct stand_mode : mode_of<cca::node<"stand", cca::standing_setpoints<oncilla::leg_angles>, cca::timed<1>>,
                            cca::wire<"blend.target", "stand.applied", cca::delayed<1>>,
                            cca::wire<"robot.angles", "stand.measured">,
                            cca::wire<"stand.target", "blend.target">,
                            cca::wire<"stand.stiffness", "blend.stiffness">,
                            cca::wire<"stand.damping", "blend.damping">,
                            cca::wire<"stand.begins", "blend.begins">> {};

struct quadruped : cca::modes<cca::mode<"walk", walk_mode>, cca::mode<"stand", stand_mode>> {};
// [modes end]

// [program]
int run(const char* weights) {
  cca::controller<quadruped> c;
  c.get<"gait.policy">().read(weights);
  c.load();
  auto stands = c.get<"stand">().p;
  stands.pose << 0.794, 0.794, 0.630, 0.630, 1.627, 1.627, 1.518, 1.518;
  c.set<"stand">(stands);
  c.get<"robot.simulator">().put_down(cca::sim::compiled_oncilla_world(
      cca::sim::terrain::flat(), trot::put_down(::walking::teacher().p, {})));
  c.start();
  const auto& world = c.get<"robot.simulator">().world();
  for (int second = 1; second <= 8; ++second) {
    c.run(cca::for_<1>{});
    std::printf("%d s  %-5s %.1f m%s\n", second, std::string(c.mode()).c_str(), world.trunk_position()[0],
                world.fallen() ? ", fallen" : "");
    if (second == 6) c.get<"gyroscope">().fails = true;
  }
  std::printf("%s\n", c.get<"watchdog">().cause().c_str());
  return world.fallen() ? 1 : 0;
}
// [program end]

}  // namespace

int main(int count, char** words) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: pytorch_walk FILE of the weights that cca-policy wrote\n");
    return 2;
  }
  return run(words[1]);
} catch (const std::exception& e) {
  std::fprintf(stderr, "pytorch_walk: %s\n", e.what());
  return 1;
}
