// The axes of an Oncilla: its joints, with the limits of body.hpp (chosen, not published), and its feet.
//
// Lists of eight axes have the hips first, then the knees, each left front, right front, left hind, right
// hind. Hip: 0 is straight down, positive forward. Knee: flexion. Abduction: positive outward.
#pragma once

#include <cca/robots/oncilla/body.hpp>
#include <cca/space/dimension.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/space.hpp>

namespace cca::robots::oncilla {

inline constexpr cca::limits hip_limits{
    cca::angle{body.hip_range.low, body.hip_range.high},
    cca::velocity{-body.hip_motor.no_load_speed, body.hip_motor.no_load_speed},
    cca::torque{-body.hip_motor.torque, body.hip_motor.torque}, cca::stiffness{0.0, body.stiffest_hip}};

// Torques are positive: the cable can only flex the knee.
inline constexpr cca::limits knee_limits{
    cca::angle{body.knee_range.low, body.knee_range.high},
    cca::velocity{-body.knee_motor.no_load_speed, body.knee_motor.no_load_speed},
    cca::torque{0.0, body.knee_motor.torque}};

inline constexpr cca::limits abduction_limits{
    cca::angle{body.abduction_range.low, body.abduction_range.high},
    cca::velocity{-body.abduction_motor.no_load_speed, body.abduction_motor.no_load_speed},
    cca::torque{-body.abduction_motor.torque, body.abduction_motor.torque}};

template <fixed_string Name>
struct hip : cca::dimension<Name> {
  static constexpr auto limits = hip_limits;
};
template <fixed_string Name>
struct knee : cca::dimension<Name> {
  static constexpr auto limits = knee_limits;
};
template <fixed_string Name>
struct abduction : cca::dimension<Name> {
  static constexpr auto limits = abduction_limits;
};

struct left_front_hip : hip<"left_front_hip"> {};
struct right_front_hip : hip<"right_front_hip"> {};
struct left_hind_hip : hip<"left_hind_hip"> {};
struct right_hind_hip : hip<"right_hind_hip"> {};

struct left_front_knee : knee<"left_front_knee"> {};
struct right_front_knee : knee<"right_front_knee"> {};
struct left_hind_knee : knee<"left_hind_knee"> {};
struct right_hind_knee : knee<"right_hind_knee"> {};

struct left_front_abduction : abduction<"left_front_abduction"> {};
struct right_front_abduction : abduction<"right_front_abduction"> {};
struct left_hind_abduction : abduction<"left_hind_abduction"> {};
struct right_hind_abduction : abduction<"right_hind_abduction"> {};

struct left_front_foot : cca::dimension<"left_front_foot"> {};
struct right_front_foot : cca::dimension<"right_front_foot"> {};
struct left_hind_foot : cca::dimension<"left_hind_foot"> {};
struct right_hind_foot : cca::dimension<"right_hind_foot"> {};

using hip_axes = cca::axes<left_front_hip, right_front_hip, left_hind_hip, right_hind_hip>;
using leg_axes = cca::axes<left_front_hip,
                           right_front_hip,
                           left_hind_hip,
                           right_hind_hip,  //
                           left_front_knee,
                           right_front_knee,
                           left_hind_knee,
                           right_hind_knee>;
using abduction_axes =
    cca::axes<left_front_abduction, right_front_abduction, left_hind_abduction, right_hind_abduction>;
using foot_axes = cca::axes<left_front_foot, right_front_foot, left_hind_foot, right_hind_foot>;

// The places of a leg's joints in leg_axes.
constexpr std::size_t hip_of(std::size_t leg) { return leg; }
constexpr std::size_t knee_of(std::size_t leg) { return leg_count + leg; }

}  // namespace cca::robots::oncilla
