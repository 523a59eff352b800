// A leg that a ROS 2 system commands and watches: `ros2_leg` runs until a signal, `ros2_leg --seconds 10` for
// ten seconds; --help lists the options.
//
//   leg_command    sensor_msgs/JointState   in: the angles to reach
//   joint_states   sensor_msgs/JointState   out: angles and velocities, a hundred times a second
//
// docs/ros2.md says how to use it.
#include <cstdio>
#include <string>
#include <tuple>

#include <cca/cca.hpp>
#include <cca/main.hpp>
#include <cca/ros2.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>  // offers --record
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

// [ros2]
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}, cca::velocity{-4, 4}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}, cca::velocity{-4, 4}};
};
using joints = cca::axes<hip, knee>;  // their names are those of the joints in ROS 2
struct leg_angles : cca::space<cca::joint_angles, joints, cca::rate<1000>> {};
struct leg_velocities : cca::space<cca::joint_velocities, joints, cca::rate<1000>> {};

struct leg {  // stands for a robot: it reaches each command in one beat
  auto sense(cca::beat now)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"velocities", leg_velocities>> {
    const Eigen::Vector2d moved = at - before;
    before = at;
    return {at, (moved / now.dt()).eval()};
  }
  void act(cca::in<"command", leg_angles> to) {
    if (to.origin() != cca::never) at = to.vector();
  }
  void on_fault() {}  // it stands still
  Eigen::Vector2d at{0, -0.9}, before{0, -0.9};
};

using command = cca::ros2::joint_state<leg_angles>;
using states = cca::ros2::joint_state<leg_angles, leg_velocities>;

struct commanded_leg
    : cca::graph<cca::node<"command", cca::ros2::subscriber<"leg_command", command>>,
                 cca::node<"limits", cca::limiter<leg_angles>>,
                 cca::node<"leg", leg>,
                 cca::node<"states", cca::ros2::publisher<"joint_states", states>, cca::timed<10>>,
                 cca::wire<"command.position", "limits.command">,
                 cca::wire<"leg.angles", "limits.measured">,
                 cca::wire<"limits.safe", "leg.command">,
                 cca::wire<"leg.angles", "states.position", cca::latest>,
                 cca::wire<"leg.velocities", "states.velocity", cca::latest>> {};
// [ros2 end]

namespace {

struct recorded_leg : commanded_leg, cca::recordable, cca::traceable {};

struct program : cca::robot_program<recorded_leg> {
  program() { purpose = "a leg that a ROS 2 system commands and watches"; }

  int finish(controller_type& c) override {
    // [counts]
    const auto& heard = c.get<"command">();
    std::printf("sent %lld, received %lld, refused %lld", static_cast<long long>(c.get<"states">().sent()),
                static_cast<long long>(heard.received()), static_cast<long long>(heard.refused()));
    if (heard.refused() > 0) std::printf(" (%s)", std::string(heard.why_refused()).c_str());
    std::printf("; hip %.3f rad, knee %.3f rad\n", c.get<"leg">().at[0], c.get<"leg">().at[1]);
    // [counts end]
    return 0;
  }
};

}  // namespace

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
