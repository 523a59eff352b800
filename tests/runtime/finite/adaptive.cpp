// The components of adaptive/ under the laws of finite numbers.
#include <cca/adaptive.hpp>

#include "../../laws/finite_laws.hpp"

namespace {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct jaw : cca::dimension<"jaw"> {};
struct trunk : cca::frame<"trunk"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct paw : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct turn : cca::space<cca::orientation<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
struct stride : cca::space<cca::phase, cca::axes<hip, knee>> {};
struct aperture : cca::space<cca::joint_angles, cca::axes<jaw>> {};
struct grip : cca::space<cca::joint_torques, cca::axes<jaw>> {};

// A criterion says `lost`, and its hold time begins again.
template <class Type>
struct criterion : laws::finite_case<Type> {
  static constexpr bool says_unreadable = false;
  static constexpr int settles_in = 200;
  static auto made() {
    auto c = std::make_unique<Type>();
    if constexpr (requires { c->p.limits; })
      c->p.limits = {5.0, 6.0, 1e6, 0.01};  // all usual errors are near
    return c;
  }
};

struct status_case : laws::finite_case<cca::status_of_component<true>> {
  static constexpr bool says_unreadable = false, passes_nan = true;  // it passes its inputs on
};

}  // namespace

TEST_CASE("adaptive/tracking.hpp") {
  laws::finite<criterion<cca::tracking<leg>>>();
  laws::finite<criterion<cca::tracking<paw>>>();
  laws::finite<criterion<cca::tracking<turn>>>();
  laws::finite<criterion<cca::tracking<stride>>>();
}
TEST_CASE("adaptive/reaching_criterion.hpp") { laws::finite<criterion<cca::reaching_goal<paw>>>(); }
TEST_CASE("adaptive/grasping.hpp") { laws::finite<criterion<cca::grasping<aperture, grip>>>(); }
TEST_CASE("adaptive/component_status.hpp") { laws::finite<status_case>(); }
