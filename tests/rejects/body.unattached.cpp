// EXPECT: body\.unattached: the part `thumb` hangs on nothing: its chain begins in the frame hand, which is neither the base of the body, trunk, nor the end of another part
// This finger lacks the arm that leads to its hand.
#include <cca/robot/body_components.hpp>

#include "parts.hpp"

struct hand : cca::frame<"hand"> {};
struct finger : cca::frame<"finger"> {};
struct shoulder : cca::dimension<"shoulder"> {};
struct grip : cca::dimension<"grip"> {};

struct arm : cca::serial_chain<trunk, hand, cca::axes<shoulder>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct thumb : cca::serial_chain<hand, finger, cca::axes<grip>> {
  static constexpr std::array joints{cca::revolute(cca::along_z)};
  static constexpr auto tip = cca::at(0.05, 0, 0);
};

#if CCA_REJECT
struct robot : cca::body<trunk, cca::part<"thumb", thumb>> {};
#else
struct robot : cca::body<trunk, cca::part<"arm", arm>, cca::part<"thumb", thumb>> {};
#endif

struct angles : cca::space<cca::joint_angles, cca::axes<shoulder, grip>> {};
struct finger_place : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct joints {
  auto process(cca::beat) -> cca::out<"angles", angles> { return {}; }
};
struct reach : cca::graph<cca::rate<1000>,
                          cca::node<"log", logbook>,
                          cca::node<"joints", joints>,
                          cca::node<"finger", cca::part_kinematics<robot, "thumb", angles, finger_place>>,
                          cca::wire<"joints.angles", "finger.angles">> {};

cca::controller<reach> c;
