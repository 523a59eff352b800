// What a drive or a sensor board says about its frames on a bus, with defaults for what it does not say.
//
// bus_load.hpp adds these up. All members of a drive: drives/drive.hpp.
#pragma once

#include <array>
#include <cstdint>

#include <cca/hardware/bus/can_filter.hpp>
#include <cca/hardware/bus/frame_bits.hpp>

namespace cca::hardware {

// Frames on the bus: `a_cycle` in each cycle, or with a `period` one in each period.
struct frame_traffic {
  frame_shape shape{};
  int a_cycle = 1;
  std::int64_t period = 0;  // ns; 0: by cycle
};

// The bits of a reply's first byte that identify its sender: those of `mask` have the `value`. Without a mask
// they say nothing.
struct drive_mark {
  std::uint8_t value = 0, mask = 0;
  // Whether no byte is taken for both.
  friend constexpr bool apart(drive_mark a, drive_mark b) {
    return ((a.value ^ b.value) & a.mask & b.mask) != 0;
  }
};

// The defaults.
template <class D>
inline constexpr std::array<can_filter, 0> broadcasts_of{};
template <class D>
  requires requires { D::broadcasts; }
inline constexpr auto broadcasts_of<D> = D::broadcasts;
template <class D>
inline constexpr std::array<can_filter, 0> occupied_by{};
template <class D>
  requires requires { D::occupies; }
inline constexpr auto occupied_by<D> = D::occupies;
template <class D>
inline constexpr drive_mark reply_mark_of{};
template <class D>
  requires requires { D::reply_mark; }
inline constexpr drive_mark reply_mark_of<D> = D::reply_mark;
template <class D>
inline constexpr std::array<can_frame, 0> cycle_frames_of{};
template <class D>
  requires requires { D::cycle_frames; }
inline constexpr auto cycle_frames_of<D> = D::cycle_frames;
template <class D>
inline constexpr std::int64_t report_period_of = 0;
template <class D>
  requires requires { D::report_period; }
inline constexpr std::int64_t report_period_of<D> = D::report_period;
template <class D>
inline constexpr std::int64_t torque_period_of = report_period_of<D>;
template <class D>
  requires requires { D::torque_period; }
inline constexpr std::int64_t torque_period_of<D> = D::torque_period;

}  // namespace cca::hardware
