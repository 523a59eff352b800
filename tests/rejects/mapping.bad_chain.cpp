// EXPECT: mapping\.bad_chain: joint 1 of the chain leg is driven by coordinate 1, and the chain has 1 axis \(hip\), counted from 0
// Each joint without `driven_by` has an axis of its own: two joints, and the chain has one axis.
#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};

#if CCA_REJECT
struct leg : cca::serial_chain<trunk, paw, cca::axes<hip>> {
#else
struct leg : cca::serial_chain<trunk, paw, cca::axes<hip, knee>> {
#endif
  static constexpr std::array joints{cca::revolute(cca::along_y),
                                     cca::revolute(cca::along_y, cca::at(0, 0, -0.1))};
  static constexpr auto tip = cca::at(0, 0, -0.1);
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
