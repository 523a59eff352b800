// EXPECT: body\.unknown_axis: joint 1 of the part `[a-z_]+` is driven by coordinate 1, and its chain has 1 axis \([a-z_]+\), counted from 0
// Two joints of a leg turn with one motor. Coordinates count from 0, so with one axis there is no
// coordinate 1.
#include <cca/robot/body_pose.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct knee : cca::dimension<"knee"> {};

struct leg_chain : cca::serial_chain<trunk, paw, cca::axes<knee>> {
#if CCA_REJECT
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1)).driven_by(1, -1)};
#else
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1)).driven_by(0, -1)};
#endif
  static constexpr auto tip = cca::at(0, 0, -0.1);
};
struct robot : cca::body<trunk, cca::part<"leg", leg_chain>> {};

const cca::body_pose<robot> straight(cca::body_pose<robot>::vector_type::Zero());
