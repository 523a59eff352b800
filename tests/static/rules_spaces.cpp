// Rules about the spaces at the ends of a wire: the message of each mistake, and that the mended graph is
// sound.
#include "rules_parts.hpp"

namespace {

using namespace parts;

struct hip_twice : cca::space<cca::joint_angles, cca::axes<hip, knee, hip>> {};

struct axis_twice : khz<cca::node<"a", source<hip_twice>>> {};
struct axis_twice_mended : khz<cca::node<"a", source<angles>>> {};
static_assert(tells<axis_twice, axis_twice_mended>(
    {"space.duplicate_axis", "a.y",
     "the space hip_twice of `a.y` has the axis `hip` twice, so reading along it has two meanings: name each "
     "axis once in cca::axes<...>"}));

struct axis_twice_read : khz<cca::node<"a", listener<hip_twice>>> {};
struct axis_twice_read_mended : khz<cca::node<"a", source<angles>>> {};
static_assert(tells<axis_twice_read, axis_twice_read_mended>(
    {"space.duplicate_axis", "a.x",
     "the space hip_twice of `a.x` has the axis `hip` twice, so reading along it has two meanings: name each "
     "axis once in cca::axes<...>"}));

struct showing : cca::graph<cca::node<"in", sink<>>,
                            cca::node<"out", source<>>,
                            cca::node<"hidden", source<>>,
                            cca::expose<"in.x", "x">,
                            cca::expose<"out.y", "y">> {};

struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};

struct domain : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<torques>>, cca::wire<"a.y", "b.x">> {
};
struct domain_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<domain, domain_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects torques (joint_torques over "
     "hip, knee): the domain types differ; put a mapping between them, or wire another port"}));

struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>> {};

struct axes : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<hip_angle>>, cca::wire<"a.y", "b.x">> {
};
struct axes_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<axes, axes_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects hip_angle (joint_angles over "
     "hip): the axes differ; use a splitter or a collector, or give both ends one space"}));

struct other_order : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};

struct order
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<other_order>>, cca::wire<"a.y", "b.x">> {};
struct order_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<order, order_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects other_order (joint_angles over "
     "knee, hip): the axes are in another order; give both ends one space"}));

struct hip_frame {};
struct world_frame {};
struct foot_in_hip : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};
struct foot_in_world : cca::space<cca::cartesian_position<world_frame>, cca::axes<cca::x, cca::z>> {};
struct same_foot : cca::space<cca::cartesian_position<hip_frame>, cca::axes<cca::x, cca::z>> {};

struct frame
    : khz<cca::node<"a", source<foot_in_hip>>, cca::node<"b", sink<foot_in_world>>, cca::wire<"a.y", "b.x">> {
};
struct frame_mended
    : khz<cca::node<"a", source<foot_in_hip>>, cca::node<"b", sink<same_foot>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<frame, frame_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes foot_in_hip (cartesian_position<hip_frame> over x, z) but `b.x` expects foot_in_world "
     "(cartesian_position<world_frame> over x, z): the frames differ; put a transformation between them"}));

struct fast : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};
struct slow : cca::space<cca::number, cca::axes<cca::x>, cca::rate<62.5>> {};

struct rate : khz<cca::node<"a", source<fast>>, cca::node<"b", sink<slow>>, cca::wire<"a.y", "b.x">> {};
struct rate_mended : khz<cca::node<"a", source<fast>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<rate, rate_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes fast (number over x at 1000 Hz) but `b.x` expects slow (number over x at 62.5 Hz): the "
     "rates differ; give both spaces one rate, or let one of them state none"}));

namespace elsewhere {
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
}  // namespace elsewhere

struct same_names
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<elsewhere::angles>>, cca::wire<"a.y", "b.x">> {
};
struct same_names_mended
    : khz<cca::node<"a", source<angles>>, cca::node<"b", sink<angles>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<same_names, same_names_mended>(
    {"space.mismatch", "a.y -> b.x",
     "`a.y` publishes angles (joint_angles over hip, knee) but `b.x` expects angles (joint_angles over hip, "
     "knee): their domain types, axes or frames have the same names but are different types; use those of "
     "one namespace"}));

struct inner_space : khz<cca::node<"g", showing>,
                         cca::node<"b", sink<angles>>,
                         cca::node<"a", source<>>,
                         cca::wire<"a.y", "g.x">,
                         cca::wire<"g.y", "b.x">> {};
struct inner_space_mended : khz<cca::node<"g", showing>,
                                cca::node<"b", sink<>>,
                                cca::node<"a", source<>>,
                                cca::wire<"a.y", "g.x">,
                                cca::wire<"g.y", "b.x">> {};
static_assert(tells<inner_space, inner_space_mended>(
    {"space.mismatch", "g.y -> b.x",
     "`g.out.y` (exposed as `g.y`) publishes signal (number over x) but `b.x` expects angles (joint_angles "
     "over hip, knee): the domain types differ; put a mapping between them, or wire another port"}));

}  // namespace
