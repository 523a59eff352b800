// The frames of the MIT mini-cheetah protocol: five numbers to a drive, three back, each in steps of a range.
//
// The ranges are a type: each firmware has its own, and no frame names them. Wrong ranges scale motion and
// torque.
//   command   position 16 bits, velocity, stiffness, damping, torque 12 bits, in this order, big-endian: 8
//             bytes
//   reply     id, position 16, velocity 12, torque 12 bits: 6 bytes; AK firmware adds temperature and error:
//             8 bytes
// A special frame is seven bytes FF and one of FB to FE. A command with all numbers at their upper ends would
// look like one, so its torque is lowered to the step FFA: at most 5 steps (0.02 N m of 18).
// Source: bgkatz/motorcontrol, Core/Src/can.c; CubeMars AK series driver manual 1.0.8, 5.3.
#pragma once

#include <cstdint>
#include <span>

#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/wire_number.hpp>
#include <cca/space/quantity.hpp>

namespace cca::hardware {

// A type with the ranges of a firmware: `limits` of angle, velocity, torque, stiffness and damping.
template <class Type> concept MitRanges = requires {
  Type::limits.template of<angle>();
  Type::limits.template of<velocity>();
  Type::limits.template of<torque>();
  Type::limits.template of<stiffness>();
  Type::limits.template of<damping>();
};

enum class mit_special : std::uint8_t { clear_fault = 0xFB, enter = 0xFC, leave = 0xFD, set_zero = 0xFE };

constexpr can_frame mit_special_frame(can_id id, mit_special what) {
  can_frame f{.id = id, .length = 8};
  for (std::size_t i = 0; i < 7; ++i) f.data[i] = 0xFF;
  f.data[7] = static_cast<std::uint8_t>(what);
  return f;
}

template <MitRanges Ranges>
struct mit_wire {
  template <class Quantity>
  static constexpr detail::steps range(int bits) {
    return {Ranges::limits.template of<Quantity>().lower, Ranges::limits.template of<Quantity>().upper, bits};
  }
  static constexpr auto position = range<angle>(16);
  static constexpr auto velocity = range<cca::velocity>(12);
  static constexpr auto torque = range<cca::torque>(12);
  static constexpr auto stiffness = range<cca::stiffness>(12);
  static constexpr auto damping = range<cca::damping>(12);

  // The numbers of a command, as they are on the wire.
  struct command {
    std::uint32_t position = 0, velocity = 0, stiffness = 0, damping = 0, torque = 0;
    friend constexpr bool operator==(const command&, const command&) = default;
  };

  // For finite numbers only. `cut`: the quantities that were beyond their range.
  static constexpr command to_wire(const drive_command& c, std::uint8_t& cut) {
    const auto step = [&cut](const detail::steps& r, double number, drive_quantity of) {
      bool beyond = false;
      const std::uint32_t s = r.to_step(number, beyond);
      if (beyond) cut = static_cast<std::uint8_t>(cut | of);
      return s;
    };
    command w{step(position, c.position, of_position), step(velocity, c.velocity, of_velocity),
              step(stiffness, c.stiffness, of_stiffness), step(damping, c.damping, of_damping),
              step(torque, c.torque, of_torque)};
    if (w.position == 0xFFFF && w.velocity == 0xFFF && w.stiffness == 0xFFF && w.damping == 0xFFF &&
        w.torque >= 0xFFB && w.torque <= 0xFFE)
      w.torque = 0xFFA;
    return w;
  }

  static constexpr can_frame frame(can_id id, const command& w) {
    const auto byte = [](std::uint32_t n) { return static_cast<std::uint8_t>(n); };
    return {.id = id,
            .length = 8,
            .data = {byte(w.position >> 8), byte(w.position), byte(w.velocity >> 4),
                     byte((w.velocity & 0xF) << 4 | w.stiffness >> 8), byte(w.stiffness),
                     byte(w.damping >> 4), byte((w.damping & 0xF) << 4 | w.torque >> 8), byte(w.torque)}};
  }

  // The drive's side. Check first whether the 8 bytes are a special frame.
  static constexpr command read(std::span<const std::uint8_t, 8> d) {
    return {.position = std::uint32_t{d[0]} << 8 | d[1],
            .velocity = std::uint32_t{d[2]} << 4 | d[3] >> 4,
            .stiffness = (d[3] & 0xFu) << 8 | d[4],
            .damping = std::uint32_t{d[5]} << 4 | d[6] >> 4,
            .torque = (d[6] & 0xFu) << 8 | d[7]};
  }
  static constexpr drive_command from_wire(const command& w) {
    return {.position = position.from_step(w.position),
            .velocity = velocity.from_step(w.velocity),
            .torque = torque.from_step(w.torque),
            .stiffness = stiffness.from_step(w.stiffness),
            .damping = damping.from_step(w.damping)};
  }
};

}  // namespace cca::hardware
