// What the inertial units of a compiled world read after a beat, or where it is put down.
#pragma once

#include <cstddef>
#include <type_traits>

#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/inertial_places.hpp>
#include <cca/sim/compiled/whole_robot.hpp>
#include <cca/sim/robot/model/ideal_inertial_unit.hpp>

namespace cca::sim::detail {

// Of a scalar that is no double there are no readings.
template <class R, class Real>
void read_units(compiled_state<R, Real>& state, bool after_beat, double beat, double gravity) {
  if constexpr (std::is_same_v<Real, double>)
    for (std::size_t i = 0; i < state.inertial.size(); ++i) {
      const moving_frame now = whole_robot<R, Real>::frame_of(state.motion, inertial_places<R>[i]);
      const Eigen::Vector3d before = cca::detail::as_vector(state.unit_speeds[i]);
      state.inertial[i] = inertial_reading_of(now, after_beat ? before : now.velocity, beat, gravity);
      state.unit_speeds[i] = {now.velocity[0], now.velocity[1], now.velocity[2]};
    }
}

}  // namespace cca::sim::detail
