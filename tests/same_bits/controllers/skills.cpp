// The controller of examples/combination_of_skills, told what a robot sensed and its camera saw. It reads the
// shape of its trot from trot.shape, in the folder in which it runs.
//
//   topics: /robot/angles/whole /robot/abducted/whole /robot/simulator/orientation
//           /robot/simulator/angular_velocity /robot/simulator/contacts /camera/ball
#include "told.hpp"

#include "../../../examples/combination_of_skills/architecture.hpp"

namespace oncilla = cca::robots::oncilla;

struct told_robot {
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", oncilla::leg_angles>,
                                          cca::out<"abducted", oncilla::abduction_angles>,
                                          cca::out<"orientation", oncilla::trunk_orientation>,
                                          cca::out<"angular_velocity", oncilla::trunk_angular_velocity>,
                                          cca::out<"contacts", oncilla::foot_contacts>> {
    ball_seen = false;
    same_bits::all_sensed().of_beat(now.index(), [this](const same_bits::entry& e) {
      if (e.topic == 0) same_bits::put(e, angles);
      else if (e.topic == 1) same_bits::put(e, abducted);
      else if (e.topic == 2) same_bits::put(e, orientation);
      else if (e.topic == 3) same_bits::put(e, angular_velocity);
      else if (e.topic == 4) same_bits::put(e, contacts);
      else same_bits::put(e, ball), ball_seen = true;
    });
    return {angles, abducted, orientation, angular_velocity, contacts};
  }
  void act(cca::in<"command", oncilla::leg_angles>,
           cca::in<"abduction", oncilla::abduction_angles>,
           cca::in<"stiffness", oncilla::hip_stiffnesses>) {}

  oncilla::leg_angles::vector_type angles = oncilla::leg_angles::vector_type::Zero();
  oncilla::abduction_angles::vector_type abducted = oncilla::abduction_angles::vector_type::Zero();
  Eigen::Vector4d orientation{0, 0, 0, 1};
  Eigen::Vector3d angular_velocity{0, 0, 0}, ball{0, 0, 0};
  oncilla::foot_contacts::vector_type contacts = oncilla::foot_contacts::vector_type::Zero();
  bool ball_seen = false;
};

// The robot senses first, and reads for both.
inline const told_robot* robot = nullptr;
struct told_camera {
  auto sense() -> cca::maybe<"ball", skills::point_in_trunk> {
    if (!robot->ball_seen) return {};
    return robot->ball;
  }
};

struct told_skills : skills::architecture<told_robot, told_camera>, cca::recordable {};

int main() {
  return same_bits::run<told_skills>(
      [](auto& c) {
        robot = &c.template get<"robot">();
        if (!c.template get<"dmp.module">().p.files.load.assign("trot.shape"))
          throw cca::refused("trot.shape: this name is too long");
      },
      [](auto&) {});
}
