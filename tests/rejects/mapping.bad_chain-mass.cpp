// EXPECT: mapping\.bad_chain: link 0 of the chain leg has a mass below 0: masses are in kg, and 0 is
// What weighs less than nothing is a mistake in signs.
#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct hip : cca::dimension<"hip"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<hip>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, -0.1);
#if CCA_REJECT
  static constexpr std::array links{cca::link_inertia { -0.3, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0} }};
#else
  static constexpr std::array links{cca::link_inertia{0.3, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0}}};
#endif
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
