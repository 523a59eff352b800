// Frames in Linux's format, both ways. Needs Linux's headers, but no CAN in the kernel.
//
// The number of bytes read says what they are: 16 a classic frame, 72 an FD frame; no other size is a frame.
// Call is_error first: an error frame is neither. Source: Linux, Documentation/networking/can.rst;
// include/uapi/linux/can.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <linux/can.h>
#include <linux/can/error.h>

#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/bus/can_filter.hpp>

namespace cca::hardware::detail {

// Not CAN_MTU: that macro says `struct can_frame`, which in this namespace is ours.
inline constexpr std::size_t classic_size = sizeof(::can_frame), fd_size = sizeof(::canfd_frame);

// Copies the largest payload of this kind of frame, whatever its length: a fixed size compiles to one or four
// moves instead of a call.
constexpr void copy_payload(const std::uint8_t* from, std::uint8_t* to, bool fd) {
  if (fd) std::copy_n(from, longest_payload, to);
  else std::copy_n(from, std::size_t{8}, to);
}

// For valid frames only. Both directions leave the bytes after the payload as they were.
constexpr void to_kernel(const can_frame& f, canfd_frame& k) {
  k.can_id = f.id.number | (f.id.extended ? CAN_EFF_FLAG : 0u) | (f.remote ? CAN_RTR_FLAG : 0u);
  k.len = f.length;
  k.flags = f.fast ? CANFD_BRS : 0;
  k.__res0 = k.__res1 = 0;
  copy_payload(f.data.data(), k.data, f.fd);
}
constexpr std::size_t kernel_size(const can_frame& f) { return f.fd ? fd_size : classic_size; }

constexpr bool is_error(const canfd_frame& k) { return (k.can_id & CAN_ERR_FLAG) != 0; }

constexpr void from_kernel(const canfd_frame& k, std::size_t size, can_frame& f) {
  f.id.extended = (k.can_id & CAN_EFF_FLAG) != 0;
  f.id.number = k.can_id & (f.id.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  f.fd = size == fd_size;
  f.fast = f.fd && (k.flags & CANFD_BRS) != 0;
  f.remote = !f.fd && (k.can_id & CAN_RTR_FLAG) != 0;
  f.length = std::min<std::uint8_t>(k.len, f.fd ? 64 : 8);
  copy_payload(k.data, f.data.data(), f.fd);
}

// Also exact in the kind of the id, and without remote frames: a mask of the id alone would let 29-bit ids
// with the same last bits through.
constexpr ::can_filter to_kernel(const can_filter& f) {
  const std::uint32_t bits = f.id.extended ? CAN_EFF_MASK : CAN_SFF_MASK;
  return {.can_id = (f.id.number & bits) | (f.id.extended ? CAN_EFF_FLAG : 0u),
          .can_mask = (f.mask & bits) | CAN_EFF_FLAG | CAN_RTR_FLAG};
}

// Reads an error frame into state and counters. Only those of 8 bytes say anything.
constexpr bus_state after_error(bus_state s, const canfd_frame& k, bus_counters& c) {
  ++c.errors;
  if (k.len != CAN_ERR_DLC) return s;
  const auto told = [&k](std::uint32_t what) { return (k.can_id & what) != 0; };
  c.arbitration_lost += told(CAN_ERR_LOSTARB);
  c.protocol_errors += told(CAN_ERR_PROT);
  c.not_acknowledged += told(CAN_ERR_ACK);
  c.timeouts += told(CAN_ERR_TX_TIMEOUT);
  if (told(CAN_ERR_CNT)) c.transmit_errors = k.data[6], c.receive_errors = k.data[7];
  if (told(CAN_ERR_CRTL)) {
    const unsigned controller = k.data[1];
    c.overflows += (controller & (CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW)) != 0;
    if (s != bus_state::bus_off) {
      if (controller & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) s = bus_state::passive;
      else if (controller & (CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING)) s = bus_state::warning;
      else if (controller & CAN_ERR_CRTL_ACTIVE) s = bus_state::active;
    }
  }
  if (told(CAN_ERR_BUSOFF) && s != bus_state::bus_off) {
    ++c.bus_offs;
    s = bus_state::bus_off;
  }
  if (told(CAN_ERR_RESTARTED) && s == bus_state::bus_off) {
    ++c.restarts;
    s = bus_state::active;
  }
  return s;
}

}  // namespace cca::hardware::detail
