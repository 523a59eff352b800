// Random bytes as a frame, and what must hold when a drive decodes it: a frame that it does not take changes
// nothing; a frame that it takes gives numbers or NaN; and a command made of these numbers is finite, or is
// refused.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <cca/hardware/drive.hpp>

#include "must.hpp"

namespace fuzz {

using namespace cca::hardware;

// The bytes: four of the id, one of the length, one of flags, then the payload. The payload lies in memory of
// exactly its size.
struct bytes_of_frame {
  const std::uint8_t* data;
  std::size_t size;
  can_frame frame(std::span<const can_filter> mine) const {
    const auto at = [this](std::size_t i) { return i < size ? data[i] : std::uint8_t{0}; };
    can_frame f;
    const std::uint32_t number = at(0) | at(1) << 8 | at(2) << 16 | static_cast<std::uint32_t>(at(3)) << 24;
    if (at(5) & 1) {  // an id of the drive's own; `number` also gives the bits that are free in it
      const can_filter& own = mine[number % mine.size()];
      f.id = {own.id.number | (number & ~own.mask & (own.id.extended ? 0x1FFFFFFFu : 0x7FFu)),
              own.id.extended};
    } else {
      f.id = {number, (at(5) & 2) != 0};
    }
    f.fd = (at(5) & 4) != 0;
    f.fast = (at(5) & 8) != 0;
    f.remote = (at(5) & 16) != 0;
    f.length = at(4);
    for (std::size_t i = 0; i < f.data.size(); ++i) f.data[i] = at(6 + i);
    return f;
  }
};

template <Drive D>
void hears(const std::uint8_t* data, std::size_t size) {
  drive_report r;
  typename D::enabling enabling;
  // Several frames: each one meets the state that the last one left.
  for (std::size_t first = 0; first == 0 || first + 14 <= size; first += 14) {
    const can_frame f = bytes_of_frame{data + first, size - first}.frame(D::replies);
    const drive_report before = r;
    if (!D::decode(f, r)) {
      must(std::memcmp(&before, &r, sizeof r) == 0);
    } else {
      must(r.frames == before.frames + 1 && r.told != 0);
    }
    for (const double number : {r.position, r.velocity, r.torque, r.temperature}) must(!std::isinf(number));
    must(name_of(r.fault).size() > 0);
    const auto s = D::set_point({.position = r.position, .velocity = r.velocity, .torque = r.torque});
    must(s.finite || s.frames.empty());
    for (const can_frame& out : s.frames) must(out.valid());
    for (const can_frame& out : enabling.next(r).frames) must(out.valid());
  }
}

}  // namespace fuzz
