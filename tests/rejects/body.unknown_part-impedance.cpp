// EXPECT: body\.unknown_part: the body robot has no part `hand` \(the name in cca::part<name, chain>\): it has `arm`
// A Cartesian impedance holds the end of a part, which it takes by the name of the part.
#include <cca/robot/compliance/compliance_spaces.hpp>

struct base : cca::frame<"base"> {};
struct hand : cca::frame<"hand"> {};
struct bend : cca::dimension<"bend"> {};

struct arm_chain : cca::serial_chain<base, hand, cca::axes<bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct robot : cca::body<base, cca::part<"arm", arm_chain>> {};

#if CCA_REJECT
cca::stiffness_at<cca::tip_of<robot, "hand">, base> stiffness;
#else
cca::stiffness_at<cca::tip_of<robot, "arm">, base> stiffness;
#endif
