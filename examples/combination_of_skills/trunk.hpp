#pragma once
// Components for the trunk: is it still, heading, steering, and a reflex against swaying.
#include <algorithm>
#include <array>

#include <cca/adaptive/criterion.hpp>
#include <cca/cca.hpp>

#include "legs.hpp"

namespace skills {

// Fulfilled while the trunk is still: its low-passed rates of turn have been small for a while.
//
// They are low-passed twice: each by itself, because the size of a noisy vector is never small, and then
// their size, because that of a swaying trunk is small whenever it turns back.
//
//   in  "angular_velocity"   trunk_angular_velocity
//   out "status"             trunk_status: a criterion_state
struct stillness {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::error_limits<cca::velocity>, limits),           // rad/s
                             (cca::quantity<cca::duration, 0.001, 1>, smoothing),  // of their size
                             (cca::quantity<cca::duration, 0.001, 1>, each));      // of each rate
  };
  parameters p{{0.15, 0.15, cca::infinity, 0.1}, 0.05, 0.01};

  auto process(cca::in<"angular_velocity", oncilla::trunk_angular_velocity> turning, cca::beat now)
      -> cca::out<"status", trunk_status> {
    rates += std::min(1.0, now.dt() / p.each) * (turning.vector() - rates);
    smooth += std::min(1.0, now.dt() / p.smoothing) * (rates.norm() - smooth);
    return cca::status_of(monitor.update(smooth, p.limits, now.dt()));
  }

private:
  Eigen::Vector3d rates = Eigen::Vector3d::Zero();  // rad/s
  double smooth = 0;                                // rad/s
  cca::error_monitor monitor;
};

// Heads for the ball while that is ahead, so that the ball comes in front of the paw; otherwise holds the
// direction of the start.
//
//   in  "orientation"   trunk_orientation
//   in  "ball"          point_in_trunk
//   in  "side"          side_port: the paw
//   in  "amplitude"     of the gait; nothing is integrated while it stands
//   out "turn"          turning, -most to most
struct heading {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 10>, gain),   // turn per rad
                             (cca::bounded<double, 0, 10>, drift),  // turn per rad s
                             (cca::bounded<double, 0, 1>, most),    // turn
                             (cca::quantity<cca::length, 0, 10>,
                              near),  // does not head for a ball nearer than this
                             (cca::quantity<cca::length, 0, 0.1>,
                              inside));  // of the hip: from there the paw reaches equally far to both sides
  };
  parameters p{1.2, 0.4, 0.5, 0.3, 0.014};

  auto process(cca::in<"orientation", oncilla::trunk_orientation> trunk,
               cca::in<"ball", point_in_trunk> ball,
               cca::in<"side", side_port> side,
               cca::in<"amplitude", cca::over<cca::amplitude, stride>> amplitude,
               cca::beat now) -> cca::out<"turn", turning> {
    const std::size_t leg = side.is(paw_side::right) ? 1 : 0;
    const Eigen::Vector3d hip = hip_in_trunk(leg);
    const double ahead = ball[cca::x{}] - hip[0],
                 beside = ball[cca::y{}] - hip[1] + oncilla::side_of(leg) * p.inside;
    const double off =
        ball.origin() != cca::never && ahead > p.near ? -cca::math::atan2(beside, ahead) : trunk.yaw();
    constexpr double swinging = 0.1;
    if (amplitude[stride{}] > swinging) {
      const double largest = p.drift > 0 ? p.most / p.drift : 0.0;  // more has no effect
      aside = std::clamp(aside + now.dt() * off, -largest, largest);
    } else {
      aside = 0;
    }
    return std::clamp(-p.gain * off - p.drift * aside, -p.most, +p.most);
  }

private:
  double aside = 0;  // rad s
};

// Legs on one side swing farther, those on the other side less.
//
//   in  "goal"     leg_angles: the angles around which the hips swing
//   in  "turn"     turning
//   in  "command"  leg_angles
//   out "angles"   leg_angles
struct steering {
  auto process(cca::in<"goal", oncilla::leg_angles> goal,
               cca::in<"turn", turning> turn,
               cca::in<"command", oncilla::leg_angles> command) -> cca::out<"angles", oncilla::leg_angles> {
    oncilla::leg_angles::vector_type angles = command.vector();
    for (int leg = 0; leg < 4; ++leg)
      angles[leg] -= oncilla::side_of(static_cast<std::size_t>(leg)) * turn[yaw{}] *
                     (command.vector()[leg] - goal.vector()[leg]);
    // The heading rests while the gait does: then its turn is old, and the command is not.
    return cca::out<"angles", oncilla::leg_angles>(angles).with_origin(oldest_origin(goal, command));
  }
};

// A reflex against swaying on springs: where the trunk sinks above a standing leg, that leg stretches.
//
//   in  "angular_velocity"   trunk_angular_velocity
//   in  "supports"           supports: 1 for the legs that stand
//   in  "command"            leg_angles
//   out "angles"             leg_angles
//
// The speed at which a hip sinks follows from the trunk's rates of turn; the knee stretches by `time` times
// that, at most by `most`. The rates are low-passed: the toe and the knee's cable answer late, and with raw
// rates the trunk went on rocking, so the paw was never lifted. Rates that are not finite count as none, so
// the correction fades.
struct balance {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::duration, 0, 0.2>, time),
                             (cca::quantity<cca::duration, 0.001, 1>, smoothing),  // of the rates of turn
                             (cca::quantity<cca::length, 0.01, 0.2>,
                              lever),  // of the foot's height per angle of the knee, m
                             (cca::quantity<cca::angle, 0, 0.5>, most));
  };
  parameters p{0.03, 0.01, 0.09, 0.1};

  auto process(cca::in<"angular_velocity", oncilla::trunk_angular_velocity> turning,
               cca::in<"supports", supports> standing,
               cca::in<"command", oncilla::leg_angles> command,
               cca::beat now) -> cca::out<"angles", oncilla::leg_angles> {
    oncilla::leg_angles::vector_type angles = command.vector();
    const Eigen::Vector3d rates = turning.vector().allFinite() ? turning.vector() : Eigen::Vector3d::Zero();
    w += std::min(1.0, now.dt() / p.smoothing) * (rates - w);
    for (int leg = 0; leg < 4; ++leg) {
      const Eigen::Vector3d hip = hip_in_trunk(static_cast<std::size_t>(leg));
      const double rising = w[0] * hip[1] - w[1] * hip[0];
      angles[4 + leg] += standing.vector()[leg] * std::clamp(p.time / p.lever * rising, -p.most, +p.most);
    }
    return angles;
  }

private:
  Eigen::Vector3d w = Eigen::Vector3d::Zero();  // rad/s
};

}  // namespace skills
