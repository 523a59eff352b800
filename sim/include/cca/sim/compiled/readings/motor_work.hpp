// What the motors of a compiled world do in a step: their torques, as means over the beat, and their work.
#pragma once

#include <cstddef>

#include <cca/sim/compiled/compiled_state.hpp>

namespace cca::sim::detail {

// `share`: of the step in the beat. A motor that winds a cable works at the speed of its pulley.
template <class R, class Real>
constexpr void account_motors(compiled_state<R, Real>& s, double h, const Real& share) {
  for (std::size_t c = 0; c < s.joints.size(); ++c) {
    const Real& torque = s.drives.torque[c];
    s.joints[c].torque = s.joints[c].torque + share * torque;
    const bool winds = R::drives[c].cable.stiffness > 0;
    const Real work = Real(h) * torque * (winds ? s.drives.pulleys[c].speed : s.motion.dq[c]);
    s.positive_work = s.positive_work + larger(work, Real(0.0));
    s.absolute_work = s.absolute_work + larger(work, -work);
  }
}

}  // namespace cca::sim::detail
