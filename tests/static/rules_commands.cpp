// Rules about commands to actuators: the message of each mistake, and that the mended graph is sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

struct toe_angle : cca::space<cca::joint_angles, cca::axes<hip, toe>> {};

struct no_limits : khz<cca::node<"a", source<toe_angle>>,
                       cca::node<"l", cca::limiter<toe_angle>>,
                       cca::node<"r", robot<toe_angle>>,
                       cca::wire<"a.y", "l.command">,
                       cca::wire<"l.safe", "r.command">> {};
struct no_limits_mended : khz<cca::node<"a", source<angles>>,
                              cca::node<"l", cca::limiter<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "l.command">,
                              cca::wire<"l.safe", "r.command">> {};
static_assert(tells<no_limits, no_limits_mended>(
    {"space.missing_limits", "l.command",
     "`l.command` takes commands of toe_angle, but its axis `toe` states no limits of angle to keep them "
     "within: add `static constexpr auto limits = cca::limits{cca::angle{lower, upper}};` to it"}));

struct no_limits_of_torque : khz<cca::node<"a", source<torques>>,
                                 cca::node<"r", robot<torques>>,
                                 cca::node<"u", cca::unlimited<torques>>,
                                 cca::wire<"a.y", "u.command">,
                                 cca::wire<"u.safe", "r.command">> {};
struct no_limits_of_torque_mended : khz<cca::node<"a", source<angles>>,
                                        cca::node<"u", cca::unlimited<angles>>,
                                        cca::node<"r", robot<>>,
                                        cca::wire<"a.y", "u.command">,
                                        cca::wire<"u.safe", "r.command">> {};
static_assert(tells<no_limits_of_torque, no_limits_of_torque_mended>(
    {"space.missing_limits", "r.command",
     "`r.command` takes commands of torques, but its axis `hip` states no limits of torque to keep them "
     "within: add `static constexpr auto limits = cca::limits{cca::torque{lower, upper}};` to it"}));

template <class Wheel>
struct over : cca::space<cca::joint_angles, cca::axes<Wheel>> {};
struct free_wheel : cca::dimension<"wheel"> {
  static constexpr bool continuous = true;
};
struct wheel : free_wheel {
  static constexpr auto limits = cca::limits{cca::velocity{-9, 9}};
};
struct free_wheel_angle : over<free_wheel> {};
struct wheel_angle : over<wheel> {};

// The angle of a continuous axis has no limits of its own: a limiter bounds its velocity.
template <class Space>
struct limited : khz<cca::node<"a", source<Space>>,
                     cca::node<"l", cca::limiter<Space>>,
                     cca::node<"r", robot<Space>>,
                     cca::wire<"a.y", "l.command">,
                     cca::wire<"l.safe", "r.command">> {};
static_assert(tells<limited<free_wheel_angle>, limited<wheel_angle>>(
    {"space.missing_limits", "l.command",
     "`l.command` takes commands of free_wheel_angle, but its axis `free_wheel` states no limits of "
     "velocity to keep them within: add `static constexpr auto limits = cca::limits{cca::velocity{lower, "
     "upper}};` to it"}));

struct unlimited
    : khz<cca::node<"a", source<angles>>, cca::node<"r", robot<>>, cca::wire<"a.y", "r.command">> {};
struct unlimited_mended : khz<cca::node<"a", source<angles>>,
                              cca::node<"u", cca::unlimited<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "u.command">,
                              cca::wire<"u.safe", "r.command">> {};
