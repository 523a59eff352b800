// A floating robot of 1 kg, with a flag on it that hardly weighs: what the robots of several tests have
// beside their shapes.
#pragma once

#include <array>

#include <cca/cca.hpp>
#include <cca/robots/description.hpp>

namespace any_robot_test {

struct room {};
struct tip_frame {};
struct flag : cca::dimension<"flag"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.1, 0.1}, cca::torque{-1, 1}};
};
struct flag_chain : cca::serial_chain<room, tip_frame, cca::axes<flag>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0, 0, 0);
  static constexpr std::array links{cca::link_inertia{1e-3, {}, {1e-5, 1e-5, 1e-5}}};
};
struct flagged_body : cca::body<room, cca::part<"flag", flag_chain>> {
  static constexpr cca::link_inertia base{0.999, {}, {0.01, 0.01, 0.02}};
};
struct flagged {
  using body = flagged_body;
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
  static constexpr bool floats = true;
  static constexpr std::array<cca::robots::joint_drive, 1> drives{{{.motor = {1, 10}}}};
};

}  // namespace any_robot_test
