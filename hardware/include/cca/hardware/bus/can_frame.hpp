// A frame of a CAN bus, classic or FD: what a program says about it. The controllers add the rest.
//
// A frame may hold any values; `valid()` says whether it can be on a bus. It can if its id has 11 or 29 bits,
// and its length is one that the length code can say: 0 to 8 bytes, in an FD frame also 12, 16, 20, 24, 32,
// 48 or 64. A remote frame asks for a frame: it has no payload, and its length is the length that it asks
// for. FD has no remote frames.
//
// Cost: 76 bytes. Source: ISO 11898-1:2015. Example: tests/runtime/hardware/memory_bus.cpp; docs/can_bus.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cca::hardware {

struct can_id {
  std::uint32_t number = 0;
  bool extended = false;  // 29 bits instead of 11

  constexpr bool valid() const { return number <= (extended ? 0x1FFFFFFFu : 0x7FFu); }
  friend constexpr bool operator==(const can_id&, const can_id&) = default;

  // Arbitration: which of two frames wins the bus when both begin at once. The lower id wins, bit by bit as
  // sent; of an 11-bit id and a 29-bit one with the same first bits, the 11-bit id wins.
  friend constexpr bool goes_before(can_id a, can_id b) {
    const auto sent = [](can_id i) {
      return i.extended ? (std::uint64_t{i.number >> 18} << 20 | 1u << 19 | (i.number & 0x3FFFFu))
                        : std::uint64_t{i.number} << 20;
    };
    return sent(a) < sent(b);
  }
};
constexpr can_id standard(std::uint32_t number) { return {number, false}; }
constexpr can_id extended(std::uint32_t number) { return {number, true}; }

inline constexpr std::size_t longest_payload = 64;

// The shortest FD payload with room for this many bytes; 64 for everything longer.
constexpr std::uint8_t fd_length(std::size_t bytes) {
  if (bytes <= 8) return static_cast<std::uint8_t>(bytes);
  for (const unsigned length : {12u, 16u, 20u, 24u, 32u, 48u})
    if (bytes <= length) return static_cast<std::uint8_t>(length);
  return 64;
}

struct can_frame {
  can_id id{};
  std::uint8_t length = 0;  // bytes of payload
  bool fd = false;
  // FD: the payload goes at the data bit rate (BRS). Some drives ignore frames without it.
  bool fast = false;
  bool remote = false;  // classic: asks for a frame
  std::array<std::uint8_t, longest_payload> data{};

  constexpr bool valid() const {
    if (!id.valid()) return false;
    if (fd) return !remote && length <= longest_payload && fd_length(length) == length;
    return !fast && length <= 8;
  }
  constexpr std::span<const std::uint8_t> payload() const {
    return {data.data(), remote ? 0 : std::min<std::size_t>(length, longest_payload)};
  }

  // Equal on the wire: bytes after the payload don't count.
  friend constexpr bool operator==(const can_frame& a, const can_frame& b) {
    const auto p = a.payload(), q = b.payload();
    return a.id == b.id && a.length == b.length && a.fd == b.fd && a.fast == b.fast && a.remote == b.remote &&
           std::equal(p.begin(), p.end(), q.begin(), q.end());
  }
};

namespace detail {

constexpr can_frame filled(can_frame frame, std::span<const std::uint8_t> payload) {
  for (std::size_t i = 0; i < payload.size() && i < longest_payload; ++i) frame.data[i] = payload[i];
  return frame;
}

}  // namespace detail

// Not valid with more than 8 bytes.
constexpr can_frame classic(can_id id, std::span<const std::uint8_t> payload) {
  return detail::filled(
      {.id = id, .length = static_cast<std::uint8_t>(std::min<std::size_t>(payload.size(), 255))}, payload);
}

// Filled up with `pad` to the next length that FD has.
constexpr can_frame fd(can_id id,
                       std::span<const std::uint8_t> payload,
                       std::uint8_t pad = 0,
                       bool fast = true) {
  can_frame frame =
      detail::filled({.id = id, .length = fd_length(payload.size()), .fd = true, .fast = fast}, payload);
  for (std::size_t i = payload.size(); i < frame.length; ++i) frame.data[i] = pad;
  return frame;
}

constexpr can_frame remote(can_id id, std::uint8_t length = 0) {
  return {.id = id, .length = length, .remote = true};
}

}  // namespace cca::hardware
