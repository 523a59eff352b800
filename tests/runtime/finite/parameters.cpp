// `parameters values;` leaves no field without a value, in those components that are not under the laws of
// finite numbers.
#include <cca/cca.hpp>
#include <cca/hardware/robot/safety_chain.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>
#include <cca/skeleton/arbiter.hpp>
#include <cca/skeleton/blend.hpp>
#include <cca/skeleton/switch_between.hpp>

#include "../../../examples/hardware_in_the_loop/robot.hpp"
#include "../../laws/parameter_laws.hpp"

namespace {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

template <class Component>
void check() {
  laws::begins_with_values<typename Component::parameters>();
}

struct forgotten {
  BOOST_HANA_DEFINE_STRUCT(forgotten, (cca::bounded<double, 0, 1>, known), (double, unknown));
};
struct forgotten_choice {
  BOOST_HANA_DEFINE_STRUCT(forgotten_choice, (Eigen::Vector2d, unknown), (bool, other));
};
struct stated {
  BOOST_HANA_DEFINE_STRUCT(stated, (double, known), (cca::gait, choice));
  stated(double one = 1, cca::gait two = cca::gait::trot) : known(one), choice(two) {}
};

}  // namespace

TEST_CASE("parameters begin with values: skeletons, bodies and guards") {
  check<cca::detail::blend_of_two<"y", leg, leg, "a", "b">>();
  laws::begins_with_values<cca::gravity_parameters>();
  laws::begins_with_values<cca::ode_settling>();
  laws::begins_with_values<cca::learned_files>();
  check<cca::hardware::stale_guard<hil::joints>>();
  check<cca::hardware::rate_guard<hil::joints>>();
}

TEST_CASE("parameters begin with values: a field without one is noticed") {
  using laws::detail::bits_of_new;
  CHECK(bits_of_new<forgotten>(std::byte{0xFF}) != bits_of_new<forgotten>(std::byte{0x55}));
  CHECK(bits_of_new<forgotten_choice>(std::byte{0xFF}) != bits_of_new<forgotten_choice>(std::byte{0x55}));
  CHECK(bits_of_new<stated>(std::byte{0xFF}) == bits_of_new<stated>(std::byte{0x55}));
}

TEST_CASE("parameters of a pid that a user makes are the defaults") {
  using servo = cca::pid<leg, torques>;
  servo::parameters values;
  CHECK(values.proportional == Eigen::Vector2d::Ones());
  CHECK(values.integral == Eigen::Vector2d::Zero());
  CHECK(values.largest == Eigen::Vector2d::Constant(1e30));
  CHECK(values.tracking == 0.1);
  const servo::parameters stiff{{20, 30}};
  CHECK(stiff.proportional == Eigen::Vector2d(20, 30));
  CHECK(stiff.derivative == Eigen::Vector2d::Zero());
}
