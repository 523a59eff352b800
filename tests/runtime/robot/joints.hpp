#pragma once
// Two joints with their measurements and commands.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/cca.hpp>

namespace robot_test {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.8}, cca::velocity{-5, 4}, cca::torque{-3, 2},
                                             cca::torque_rate{-100, 200}, cca::stiffness{2, 60}};
};
struct fast_hip : cca::dimension<"fast_hip"> {
  static constexpr auto limits = cca::limits{cca::velocity{-5, 4}, cca::acceleration{-50, 40}};
};
struct knee : cca::dimension<"knee"> {  // its angle has no rate limit and never reaches 0
  static constexpr auto limits =
      cca::limits{cca::angle{-1.8, -0.2}, cca::torque{-3, 3}, cca::stiffness{0, 30}};
};

struct wheel : cca::dimension<"wheel"> {
  static constexpr auto limits = cca::limits{cca::velocity{-6, 6}};
};

template <class Domain>
struct leg : cca::space<Domain, cca::axes<hip, knee>, cca::rate<1000>> {};
struct leg_angles : leg<cca::joint_angles> {};
struct leg_torques : leg<cca::joint_torques> {};
struct hip_and_wheel : cca::space<cca::joint_velocities, cca::axes<fast_hip, wheel>, cca::rate<1000>> {};

// A leg that follows its command at once.
struct perfect_leg {
  auto sense() -> cca::out<"angles", leg_angles> { return at; }
  void act(cca::in<"command", leg_angles> to) {
    if (to.origin() != cca::never) at = to.vector();  // an initial value is no command
  }
  void on_fault() { ++stops; }
  leg_angles::vector_type at{0.1, -0.9};
  int stops = 0;
};

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                        inf = std::numeric_limits<double>::infinity();
inline constexpr std::int64_t millisecond = 1'000'000;

// A quantity of a user's own, and the one that limits how fast it changes.
struct inflow {
  double lower, upper;
  static constexpr std::string_view unit = "l/s";
  static constexpr auto on_nan = cca::nan_policy::zero;
};
struct filling {
  double lower, upper;
  using rate = inflow;
  static constexpr std::string_view unit = "l";
  static constexpr auto on_nan = cca::nan_policy::hold;
};
struct fillings : cca::detail::linear_domain {
  using quantity = filling;
  static constexpr bool actuated = true;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
struct tank : cca::dimension<"tank"> {
  static constexpr auto limits = cca::limits{filling{0, 10}, inflow{-20, 30}};
};
struct tank_level : cca::space<fillings, cca::axes<tank>, cca::rate<1000>> {};

}  // namespace robot_test
