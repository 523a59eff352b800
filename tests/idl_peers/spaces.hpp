// Spaces of each kind, to exchange with a program that is made of their IDL.
#pragma once

#include <cca/space/array.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/record.hpp>

namespace talk {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::torque{-5, 5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 0}, cca::torque{-5, 5}};
};
using leg = cca::axes<hip, knee>;
struct leg_angles : cca::space<cca::joint_angles, leg, cca::rate<1000>> {};
struct leg_torques : cca::space<cca::joint_torques, leg, cca::rate<1000>> {};

// Words of IDL, and a name that no language takes.
struct in : cca::dimension<"in"> {};
struct octet : cca::dimension<"octet"> {};
struct third : cca::dimension<"3rd"> {};
struct any : cca::space<cca::number, cca::axes<in, octet, third>> {};

// Two names that differ only in case.
struct small : cca::dimension<"pad"> {};
struct big : cca::dimension<"PAD"> {};
struct pads : cca::space<cca::amplitude, cca::axes<small, big>> {};

using world = cca::frame<"world">;
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct trunk_pose : cca::space<cca::pose<world>, xyz> {};
struct paws : cca::array_of<trunk_pose, 2> {};
struct mood : cca::space<cca::status, cca::axes<hip>> {};

// More than 64 KiB.
struct gray : cca::record<9216> {};
struct lens : cca::dimension<"lens"> {};
struct picture : cca::space<gray, cca::axes<lens>> {};

}  // namespace talk
