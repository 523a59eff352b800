// The units in which a file may give a quantity: `"30 deg"` is 0.5236 rad.
//
// `units_of<angle>` lists them: first the SI unit, as in `angle::unit`, then the others with their size in
// it; an empty unit ends the list. A quantity of your own has only its own unit, unless you specialise
// `units_of` for it. Units are factors only: degrees Celsius, with a zero of its own, can't be listed.
#pragma once

#include <numbers>
#include <string_view>

#include <cca/space/quantity.hpp>
#include <cca/space/methods/scalar.hpp>

namespace cca {

struct unit {
  std::string_view text;
  double factor = 1;  // how many SI units one of these is
};

namespace detail {

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double turns_per_minute = std::numbers::pi / 30;

}  // namespace detail

template <class Quantity>
inline constexpr unit units_of[] = {{Quantity::unit}, {}};

template <>
inline constexpr unit units_of<angle>[] = {
    {"rad"}, {"mrad", 1e-3}, {"deg", detail::degree}, {"turn", 360 * detail::degree}, {}};
template <>
inline constexpr unit units_of<velocity>[] = {
    {"rad/s"}, {"deg/s", detail::degree}, {"rpm", detail::turns_per_minute}, {}};
template <>
inline constexpr unit units_of<acceleration>[] = {{"rad/s^2"}, {"deg/s^2", detail::degree}, {}};
template <>
inline constexpr unit units_of<jerk>[] = {{"rad/s^3"}, {"deg/s^3", detail::degree}, {}};
template <>
inline constexpr unit units_of<torque>[] = {{"N m"}, {"Nm"}, {"mN m", 1e-3}, {"mNm", 1e-3}, {}};
template <>
inline constexpr unit units_of<torque_rate>[] = {{"N m/s"}, {"Nm/s"}, {}};
template <>
inline constexpr unit units_of<stiffness>[] = {
    {"N m/rad"}, {"Nm/rad"}, {"N m/deg", 1 / detail::degree}, {"Nm/deg", 1 / detail::degree}, {}};
template <>
inline constexpr unit units_of<damping>[] = {{"N m s/rad"}, {"Nms/rad"}, {}};
template <>
inline constexpr unit units_of<length>[] = {{"m"}, {"cm", 1e-2}, {"mm", 1e-3}, {}};
template <>
inline constexpr unit units_of<speed>[] = {{"m/s"}, {"cm/s", 1e-2}, {"mm/s", 1e-3}, {"km/h", 1 / 3.6}, {}};
template <>
inline constexpr unit units_of<force>[] = {{"N"}, {"mN", 1e-3}, {"kN", 1e3}, {}};
template <>
inline constexpr unit units_of<linear_stiffness>[] = {{"N/m"}, {"N/mm", 1e3}, {"kN/m", 1e3}, {}};
template <>
inline constexpr unit units_of<linear_damping>[] = {{"N s/m"}, {"Ns/m"}, {}};
template <>
inline constexpr unit units_of<mass>[] = {{"kg"}, {"g", 1e-3}, {}};
template <>
inline constexpr unit units_of<duration>[] = {{"s"}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {}};
template <>
inline constexpr unit units_of<frequency>[] = {{"Hz"}, {"mHz", 1e-3}, {"kHz", 1e3}, {}};
template <>
inline constexpr unit units_of<power>[] = {{"W"}, {"mW", 1e-3}, {}};
template <>
inline constexpr unit units_of<voltage>[] = {{"V"}, {"mV", 1e-3}, {}};
template <>
inline constexpr unit units_of<current>[] = {{"A"}, {"mA", 1e-3}, {}};
template <>
inline constexpr unit units_of<value>[] = {{""}, {"%", 1e-2}, {}};

}  // namespace cca
