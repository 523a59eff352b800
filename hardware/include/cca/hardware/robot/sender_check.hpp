// Finds out that a drive is not alone on its bus: that two drives answer under its id, or that another
// program commands it.
//
//   is_command<D>(frame)   the frame is one that only we may send to this drive. From another
//                          sender, it may have taken the torque away (`leave` of an MIT drive, whose answers
//                          do not say so), or may move it
//   answered(frame), begin_beat(), too_many()
//                          a drive that answers each frame gets one a beat. If in `window` beats half as many
//                          answers again come, two drives answer. An answer that repeats the last one does
//                          not count: a bus may deliver a frame twice
//
// Late answers do no harm: half a window is more than any bus delays. Used by
// joint_monitor.hpp. Cost: an addition a frame and a beat. Test: tests/runtime/hardware/joint_monitor.cpp;
// docs/hardware.md.
#pragma once

#include <cstdint>

#include <cca/hardware/drives/drive.hpp>

namespace cca::hardware {

// Frames under the id of its own replies can't be told apart.
template <Drive D>
constexpr bool is_command(const can_frame& f) {
  if (f.remote) return false;
  for (const can_filter& reply : D::replies)
    if (reply.matches(f.id)) return false;
  for (const can_filter& request : D::requests)
    if (request.matches(f.id)) return true;
  return false;
}

class sender_check {
public:
  static constexpr int window = 100;

  constexpr void answered(const can_frame& f) {
    std::uint64_t now = 0xCBF29CE484222325;  // FNV-1a
    for (const std::uint8_t byte : f.payload()) now = (now ^ byte) * 0x100000001B3;
    answers += now != before;
    before = now;
  }
  constexpr void commanded() { foreign = true; }
  constexpr void begin_beat() {
    if (++beats < window) return;
    doubled = answers > window + window / 2;
    beats = answers = 0;
  }
  constexpr bool too_many() const { return doubled; }
  constexpr bool has_stranger() const { return foreign; }

private:
  std::uint64_t before = 0;
  int beats = 0, answers = 0;
  bool doubled = false, foreign = false;
};

}  // namespace cca::hardware
