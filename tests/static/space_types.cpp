// Spaces at compile time: sizes, zeros, limits, the results of their checks, samples.
#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/info.hpp>
#include <cca/space/sample.hpp>
#include <cca/space/units.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::torque{-3.0, 3.0}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct toe : cca::dimension<"toe"> {};
struct base : cca::frame<"base"> {};
struct other;
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct leg_torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};
struct toe_angles : cca::space<cca::joint_angles, cca::axes<hip, toe, knee>> {};
struct twice : cca::space<cca::joint_angles, cca::axes<hip, knee, hip>> {};
struct plain : cca::space<cca::number, cca::axes<toe>> {};
struct attitude : cca::space<cca::orientation<base>, xyz> {};
struct placed : cca::space<cca::pose<base>, xyz> {};
struct moving : cca::space<cca::twist<other, base>, xyz> {};
struct loaded : cca::space<cca::wrench<other, base>, xyz> {};
struct spring : cca::space<cca::cartesian_stiffness<other, base>, xyz> {};
struct damper : cca::space<cca::cartesian_damping<other, base>, xyz> {};
struct normal_force : cca::space<cca::cartesian_force<base>, cca::axes<cca::z>> {};
struct leg_damping : cca::space<cca::joint_damping, cca::axes<hip, knee>> {};
struct foot : cca::space<cca::cartesian_position<base>, cca::axes<cca::x, cca::z>> {};

// Coordinates.
static_assert(cca::Space<leg_angles> && leg_angles::size == 2);
static_assert(attitude::size == 4 && placed::size == 7 && moving::size == 6 && loaded::size == 6 &&
              foot::size == 2);
static_assert(cca::detail::zero_of<attitude> == std::array{0.0, 0.0, 0.0, 1.0});
static_assert(cca::detail::zero_of<placed> == std::array{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
static_assert(cca::detail::zero_of<leg_angles> == std::array{0.0, 0.0});
static_assert(spring::size == 6 && damper::size == 6 && normal_force::size == 1 && leg_damping::size == 2);
static_assert(cca::detail::space_of<leg_damping>.unit == "N m s/rad" &&
              cca::detail::space_of<normal_force>.unit == "N" &&
              cca::detail::space_of<spring>.coordinate_units[5] == "N/m" &&
              cca::detail::space_of<damper>.coordinates[0] == "rotational_x");
static_assert(cca::joint_damping::actuated && !spring::domain::actuated && !normal_force::domain::actuated);
static_assert(!cca::SameFrames<cca::cartesian_stiffness<other, base>, cca::cartesian_stiffness<base, other>>);
static_assert(cca::SameFrames<cca::cartesian_force<base>, cca::cartesian_position<base>>);
static_assert(cca::joint_stiffness::actuated && !cca::phase::actuated && !attitude::domain::actuated);

// Limits.
constexpr double infinite = std::numeric_limits<double>::infinity();
static_assert(cca::detail::lower_limits<leg_angles, cca::angle> == std::array{-0.9, -1.8});
static_assert(cca::detail::upper_limits<leg_angles, cca::angle> == std::array{0.9, 0.0});
static_assert(cca::detail::upper_limits<leg_angles, cca::torque> == std::array{3.0, infinite});
static_assert(cca::detail::lower_limits<leg_angles, cca::velocity> == std::array{-infinite, -infinite});

// Results of the checks.
static_assert(cca::detail::missing_limits<leg_angles> == -1);
static_assert(cca::detail::missing_limits<leg_torques> == 1);
static_assert(cca::detail::missing_limits<toe_angles> == 1);
static_assert(cca::detail::missing_limits<plain> == 0);
static_assert(cca::detail::space_of<toe_angles>.missing_limits == 1 &&
              cca::detail::space_of<twice>.duplicate_axis == 2);
static_assert(cca::detail::duplicate_axis<leg_angles> == -1 && cca::detail::duplicate_axis<plain> == -1);
static_assert(cca::detail::duplicate_axis<twice> == 2);

// Frames.
static_assert(base::name == "base");
static_assert(cca::SameFrames<cca::orientation<base>, cca::pose<base>>);
static_assert(!cca::SameFrames<cca::orientation<base>, cca::orientation<other>>);
static_assert(!cca::SameFrames<cca::twist<base, other>, cca::twist<other, base>>);
static_assert(cca::SameFrames<cca::joint_angles, cca::joint_angles>);

// A sample holds only its coordinates and a time; its methods take no memory.
static_assert(sizeof(cca::sample<attitude>) <= 3 * 16);
static_assert(sizeof(cca::sample<plain>) == 16);

// A sample is immutable: no coordinate can be written.
template <class Sample> concept Written = requires(Sample s) { s[hip{}] = 1.0; } || requires(Sample s) {
  s.vector()[0] = 1.0;
} || requires(Sample s) { s.vector() = s.vector(); } || requires(Sample s) { s.set(0, 1.0); };
static_assert(!Written<cca::sample<leg_angles>> && !Written<cca::sample<leg_angles>&>);
static_assert(Written<cca::out<"angles", leg_angles>&>);  // a component fills it
static_assert(
    std::is_convertible_v<cca::sample<leg_angles>, cca::sample<cca::sub_space<leg_angles, hip, knee>>>);
static_assert(!std::is_convertible_v<cca::sample<leg_angles>, cca::sample<leg_torques>>);
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<100>> {};
static_assert(!std::is_convertible_v<cca::sample<leg_angles>, cca::sample<slow_angles>>);

// Units: every quantity's list begins with its own unit and has an end.
template <class... Quantities>
constexpr bool listed() {
  return ((cca::Quantity<Quantities> && cca::units_of<Quantities>[0].text == Quantities::unit &&
           cca::units_of<Quantities>[0].factor == 1 &&
           std::end(cca::units_of<Quantities>)[-1].text.empty()) &&
          ...);
}
static_assert(listed<cca::angle,
                     cca::velocity,
                     cca::acceleration,
                     cca::jerk,
                     cca::torque,
                     cca::torque_rate,
                     cca::stiffness,
                     cca::damping,
                     cca::length,
                     cca::speed,
                     cca::force,
                     cca::linear_stiffness,
                     cca::linear_damping,
                     cca::mass,
                     cca::duration,
                     cca::power,
                     cca::voltage,
                     cca::current,
                     cca::frequency,
                     cca::value>());
struct flow {
  double lower, upper;
  static constexpr std::string_view unit = "m^3/s";
  static constexpr auto on_nan = cca::nan_policy::zero;
};
static_assert(listed<flow>(), "a quantity of the user's own");
static_assert(flow::on_nan == cca::nan_policy::zero);
static_assert(180 * cca::units_of<cca::angle>[2].factor == cca::pi);

}  // namespace
