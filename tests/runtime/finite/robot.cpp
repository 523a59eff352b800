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

// The same where the change of the rate is limited, and where an angle has no end.
struct smooth_hip : cca::dimension<"smooth_hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.8}, cca::velocity{-5, 4},
                                             cca::acceleration{-50, 40}, cca::jerk{-5000, 5000}};
};
struct spindle : cca::dimension<"spindle"> {
  static constexpr bool continuous = true;
  static constexpr auto limits = cca::limits{cca::velocity{-5, 4}};
};
struct smooth_angles : cca::space<cca::joint_angles, cca::axes<smooth_hip>, cca::rate<1000>> {};
struct spindle_angles : cca::space<cca::joint_angles, cca::axes<spindle, hip>, cca::rate<1000>> {};

// NaN makes it brake. After that it follows a noisy command from another place and speed than its twin.
struct smooth : limit<smooth_angles> {
  static constexpr bool forgets = false;
};

}  // namespace

TEST_CASE("robot/limiter.hpp") {
  laws::finite<limit<leg_angles>>();
  laws::finite<limit<leg_torques>>();
  laws::finite<smooth>();
  laws::finite<limit<spindle_angles>>();
}
