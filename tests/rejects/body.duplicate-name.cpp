// EXPECT: body\.duplicate: two parts of this body are named `arm`, by which kinematics and descriptions find them
// Kinematics, springs and sensors find a part by its name.
#include <cca/robot/body.hpp>

struct base : cca::frame<"base"> {};
struct elbow : cca::frame<"elbow"> {};
struct hand : cca::frame<"hand"> {};
struct bend : cca::dimension<"bend"> {};
struct turn : cca::dimension<"turn"> {};

struct upper_arm : cca::serial_chain<base, elbow, cca::axes<turn>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct forearm : cca::serial_chain<elbow, hand, cca::axes<bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.2, 0, 0);
};

#if CCA_REJECT
struct arm : cca::body<base, cca::part<"arm", upper_arm>, cca::part<"arm", forearm>> {};
#else
struct arm : cca::body<base, cca::part<"upper arm", upper_arm>, cca::part<"forearm", forearm>> {};
#endif
