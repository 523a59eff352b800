// EXPECT pose_over_two: space\.bad_axes: a space of pose<world> has 3 axes, as cca::axes<cca::x, cca::y, cca::z>, and this one has 2 \(x, y\): its numbers are those of a whole
// EXPECT attitude_over_joints: space\.bad_axes: a space of orientation<world> has 3 axes, as cca::axes<cca::x, cca::y, cca::z>, and this one has 2 \(hip, knee\)
// EXPECT twist_over_none: space\.bad_axes: a space of twist<world, world> has 3 axes, as cca::axes<cca::x, cca::y, cca::z>, and this one has 0: its numbers
// EXPECT no_axes: space\.bad_axes: the second argument of a space is the list of its axes, and that of a cca::space<pose<world>, \.\.\.> is `rate<1000>`
// EXPECT other_order: space\.bad_domain: the first argument of a space is a domain type, as cca::joint_angles, and `axes<hip, knee>` is none
// EXPECT no_rate: rate\.missing: the third argument of a space is its rate, as `cca::rate<1000>`, and `int` is none; where none is meant, leave it out
// EXPECT rate_below_zero: rate\.missing: `cca::rate<-5>` is no rate, which is a number of updates per second above 0, as `cca::rate<1000>`
// EXPECT no_space: component\.bad_parameter: a port is of a space, and `int` is none: make one of it
// LINES: 18
// What spaces say of the parts that they can't have. A graph uses the space, and has nothing to add: what
// stands in for it fits the other end of the wire. Up to three of the lines are of this file.
#include <cca/cca.hpp>

#include "../parts.hpp"
#include "late.hpp"

namespace broken {

template <class T>
struct pose_over_two : cca::space<cca::pose<late<world, T>>, cca::axes<cca::x, cca::y>> {};
template <class T>
struct attitude_over_joints : cca::space<cca::orientation<late<world, T>>, cca::axes<hip, knee>> {};
template <class T>
struct twist_over_none : cca::space<cca::twist<world, late<world, T>>, cca::axes<>> {};
template <class T>
struct no_axes : cca::space<cca::pose<late<world, T>>, cca::rate<1000>> {};
template <class T>
struct other_order : cca::space<late<cca::axes<hip, knee>, T>, cca::joint_angles> {};
template <class T>
struct no_rate : cca::space<cca::joint_angles, cca::axes<hip>, late<int, T>> {};
template <class T>
struct rate_below_zero : cca::space<cca::joint_angles, cca::axes<hip>, late<cca::rate<-5>, T>> {};
template <class T>
using no_space = late<int, T>;
template <class T>
using none = late<leg_angles, T>;

}  // namespace broken

#ifndef CCA_REJECT
using asked = broken::none<trunk>;
#else
using asked = broken::CCA_REJECT<trunk>;
#endif
constexpr auto size = sizeof(asked);

struct source {
  auto process(cca::beat) -> cca::out<"y", leg_angles> { return {}; }
};
struct sink {
  void process(cca::in<"x", asked>) {}
};
struct walking : cca::graph<cca::rate<1000>,
                            cca::node<"from", source>,
                            cca::node<"to", sink>,
                            cca::wire<"from.y", "to.x">> {};
cca::controller<walking> walk;
