// Where the arm has to be when the ball comes: from the places where it was seen, and when.
//
//   in  "spot"      where the ball was seen; its origin says when, however long the image took
//   out "command"   the angle of the arm
//   out "age"       s, how old the newest spot was when it arrived
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <cca/base/math.hpp>

#include "table.hpp"

namespace vision {

struct age : cca::space<cca::number, cca::axes<cca::value>> {};

class catcher {
public:
  auto process(cca::in<"spot", point> spot, cca::beat now) -> cca::out<"command", arm_angle> {
    if (spot.fresh()) {
      const double seen = 1e-9 * static_cast<double>(spot.origin());
      ages += 1e-9 * static_cast<double>(now.time() - spot.origin());
      ++spots;
      remember(seen, spot.vector());
    }
    return cca::math::asin(std::clamp(crossing() / reach, -0.95, 0.95));
  }

  double ages = 0;  // s, of all spots when they arrived
  std::int64_t spots = 0;

private:
  struct sight {
    double time;
    Eigen::Vector2d at;
  };
  static constexpr int most = 24;

  // A new throw, or a wall: what was seen before is of another line.
  void remember(double time, const Eigen::Vector2d& at) {
    if (count > 1) {
      const Eigen::Vector2d expected = last().at + (time - last().time) * velocity();
      if ((at - expected).norm() > 0.02) count = 0;
    }
    if (count == most) std::move(sights.begin() + 1, sights.end(), sights.begin()), --count;
    sights[static_cast<std::size_t>(count++)] = {time, at};
  }
  const sight& last() const { return sights[static_cast<std::size_t>(count - 1)]; }
  // The slope of the line through all that was seen.
  Eigen::Vector2d velocity() const {
    sight mean{0, {0, 0}};
    for (int i = 0; i < count; ++i) {
      mean.time += sights[static_cast<std::size_t>(i)].time / count;
      mean.at += sights[static_cast<std::size_t>(i)].at / count;
    }
    double square = 0;
    Eigen::Vector2d product(0, 0);
    for (int i = 0; i < count; ++i) {
      const sight& one = sights[static_cast<std::size_t>(i)];
      square += (one.time - mean.time) * (one.time - mean.time);
      product += (one.time - mean.time) * (one.at - mean.at);
    }
    return square > 0 ? Eigen::Vector2d(product / square) : Eigen::Vector2d(0, 0);
  }
  // Where it crosses the line of the hand, after its bounces.
  double crossing() const {
    if (count < 3) return count > 0 ? last().at[1] : 0;
    const Eigen::Vector2d v = velocity();
    if (v[0] > -0.1) return last().at[1];
    double y = last().at[1] - last().at[0] / v[0] * v[1];
    for (int bounce = 0; bounce < 4 && std::abs(y) > half_width; ++bounce)
      y = (y > 0 ? 2 : -2) * half_width - y;
    return y;
  }

  std::array<sight, most> sights{};
  int count = 0;
};

}  // namespace vision
