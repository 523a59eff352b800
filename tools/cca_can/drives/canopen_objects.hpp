// Objects of a CANopen drive, read one at a time, one frame each (CiA 301, expedited upload). Reading changes
// nothing. jog and enable read with it what they must know about the drive's mode before they enable the
// drive.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <cca/hardware/drive.hpp>
#include <cca/hardware/drives/wire_number.hpp>

namespace cca_can {

namespace hw = cca::hardware;

enum class canopen_object : std::uint16_t {
  device_type = 0x1000,
  mode_of_operation = 0x6061,
  most_torque = 0x6072
};

constexpr hw::can_frame ask_for(std::uint32_t node, canopen_object what) {
  hw::can_frame f{.id = hw::standard(0x600 + node), .length = 8, .data = {0x40}};
  hw::detail::put(f.data, 1, static_cast<std::uint16_t>(what));
  return f;
}
// `bytes`: 1, 2 or 4.
constexpr hw::can_frame tell(std::uint32_t node, canopen_object what, std::uint32_t value, unsigned bytes) {
  hw::can_frame f = ask_for(node, what);
  f.id = hw::standard(0x580 + node);
  f.data[0] = static_cast<std::uint8_t>(0x43 | (4 - bytes) << 2);
  hw::detail::put(f.data, 4, value);
  return f;
}

// The object's value in this frame; none: another frame, another object, or the drive lacks the object.
constexpr std::optional<std::uint32_t> told_of(const hw::can_frame& f,
                                               std::uint32_t node,
                                               canopen_object what) {
  const unsigned unused = f.data[0] >> 2 & 3u;
  if (f.id != hw::standard(0x580 + node) || f.length != 8 || f.fd || f.remote || (f.data[0] & 0xF3) != 0x43)
    return {};
  if (hw::detail::got<std::uint16_t>(f.payload(), 1) != static_cast<std::uint16_t>(what) || f.data[3] != 0)
    return {};
  const auto value = hw::detail::got<std::uint32_t>(f.payload(), 4);
  return unused == 0 ? value : value & ((1u << 8 * (4 - unused)) - 1);
}

}  // namespace cca_can
