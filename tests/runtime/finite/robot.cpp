// The components of robot/ under the laws of finite numbers: what stands between a controller and the drives.
#include <cca/robot/body_components.hpp>
#include <cca/robot/limiter.hpp>

#include "../../laws/finite_laws.hpp"
#include "../robot/joints.hpp"

namespace {

using namespace robot_test;

// It counts its interventions and has no status; what it held meanwhile it leaves at its rates.
template <class Space>
struct limit : laws::finite_case<cca::limiter<Space>> {
  static constexpr bool says_unreadable = false;
  static constexpr int settles_in = 2000;
};

}  // namespace

TEST_CASE("robot/limiter.hpp") {
  laws::finite<limit<leg_angles>>();
  laws::finite<limit<leg_torques>>();
}
