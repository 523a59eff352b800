// EXPECT: mapping\.bad_chain: the chain leg has no `joints`: add `static constexpr std::array joints\{\.\.\.\};`, with one cca::revolute or cca::prismatic for each axis
// LINES: 15
// A chain lists its joints.
#include <cca/mapping/kinematics.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct knee : cca::dimension<"knee"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<knee>> {
#if CCA_REJECT
#else
  static constexpr std::array joints{cca::revolute(cca::along_y)};
#endif
  static constexpr auto tip = cca::at(0, 0, -0.1);
};

auto paw_at(const cca::chain_pose<leg>& now) { return now.tip(); }
