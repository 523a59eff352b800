// The registers of a moteus, as subframes in the payload of a frame: reading and writing them in order.
//
// A subframe is its kind, the number of registers, the first register, and the values: each of 1, 2 or 4
// bytes, or a float. Integers count steps; the size of a step depends on the register. The most negative
// integer, like NaN, means `none`, which is a value of this protocol.
// read_registers calls f(kind, register, value) for each register. It returns false where the bytes end too
// early or make no sense. It reads nothing past the payload, and at most 64 values. Subframes of the
// diagnostic stream are skipped.
// Source: mjbots/moteus, docs/protocol/can.md and registers.md.
#pragma once

#include <cstdint>
#include <span>

#include <cca/hardware/bus/can_frame.hpp>
#include <cca/hardware/drives/wire_number.hpp>

namespace cca::hardware {

enum class moteus_register : std::uint32_t {
  mode = 0x00,
  position = 0x01,
  velocity = 0x02,
  torque = 0x03,
  voltage = 0x0D,
  temperature = 0x0E,
  fault = 0x0F,
  command_position = 0x20,
  command_velocity = 0x21,
  command_torque = 0x22,
  stiffness_scale = 0x23,
  damping_scale = 0x24,
  most_torque = 0x25,
  stop_position = 0x26,
  command_timeout = 0x27,
};
enum class moteus_value : std::uint8_t { int8, int16, int32, float32 };
enum class moteus_kind : std::uint8_t { write = 0x00, read = 0x10, reply = 0x20 };

namespace detail {

// One step of an integer, in turns, turns/s, N m, degrees Celsius, V, s; 0: a register that is not known
// here.
constexpr double moteus_step(std::uint32_t which, moteus_value as) {
  const auto of = [as](double a, double b, double c) {
    return as == moteus_value::int8 ? a : as == moteus_value::int16 ? b : as == moteus_value::int32 ? c : 1.0;
  };
  switch (static_cast<moteus_register>(which)) {
    case moteus_register::mode:
    case moteus_register::fault:
      return 1;
    case moteus_register::position:
    case moteus_register::command_position:
    case moteus_register::stop_position:
      return of(0.01, 0.0001, 0.00001);
    case moteus_register::velocity:
    case moteus_register::command_velocity:
      return of(0.1, 0.00025, 0.00001);
    case moteus_register::torque:
    case moteus_register::command_torque:
    case moteus_register::most_torque:
      return of(0.5, 0.01, 0.001);
    case moteus_register::voltage:
      return of(0.5, 0.1, 0.001);
    case moteus_register::temperature:
      return of(1, 0.1, 0.001);
    case moteus_register::stiffness_scale:
    case moteus_register::damping_scale:
      return of(1.0 / 127, 1.0 / 32767, 1.0 / 2147483647);
    case moteus_register::command_timeout:
      return of(0.01, 0.001, 0.000001);
  }
  return 0;
}

constexpr std::size_t moteus_size(moteus_value v) {
  return v == moteus_value::int8 ? 1 : v == moteus_value::int16 ? 2 : 4;
}

constexpr double moteus_number(std::span<const std::uint8_t> bytes,
                               std::size_t at,
                               std::uint32_t which,
                               moteus_value as) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (as == moteus_value::float32) return number_or_nan(static_cast<double>(got_float(bytes, at)));
  std::int64_t n = 0;
  if (as == moteus_value::int8) n = static_cast<std::int8_t>(got<std::uint8_t>(bytes, at));
  if (as == moteus_value::int16) n = static_cast<std::int16_t>(got<std::uint16_t>(bytes, at));
  if (as == moteus_value::int32) n = static_cast<std::int32_t>(got<std::uint32_t>(bytes, at));
  const std::int64_t lowest = -(std::int64_t{1} << (8 * moteus_size(as) - 1));
  return n == lowest ? none : static_cast<double>(n) * moteus_step(which, as);
}

// Seven bits a byte, the low ones first. False: the bytes end too early, or the number has more than 32 bits.
constexpr bool got_varuint(std::span<const std::uint8_t> bytes, std::size_t& at, std::uint32_t& number) {
  std::uint64_t n = 0;
  for (int shift = 0; shift < 35; shift += 7) {
    if (at >= bytes.size()) return false;
    const std::uint8_t byte = bytes[at++];
    n |= std::uint64_t{byte & 0x7Fu} << shift;
    if ((byte & 0x80) == 0) return number = static_cast<std::uint32_t>(n), n <= 0xFFFFFFFF;
  }
  return false;
}

}  // namespace detail

template <class F>
constexpr bool read_registers(std::span<const std::uint8_t> bytes, F&& f) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::uint8_t head = bytes[at++];
    if (head == 0x50) continue;
    std::uint32_t count = 0, which = 0;
    if (head == 0x30 || head == 0x31) {  // write and read errors: register, error
      if (!detail::got_varuint(bytes, at, which) || !detail::got_varuint(bytes, at, count)) return false;
      continue;
    }
    if (head >= 0x40 && head <= 0x42) {  // the diagnostic stream: channel, length, bytes (of a poll: none)
      if (!detail::got_varuint(bytes, at, which) || !detail::got_varuint(bytes, at, count)) return false;
      if (head == 0x42) continue;
      if (count > bytes.size() - at) return false;
      at += count;
      continue;
    }
    if (head >= 0x30) return false;
    const auto kind = static_cast<moteus_kind>(head & 0xF0);
    const auto as = static_cast<moteus_value>(head >> 2 & 3);
    count = head & 3;
    if (count == 0 && !detail::got_varuint(bytes, at, count)) return false;
    if (!detail::got_varuint(bytes, at, which)) return false;
    if (kind == moteus_kind::read) continue;
    const std::size_t size = detail::moteus_size(as);
    if (count > (bytes.size() - at) / size) return false;
    for (; count > 0; --count, ++which, at += size)
      f(kind, which, detail::moteus_number(bytes, at, which, as));
  }
  return true;
}

// Puts subframes into a payload, as many as fit; the caller knows how many that are.
class register_writer {
public:
  constexpr explicit register_writer(std::span<std::uint8_t> into) : bytes(into) {}
  constexpr std::size_t size() const { return at; }

  // A count up to 3 is part of the head; a larger one has a byte of its own.
  constexpr void head(moteus_kind kind, moteus_value as, moteus_register first, std::uint8_t count) {
    byte(static_cast<std::uint8_t>(static_cast<unsigned>(kind) | static_cast<unsigned>(as) << 2 |
                                   (count <= 3 ? count : 0u)));
    if (count > 3) byte(count);
    byte(static_cast<std::uint8_t>(first));
  }
  constexpr void byte(std::uint8_t b) {
    if (at < bytes.size()) bytes[at++] = b;
  }
  constexpr void number(float f) {
    detail::put_float(bytes, at, f);
    at += 4;
  }
  constexpr void number(std::int32_t n) {
    detail::put(bytes, at, static_cast<std::uint32_t>(n));
    at += 4;
  }

private:
  std::span<std::uint8_t> bytes;
  std::size_t at = 0;
};

}  // namespace cca::hardware