static_assert(tells<unlimited, unlimited_mended>(
    {"robot.unlimited_command", "a.y -> r.command",
     "`a.y` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> between "
     "them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct unlimited_behind : khz<cca::node<"a", source<angles>>,
                              cca::node<"l", cca::limiter<angles>>,
                              cca::node<"s", step<angles>>,
                              cca::node<"r", robot<>>,
                              cca::wire<"a.y", "l.command">,
                              cca::wire<"l.safe", "s.x">,
                              cca::wire<"s.y", "r.command">> {};
struct unlimited_behind_mended : khz<cca::node<"a", source<angles>>,
                                     cca::node<"l", cca::limiter<angles>>,
                                     cca::node<"s", cca::splitter<"angles", angles>>,
                                     cca::node<"c", cca::collector<"angles", angles>>,
                                     cca::node<"r", robot<>>,
                                     cca::wire<"a.y", "l.command">,
                                     cca::wire<"l.safe", "s.angles">,
                                     cca::wire<"s.hip", "c.hip">,
                                     cca::wire<"s.knee", "c.knee">,
                                     cca::wire<"c.angles", "r.command">> {};
static_assert(tells<unlimited_behind, unlimited_behind_mended>(
    {"robot.unlimited_command", "s.y -> r.command",
     "`s.y` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> between "
     "them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct unlimited_measured : khz<cca::node<"r", robot<>>, cca::wire<"r.measured", "r.command">> {};
struct unlimited_measured_mended : khz<cca::node<"r", robot<>>,
                                       cca::node<"l", cca::limiter<angles>>,
                                       cca::wire<"r.measured", "l.command">,
                                       cca::wire<"l.safe", "r.command">> {};
static_assert(tells<unlimited_measured, unlimited_measured_mended>(
    {"robot.unlimited_command", "r.measured -> r.command",
     "`r.measured` reaches the actuator `r.command` without passing a limiter: put a cca::limiter<angles> "
     "between them (its input is `command`, its output `safe`), or a cca::unlimited where that is meant"}));

struct limited_later : khz<cca::node<"a", source<angles>, cca::timed<10, 9>>,
                           cca::node<"l", cca::limiter<angles>>,
                           cca::node<"r", robot<>>,
                           cca::wire<"a.y", "l.command">,
                           cca::wire<"l.safe", "r.command", cca::latest, cca::initial<0.5, 0.5>>> {};
struct limited_later_mended : khz<cca::node<"a", source<angles>, cca::timed<10, 9>>,
                                  cca::node<"l", cca::limiter<angles>>,
                                  cca::node<"r", robot<>>,
                                  cca::wire<"a.y", "l.command">,
                                  cca::wire<"l.safe", "r.command", cca::latest, cca::initial<0.5, -0.5>>> {};
static_assert(tells<limited_later, limited_later_mended>(
    {"robot.unlimited_command", "l.safe -> r.command",
     "`r.command` may be read before a first command has passed a limiter, and would then hold the "
     "cca::initial of its wire, which lies outside of the limits of `knee`, on its way to the actuator: give "
     "the wire a cca::initial<...> within them"}));

// The same on any wire between a limiter and the actuator.
template <class Initial>
struct limited_before : khz<cca::node<"a", source<angles>, cca::timed<10, 9>>,
                            cca::node<"l", cca::limiter<angles>>,
                            cca::node<"s", cca::splitter<"angles", angles>, cca::timed<1>>,
                            cca::node<"r", robot<cca::sub_space<angles, knee>>>,
                            cca::wire<"a.y", "l.command">,
                            cca::wire<"l.safe", "s.angles", cca::latest, Initial>,
                            cca::wire<"s.knee", "r.command">> {};
static_assert(tells<limited_before<cca::initial<0.5, 0.5>>, limited_before<cca::initial<0.5, -0.5>>>(
    {"robot.unlimited_command", "l.safe -> s.angles",
     "`s.angles` may be read before a first command has passed a limiter, and would then hold the "
     "cca::initial of its wire, which lies outside of the limits of `knee`, on its way to the actuator "
     "`r.command`: give the wire a cca::initial<...> within them"}));

// Never read, and so no matter.
struct limited_at_once : khz<cca::node<"a", source<angles>>,
                             cca::node<"l", cca::limiter<angles>>,
                             cca::node<"r", robot<>>,
                             cca::wire<"a.y", "l.command">,
                             cca::wire<"l.safe", "r.command", cca::initial<0.5, 0.5>>> {};
static_assert(cca::well_formed<limited_at_once>);

// Every command that is merged passes a limiter.
template <cca::fixed_string Second>
struct merged_commands : khz<cca::node<"a", source<angles>>,
                             cca::node<"c", source<angles>>,
                             cca::node<"l", cca::limiter<angles>>,
                             cca::node<"r", robot<>>,
                             cca::node<"s", sink<angles>>,
                             cca::wire<"c.y", "s.x">,
                             cca::wire<"a.y", "l.command">,
                             cca::wire<"l.safe", "r.command", cca::merged<2>>,
                             cca::wire<Second, "r.command", cca::merged<2>, cca::delayed<1>>> {};
static_assert(cca::diagnosis<merged_commands<"c.y">>.rule == std::string_view("robot.unlimited_command"));
static_assert(cca::diagnosis<merged_commands<"c.y">>.where == std::string_view("c.y -> r.command"));
static_assert(cca::well_formed<merged_commands<"l.safe">>);

}  // namespace
