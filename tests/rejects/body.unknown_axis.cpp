// EXPECT: body\.unknown_axis: joint 0 of the part `right finger` follows the axis `finger` \(`driven_by`\), which no part of the body has: it has `left_finger`
// The right finger moves with the left one, whose axis is called left_finger.
#include <cca/robot/body_pose.hpp>

struct palm : cca::frame<"palm"> {};
struct left_tip : cca::frame<"left tip"> {};
struct right_tip : cca::frame<"right tip"> {};
struct left_finger : cca::dimension<"left_finger"> {};

struct left_chain : cca::serial_chain<palm, left_tip, cca::axes<left_finger>> {
  static constexpr std::array joints{cca::prismatic(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, 0.05);
};
struct right_chain : cca::serial_chain<palm, right_tip, cca::axes<>> {
#if CCA_REJECT
  static constexpr std::array joints{cca::prismatic(cca::along_y).driven_by("finger", -1)};
#else
  static constexpr std::array joints{cca::prismatic(cca::along_y).driven_by("left_finger", -1)};
#endif
  static constexpr auto tip = cca::at(0, 0, 0.05);
};
struct gripper
    : cca::body<palm, cca::part<"left finger", left_chain>, cca::part<"right finger", right_chain>> {};

const cca::body_pose<gripper> closed(cca::body_pose<gripper>::vector_type::Zero());
