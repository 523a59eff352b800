// The longest time that a frame takes on the bus: with as many stuff bits as its contents can force.
//
//   worst_case(frame_shape{.length = 8}) is 135 bits: 24 of them are stuff bits, 3 the pause before the next
//   frame
//
// Classic: start bit, id, flags and checksum are 34 bits with an 11-bit id, 54 with a 29-bit one; then 8 bits
// a byte. After 5 equal bits comes a stuff bit, which can be the first of the next 5: so at most one in 4
// bits after the first. Then 10 bits of delimiters, acknowledgement and end of frame, and a pause of 3.
// FD: the bits up to BRS, and those from the delimiter of the checksum on, go at the nominal rate. The bits
// between go at the data rate: ESI, length code, payload, stuff count (4 bits), checksum (17 bits, from 20
// bytes on 21). A fixed stuff bit stands before the stuff count and after each 4 bits from there. Stuffing
// that depends on the contents ends with the payload; as much of it as possible is counted at the slower
// rate.
//
// Source: R. Davis et al., Controller Area Network schedulability analysis, Real-Time Systems 35 (2007), eq.
// 1; ISO 11898-1:2015, 10.4.2. tests/runtime/hardware/bus_load.cpp compares it with frames stuffed bit by
// bit.
#pragma once

#include <cstddef>
#include <cstdint>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca::hardware {

struct frame_shape {
  std::uint8_t length = 8;
  bool extended = false, fd = false, fast = false;
};
constexpr frame_shape shape_of(const can_frame& f) {
  return {
      .length = f.remote ? std::uint8_t{0} : f.length, .extended = f.id.extended, .fd = f.fd, .fast = f.fast};
}

struct frame_bits {
  std::int64_t nominal = 0, data = 0;  // bits at the nominal and at the data rate
};

struct bit_rates {
  std::int64_t nominal = 1'000'000, data = 5'000'000;  // bit/s; `data` for FD frames that are `fast`

  constexpr std::int64_t nanoseconds(frame_bits bits) const {
    return (bits.nominal * 1'000'000'000 + nominal - 1) / nominal +
           (bits.data * 1'000'000'000 + data - 1) / data;
  }
};

constexpr frame_bits worst_case(frame_shape s) {
  const std::int64_t payload = 8 * std::int64_t{s.length};
  if (!s.fd) {
    const std::int64_t stuffed = (s.extended ? 54 : 34) + payload;
    return {stuffed + (stuffed - 1) / 4 + 13, 0};
  }
  const std::int64_t head = s.extended ? 36 : 17, tail = 1 + 2 + 7 + 3;
  const std::int64_t stuffing = (head + 5 + payload - 1) / 4, slow_stuffing = (head - 1) / 4;
  const std::int64_t checksum = s.length <= 16 ? 4 + 17 + 6 : 4 + 21 + 7;
  const frame_bits bits{head + slow_stuffing + tail, 5 + payload + stuffing - slow_stuffing + checksum};
  return s.fast ? bits : frame_bits{bits.nominal + bits.data, 0};
}

}  // namespace cca::hardware
