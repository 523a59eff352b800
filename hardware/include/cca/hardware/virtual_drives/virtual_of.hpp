// The virtual drive of each family with its default settings: `virtual_of<Drive>`, for virtual_robot.
#pragma once

#include <cca/hardware/virtual_drives/virtual_cia402.hpp>
#include <cca/hardware/virtual_drives/virtual_mit.hpp>
#include <cca/hardware/virtual_drives/virtual_moteus.hpp>
#include <cca/hardware/virtual_drives/virtual_odrive.hpp>
#include <cca/hardware/virtual_drives/virtual_robstride.hpp>

namespace cca::hardware {

template <class Drive>
struct virtual_of;

template <class Ranges, std::uint32_t Number, std::uint32_t Master, mit_firmware Firmware>
struct virtual_of<mit_drive<Ranges, Number, Master, Firmware>>
    : virtual_mit<mit_drive<Ranges, Number, Master, Firmware>> {};
template <std::uint32_t Node,
          odrive_mode Mode,
          odrive_firmware Firmware,
          std::int64_t Estimates,
          std::int64_t Torques>
struct virtual_of<odrive<Node, Mode, Firmware, Estimates, Torques>>
    : virtual_odrive<odrive<Node, Mode, Firmware, Estimates, Torques>> {};
template <class Motor, std::uint8_t Servo, std::uint8_t Source, std::uint16_t Prefix>
struct virtual_of<moteus<Motor, Servo, Source, Prefix>>
    : virtual_moteus<moteus<Motor, Servo, Source, Prefix>> {};
template <class Ranges, std::uint8_t Number, std::uint8_t Host>
struct virtual_of<robstride<Ranges, Number, Host>> : virtual_robstride<robstride<Ranges, Number, Host>> {};
template <class Motor, std::uint8_t Node, cia402_mode Mode>
struct virtual_of<cia402<Motor, Node, Mode>> : virtual_cia402<cia402<Motor, Node, Mode>> {};

}  // namespace cca::hardware
