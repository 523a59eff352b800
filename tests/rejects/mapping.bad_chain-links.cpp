// EXPECT: mapping\.bad_chain: the chain [a-z]+ has 1 `links` and 2 `joints`
// Behind each joint is a link, also behind one that moves with another.
#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<hip, knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
#if CCA_REJECT
  static constexpr std::array links{cca::link_inertia { 0.3, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0} }};
#else
  static constexpr std::array links{cca::link_inertia{0.3, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0}},
                                    cca::link_inertia{0.2, {0, 0, -0.05}, {1e-3, 1e-3, 1e-4, 0, 0, 0}}};
#endif
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
