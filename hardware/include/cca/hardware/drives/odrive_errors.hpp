// What the error bits of an ODrive mean, and which nodes it may have. Used by odrive.hpp, which names the
// sources.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include <cca/hardware/drives/drive.hpp>

namespace cca::hardware {

enum class odrive_firmware : std::uint8_t { v0_5, v0_6 };

namespace detail {

constexpr bool is_odrive_node(std::uint32_t node, odrive_firmware firmware) {
  return node <= 0xFFFFFF && !(firmware == odrive_firmware::v0_6 && node == 0x3F);
}

using fault_bit = std::pair<std::uint32_t, drive_fault>;

// The fault of the first bit in `known` that is set.
constexpr drive_fault fault_in(std::uint32_t bits, std::span<const fault_bit> known) {
  for (const auto& [bit, fault] : known)
    if (bits & bit) return fault;
  return bits == 0 ? drive_fault::none : drive_fault::other;
}
inline constexpr fault_bit odrive_0_6_faults[] = {
    {0x02000000, drive_fault::emergency_stop},  {0x01000000, drive_fault::watchdog},
    {0x00001400, drive_fault::over_current},    {0x00000900, drive_fault::over_voltage},
    {0x00000200, drive_fault::under_voltage},   {0x00006000, drive_fault::over_temperature},
    {0x04000008, drive_fault::position_sensor}, {0x00018000, drive_fault::limit},
    {0x40000010, drive_fault::configuration},   {0x08000020, drive_fault::power_stage}};
inline constexpr fault_bit odrive_0_5_faults[] = {
    {0x4000, drive_fault::emergency_stop}, {0x800, drive_fault::watchdog},
    {0x18000, drive_fault::over_current},  {0x4, drive_fault::over_voltage},
    {0x2, drive_fault::under_voltage},     {0x80180, drive_fault::position_sensor},
    {0x3000, drive_fault::limit},          {0x1, drive_fault::configuration},
    {0x70, drive_fault::power_stage},      {0x40000, drive_fault::over_temperature}};

// A drive that sends its torque by itself: `Period` in ns, 0: it does not.
template <std::int64_t Period>
struct odrive_torques {
  static constexpr std::int64_t torque_period = Period;
};
template <>
struct odrive_torques<0> {};

}  // namespace detail

}  // namespace cca::hardware
