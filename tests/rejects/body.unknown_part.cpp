// EXPECT: body\.unknown_part: the body robot has no part `hand` \(the name in cca::part<name, chain>\): it has `arm`
// The name in `tip` and `jacobian` is that of a part, not that of the frame in which it ends.
#include <cca/robot/body_pose.hpp>

struct base : cca::frame<"base"> {};
struct hand : cca::frame<"hand"> {};
struct bend : cca::dimension<"bend"> {};

struct arm_chain : cca::serial_chain<base, hand, cca::axes<bend>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0.3, 0, 0);
};
struct robot : cca::body<base, cca::part<"arm", arm_chain>> {};

#if CCA_REJECT
auto where(const cca::body_pose<robot>& now) { return now.tip<"hand">(); }
#else
auto where(const cca::body_pose<robot>& now) { return now.tip<"arm">(); }
#endif
