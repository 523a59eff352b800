// A terrain in the engine, strip by strip.
//
// A single box of the engine serves as ground: it is moved under the part that asks, so the ground has no end
// and needs no memory. Strips come from left to right.
#pragma once

#include <algorithm>
#include <array>

#include <ode/ode.h>

#include <cca/base/math.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/engine/terrain.hpp>

namespace cca::sim {

class ground_strips {
public:
  explicit ground_strips(const terrain& shape) : shape_(shape), box_(dCreateBox(nullptr, 1, 1, 1)) {}

  double friction() const { return shape_.friction(); }

  // Calls f(box) for each strip that the part may touch. The top of the box is the ground there.
  template <class F>
  void each_under(dGeomID part, F f) const {
    std::array<dReal, 6> bounds;  // of the part: x, y, z, each from and to
    dGeomGetAABB(part, bounds.data());
    const double y = (bounds[2] + bounds[3]) / 2, across = bounds[3] - bounds[2] + 2 * margin,
                 high = bounds[5] - bounds[4];
    shape_.strips_between(bounds[0], bounds[1], [&](const ground_strip& strip) {
      const double begin = std::max(strip.begin, bounds[0] - margin),
                   end = std::min(strip.end, bounds[1] + margin);
      if (bounds[4] > std::max(strip.height(begin), strip.height(end))) return;
      put_box(strip, begin, end, y, std::max(width, across), std::max(depth, high + margin));
      f(box_.get());
    });
  }

private:
  static constexpr double depth = 1.0, width = 2.0;  // m, of the box; more under a larger part
  static constexpr double margin = 0.2;  // m beyond the part, so it never touches an edge that isn't there

  // Makes the top of the box the ground from `begin` to `end`.
  void put_box(
      const ground_strip& strip, double begin, double end, double y, double wide, double deep) const {
    const auto [n, c] = math::sine_and_cosine(strip.pitch);
    const double length = (end - begin) / c, along = length / 2, down = deep / 2;
    dGeomBoxSetLengths(box_.get(), length, wide, deep);
    dGeomSetPosition(box_.get(), begin + along * c + down * n, y, strip.height(begin) + along * n - down * c);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, -1, 0, strip.pitch);
    dGeomSetRotation(box_.get(), rotation);
  }

  terrain shape_;
  engine_handle<dxGeom> box_;
};

}  // namespace cca::sim
