// EXPECT: mapping\.bad_chain: joint 0 of the chain leg has a number that is not finite: look for a NaN
// The numbers of a joint are constants, and none is NaN or infinite.
#include <limits>

#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct hip : cca::dimension<"hip"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<hip>> {
#if CCA_REJECT
  static constexpr double length = std::numeric_limits<double>::quiet_NaN();
#else
  static constexpr double length = 0.2;
#endif
  static constexpr std::array joints{cca::revolute(cca::along_y, cca::at(0, 0, length))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
