// EXPECT: mapping\.bad_chain: the chain leg has no `tip`: add `static constexpr cca::placement tip = cca::at\(x, y, z\);`, its end in the last link
// LINES: 15
// A chain says where its end is. Here it is a part of a body.
#include <cca/cca.hpp>
#include <cca/robot/body_pose.hpp>

struct trunk : cca::frame<"trunk"> {};
struct paw : cca::frame<"paw"> {};
struct knee : cca::dimension<"knee"> {};

struct leg : cca::serial_chain<trunk, paw, cca::axes<knee>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
#if CCA_REJECT
#else
  static constexpr auto tip = cca::at(0, 0, -0.1);
#endif
};
struct robot : cca::body<trunk, cca::part<"leg", leg>> {};

auto paw_at(const cca::body_pose<robot>& now) { return now.tip<"leg">(); }
