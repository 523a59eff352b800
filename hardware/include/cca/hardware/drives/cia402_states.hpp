// The state machine of CiA 402, network management, and the classes of emergencies: what all CANopen drives
// share.
//
// Source: see cia402.hpp.
#pragma once

#include <cstdint>

#include <cca/hardware/bus/can_frame.hpp>
#include <cca/hardware/drives/drive.hpp>

namespace cca::hardware {

enum class cia402_mode : std::uint8_t { position = 8, torque = 10 };
enum class cia402_state : std::uint8_t {
  not_ready,
  switch_on_disabled,
  ready,
  switched_on,
  enabled,
  quick_stop,
  fault_reaction,
  fault,
  unknown
};

constexpr cia402_state cia402_state_of(std::uint16_t status) {
  switch (status & 0x4F) {
    case 0x00:
      return cia402_state::not_ready;
    case 0x40:
      return cia402_state::switch_on_disabled;
    case 0x08:
      return cia402_state::fault;
    case 0x0F:
      return cia402_state::fault_reaction;
    default:
      break;
  }
  switch (status & 0x6F) {
    case 0x21:
      return cia402_state::ready;
    case 0x23:
      return cia402_state::switched_on;
    case 0x27:
      return cia402_state::enabled;
    case 0x07:
      return cia402_state::quick_stop;
    default:
      return cia402_state::unknown;
  }
}

// The control word for the next step towards `enabled`. A fault is reset by the rising edge of bit 7, so the
// bit is set every other time (`edge`).
constexpr std::uint16_t cia402_towards_enabled(cia402_state s, bool edge) {
  switch (s) {
    case cia402_state::fault:
      return edge ? 0x0080 : 0x0000;
    case cia402_state::ready:
      return 0x0007;
    case cia402_state::switched_on:
    case cia402_state::enabled:
      return 0x000F;
    case cia402_state::quick_stop:
      return 0x0000;
    default:
      return 0x0006;
  }
}

constexpr can_frame canopen_sync() { return {.id = standard(0x080)}; }
// Node 0: all nodes.
constexpr can_frame canopen_start(std::uint8_t node) {
  return {.id = standard(0), .length = 2, .data = {1, node}};
}
constexpr can_frame canopen_stop(std::uint8_t node) {
  return {.id = standard(0), .length = 2, .data = {2, node}};
}

namespace detail {

// The fault that an emergency reports, by the classes of CiA 301 and 402.
constexpr drive_fault cia402_fault_of(std::uint32_t code) {
  if ((code & 0xFF00) == 0) return drive_fault::none;  // the fault is reset, or there is none
  if (code == 0x8611) return drive_fault::limit;       // following error
  if (code == 0x8250) return drive_fault::watchdog;    // no process data in time
  switch (code & 0xFF00) {
    case 0x7300:
      return drive_fault::position_sensor;
    case 0x8400:
    case 0x8500:
    case 0x8600:
    case 0x8A00:
      return drive_fault::limit;
    default:
      break;
  }
  switch (code & 0xF000) {
    case 0x2000:
      return drive_fault::over_current;
    case 0x3000:
      return (code & 0xF0) == 0x20 ? drive_fault::under_voltage : drive_fault::over_voltage;
    case 0x4000:
      return drive_fault::over_temperature;
    case 0x5000:
      return drive_fault::power_stage;
    case 0x6000:
      return drive_fault::configuration;
    case 0x8000:
      return drive_fault::communication;
    default:
      return drive_fault::other;
  }
}

}  // namespace detail
}  // namespace cca::hardware
