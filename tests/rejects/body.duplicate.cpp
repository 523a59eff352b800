// EXPECT: body\.duplicate: the parts `[a-z_ ]+` and `forearm` of this body share the axis turn; give each part axes of its own
// The coordinates of a body are the axes of its parts: an axis that two parts have would be two coordinates
// of one name.
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
#if CCA_REJECT
struct forearm : cca::serial_chain<elbow, hand, cca::axes<turn>> {
#else
struct forearm : cca::serial_chain<elbow, hand, cca::axes<bend>> {
#endif
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.2, 0, 0);
};

struct arm : cca::body<base, cca::part<"upper arm", upper_arm>, cca::part<"forearm", forearm>> {};
