// What wants to move the joints, one of these in each mode of a robot: targets with the gains that they are
// meant for. A setpoint_blend (setpoint_blend.hpp) that all modes share takes them without a jump.
//
//   cca::policy_setpoints<walk::contract, targets, angles>      of an imported policy: the gains of its contract
//     in  "target"     Target       wire it with cca::latest: a policy is slower than the robot
//
//   cca::standing_setpoints<angles>      `stand`: from where the targets are to `pose`, within `duration`
//   cca::damping_setpoints<angles>       `damp`: no stiffness, the joints are only braked
//     in  "applied"    Angles       what the blend puts out: wire it with cca::delayed<1>
//     in  "measured"   Angles       where it begins if nothing has been applied yet
//
//   each:
//   out "target"     Angles                       maybe; rad
//   out "stiffness"  setpoint_stiffness<Angles>   maybe; N m/rad
//   out "damping"    setpoint_damping<Angles>     maybe; N m s/rad
//   out "begins"     setpoint_begin               maybe; once after `on_start`, with the first target
//
// Give their nodes cca::timed<1>. A policy publishes nothing until its first target comes; the blend then
// holds. Gains are matched by name with the axes; a missing one does not compile (mapping.policy_numbers).
// Numbers that are not finite: a policy has none, `applied` and `measured` count as not come.
// Errors: mapping.policy_numbers; component.bad_parameter. Example: tests/runtime/policies/switching.cpp;
// docs/policies.md.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

#include <cca/component/beat.hpp>
#include <cca/component/input_status.hpp>
#include <cca/component/parameters.hpp>
#include <cca/mapping/imported/policy_gains_check.hpp>

namespace cca {

template <class Angles>
struct setpoint_stiffness : space<joint_stiffness, typename Angles::axes> {};
template <class Angles>
struct setpoint_damping : space<joint_damping, typename Angles::axes> {};
struct setpoint_axis : dimension<"setpoint"> {};
struct setpoint_begin : space<number, axes<setpoint_axis>> {};

template <class Angles>
using setpoint_outputs = std::tuple<maybe<"target", Angles>,
                                    maybe<"stiffness", setpoint_stiffness<Angles>>,
                                    maybe<"damping", setpoint_damping<Angles>>,
                                    maybe<"begins", setpoint_begin>>;

namespace detail {

template <class Angles>
setpoint_outputs<Angles> setpoints_of(const typename Angles::vector_type& target,
                                      const typename Angles::vector_type& stiffness,
                                      const typename Angles::vector_type& damping,
                                      bool begins) {
  setpoint_outputs<Angles> all{target, stiffness, damping, {}};
  if (begins) std::get<3>(all) = setpoint_begin::vector_type::Ones().eval();
  return all;
}

template <class Vector>
std::string_view wrong_gains(const Vector& stiffness, const Vector& damping) {
  if (!all_finite(stiffness) || stiffness.minCoeff() < 0) return "a stiffness is negative or not finite";
  if (!all_finite(damping) || damping.minCoeff() < 0) return "a damping is negative or not finite";
  return "";
}

}  // namespace detail

template <class Contract, Space Target, Space Angles>
struct policy_setpoints {
  using checked = detail::policy_gains_check<Contract, Angles, Target>;
  static_assert(detail::holds_or_tells<checked::holds, checked>::value);

  auto process(in<"target", Target> target) -> setpoint_outputs<Angles> {
    if (!detail::has_come(target)) return {};
    const bool begins = std::exchange(comes_, false);
    typename Angles::vector_type stiffness, damping;
    for (std::size_t i = 0; i < Contract::gains.size(); ++i) {
      const int at = detail::places_of<detail::gains_of<Contract>, Angles>[i];
      stiffness[at] = Contract::gains[i].stiffness;
      damping[at] = Contract::gains[i].damping;
    }
    return detail::setpoints_of<Angles>(target.vector(), stiffness, damping, begins);
  }
  void on_start() { comes_ = true; }

private:
  bool comes_ = true;
};

template <Space Angles>
struct standing_setpoints {
  using vector = typename Angles::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (vector, pose),       // rad
                             (vector, stiffness),  // N m/rad
                             (vector, damping),    // N m s/rad
                             (cca::quantity<cca::duration, 0, 60>, duration));
    parameters(const vector& rad = vector::Zero(),
               const vector& n_m_per_rad = vector::Constant(20),
               const vector& n_m_s_per_rad = vector::Constant(1),
               double s = 1)
        : pose(rad), stiffness(n_m_per_rad), damping(n_m_s_per_rad), duration(s) {}
    std::string_view check() const {
      return detail::all_finite(pose) ? detail::wrong_gains(stiffness, damping) : "`pose` is not finite";
    }
  };
  parameters p{};

  auto process(in<"applied", Angles> applied, in<"measured", Angles> measured, beat now)
      -> setpoint_outputs<Angles> {
    const bool begins = comes_;
    if (comes_) {
      if (detail::has_come(applied)) from_ = applied.vector();
      else if (detail::has_come(measured)) from_ = measured.vector();
      else return {};
      comes_ = false;
      seconds_ = 0;
    } else {
      seconds_ += now.dt();
    }
    const double s = p.duration > 0 ? std::min(1.0, seconds_ / p.duration) : 1;
    return detail::setpoints_of<Angles>(from_ + s * s * (3 - 2 * s) * (p.pose - from_), p.stiffness,
                                        p.damping, begins);
  }
  void on_start() { comes_ = true; }

private:
  vector from_ = vector::Zero();
  double seconds_ = 0;
  bool comes_ = true;
};

template <Space Angles>
struct damping_setpoints {
  using vector = typename Angles::vector_type;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (vector, damping));  // N m s/rad
    parameters(const vector& n_m_s_per_rad = vector::Constant(1)) : damping(n_m_s_per_rad) {}
    std::string_view check() const { return detail::wrong_gains(vector(vector::Zero()), damping); }
  };
  parameters p{};

  auto process(in<"applied", Angles> applied, in<"measured", Angles> measured) -> setpoint_outputs<Angles> {
    const bool begins = comes_;
    if (comes_) {
      if (detail::has_come(applied)) from_ = applied.vector();
      else if (detail::has_come(measured)) from_ = measured.vector();
      else return {};
      comes_ = false;
    }
    return detail::setpoints_of<Angles>(from_, vector::Zero(), p.damping, begins);
  }
  void on_start() { comes_ = true; }

private:
  vector from_ = vector::Zero();
  bool comes_ = true;
};

}  // namespace cca
