// The boxes of a scene in a compiled world: their sizes, where they are, and how the program moves them.
//
// A box that is put elsewhere goes there in one beat, at constant speed, and rests from then on: what it
// touches feels that speed. Where a part of it would be faster than `fastest`, it is there at once instead,
// and nothing feels a speed. Numbers are plain: no scalar of the robot's motion is in them.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

struct boxes_around {
  static constexpr std::size_t most = 8;
  static constexpr double fastest = 10;  // m/s; CHOSEN

  std::size_t count = 0;
  std::array<std::array<double, 3>, most> half{};  // of its edges, m
};

// Where a box is when a beat begins, and how it moves in that beat: along the world's axes, of its centre.
struct box_motion {
  triple<double> at{};
  attitude_of_base<double> attitude{};
  triple<double> velocity{}, turning{};

  bool rests() const { return dot(velocity, velocity) + dot(turning, turning) == 0; }

  // So long after the beat's begin, s.
  placed_frame<double> frame(double after) const {
    if (rests()) return attitude.frame(at);
    attitude_of_base<double> turned = attitude;
    turned.turn(after * turning);
    return turned.frame(at + after * velocity);
  }
  triple<double> centre(double after) const { return at + after * velocity; }

  void put(const placement& where) {
    attitude = attitude_of_base<double>::of(where.rotation);
    for (std::size_t k = 0; k < 3; ++k) at[k] = where.translation[k];
    velocity = turning = {};
  }
  // It will be there at the end of the next beat.
  void move(const placement& where, const std::array<double, 3>& half, double beat) {
    box_motion there;
    there.put(where);
    const auto &p = there.attitude.q, &q = attitude.q;  // p times the inverse of q
    triple<double> turn{p[0] * q[3] - p[3] * q[0] - p[1] * q[2] + p[2] * q[1],
                        p[1] * q[3] - p[3] * q[1] - p[2] * q[0] + p[0] * q[2],
                        p[2] * q[3] - p[3] * q[2] - p[0] * q[1] + p[1] * q[0]};
    const double cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3],
                 sine = math::sqrt(dot(turn, turn)),
                 angle = 2 * math::atan2(sine, cosine < 0 ? -cosine : cosine);
    // Of a sine of 0 any axis would do.
    turn = (sine > 0 ? (cosine < 0 ? -angle : angle) / (sine * beat) : 0.0) * turn;
    const triple<double> way = (1 / beat) * (there.at - at);
    const double corner = math::sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    if (math::sqrt(dot(way, way)) + corner * math::sqrt(dot(turn, turn)) > boxes_around::fastest) {
      *this = there;
      return;
    }
    velocity = way, turning = turn;
  }
  void end_beat(double beat) {
    if (rests()) return;
    at = centre(beat);
    attitude.turn(beat * turning);
    velocity = turning = {};
  }
};

}  // namespace cca::sim::detail
