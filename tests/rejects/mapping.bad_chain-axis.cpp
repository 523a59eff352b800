// EXPECT: mapping\.bad_chain: joint 0 of the chain leg has the axis \(0, 0, 0\), which is no direction
// A joint turns about its axis, or moves along it.
#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct hip : cca::dimension<"hip"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<hip>> {
#if CCA_REJECT
  static constexpr std::array joints{cca::revolute({0, 0, 0})};
#else
  static constexpr std::array joints{cca::revolute({0, 2, 0})};  // its length does not matter
#endif
  static constexpr auto tip = cca::at(0, 0, -0.1);
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
