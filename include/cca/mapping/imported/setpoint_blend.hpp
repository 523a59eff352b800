// Takes the setpoints of the active mode without a jump: where others begin, it goes from what was applied to
// what they want, within `duration`. All modes share its node, so it knows what was applied.
//
//   cca::setpoint_blend<angles>          its node: cca::timed<1>
//
//   in  "target", "stiffness", "damping", "begins"    of the setpoints of this mode (setpoints.hpp)
//   in  "measured"    Angles     optional_in; where the very first blend begins, else at the first target
//   out "target"      Angles                       maybe, each beat from the first target on
//   out "stiffness"   setpoint_stiffness<Angles>   maybe
//   out "damping"     setpoint_damping<Angles>     maybe
//
// With s from 0 to 1 in even steps of dt / duration, each number is  from + s (wanted - from). So between two
// beats a switch moves a target by at most  dt / duration |wanted - from|,  and so the gains; beside that
// only s times the step that the policy itself makes. In the beat of the switch nothing moves.
//
// Until the new setpoints come it holds what was applied. Numbers that are not finite count as not come.
// `on_start` forgets what was applied. Errors: component.bad_parameter. Docs: docs/policies.md.
#pragma once

#include <algorithm>
#include <tuple>

#include <cca/mapping/imported/setpoints.hpp>

namespace cca {

template <Space Angles>
struct setpoint_blend {
  using vector = typename Angles::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::quantity<cca::duration, 0, 60>, duration));
  };
  parameters p{0.2};

  auto process(in<"target", Angles> target,
               in<"stiffness", setpoint_stiffness<Angles>> stiffness,
               in<"damping", setpoint_damping<Angles>> damping,
               in<"begins", setpoint_begin> begins,
               optional_in<"measured", Angles> measured,
               beat now) -> std::tuple<maybe<"target", Angles>,
                                       maybe<"stiffness", setpoint_stiffness<Angles>>,
                                       maybe<"damping", setpoint_damping<Angles>>> {
    if (detail::has_come(target) && detail::has_come(stiffness) && detail::has_come(damping)) {
      const setpoint wanted{target.vector(), stiffness.vector(), damping.vector()};
      if (begins.fresh() || !has_applied_) {
        from_ = applied_;
        if (!has_applied_) {
          from_ = wanted;
          if (measured && detail::has_come(measured)) from_.target = measured.vector();
        }
        has_applied_ = true;
        seconds_ = 0;
      } else {
        seconds_ += now.dt();
      }
      const double s = p.duration > 0 ? std::min(1.0, seconds_ / p.duration) : 1;
      applied_.target = from_.target + s * (wanted.target - from_.target);
      applied_.stiffness = from_.stiffness + s * (wanted.stiffness - from_.stiffness);
      applied_.damping = from_.damping + s * (wanted.damping - from_.damping);
    }
    if (!has_applied_) return {};
    return {applied_.target, applied_.stiffness, applied_.damping};
  }
  void on_start() { has_applied_ = false; }

private:
  struct setpoint {
    vector target = vector::Zero(), stiffness = vector::Zero(), damping = vector::Zero();
  };
  setpoint from_, applied_;
  double seconds_ = 0;
  bool has_applied_ = false;
};

}  // namespace cca
