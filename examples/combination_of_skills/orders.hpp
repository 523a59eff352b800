#pragma once
// What each step of the plan asks for: an amplitude of the oscillator, a point for each foot.
//
//   in  "step"               step_port of the sequencer
//   in  "ball", "aim"        point_in_trunk: the ball, and the point to send the paw to
//   in  "side"               side_port: which paw
//   out "amplitude"          of the gait; negative: stand
//   out "left_front" ...     point_in_trunk: where to put the feet, or what they swing around
//   out "stiffness"          of the hips
//   out "supports"           1 for legs that stand
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>

#include <cca/adaptive/sequencer.hpp>
#include <cca/cca.hpp>

#include "legs.hpp"
#include "plan.hpp"

namespace skills {

struct orders {
  struct foot_place {
    BOOST_HANA_DEFINE_STRUCT(foot_place,
                             (cca::quantity<cca::length, -0.2, 0.2>, ahead),  // of the hip
                             (cca::quantity<cca::length, 0.05, 0.25>, below));
  };
  struct trotting {
    BOOST_HANA_DEFINE_STRUCT(trotting,
                             (cca::quantity<cca::speed, 0, 1>, speed),
                             (double, intercept),
                             (double, slope),  // amplitude = intercept + slope * speed
                             (cca::quantity<cca::duration, 0, 3600>, start),  // stand first, so long
                             (cca::bounded<double, 0, 10>,
                              slowing),                            // speed per remaining way to the ball, 1/s
                             (cca::bounded<double, 0, 1>, least),  // amplitude on that way
                             (foot_place, front),
                             (foot_place, hind),  // what feet swing around
                             (cca::quantity<cca::stiffness, 0, 200>, stiffness));
  };
  struct standing {
    BOOST_HANA_DEFINE_STRUCT(standing,
                             (foot_place, feet),  // moves the trunk back and down
                             (cca::quantity<cca::length, 0, 0.1>,
                              aside),  // feet towards the paw, so the trunk leans away from it
                             (cca::quantity<cca::length, 0, 0.1>, lift),
                             (cca::quantity<cca::stiffness, 0, 200>, stiffness),
                             (cca::quantity<cca::duration, 0.01, 2>, stiffening));
  };
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (trotting, trot), (standing, stand));
  };
  parameters p{{0.68, 0.266, 1.008, 0.2, 3.0, 0.45, {0.0382, 0.1596}, {0.0212, 0.1742}, 30},
               {{0.065, 0.130}, 0.014, 0.030, 120, 0.2}};

  auto process(cca::in<"step", cca::step_port> step,
               cca::in<"ball", point_in_trunk> ball,
               cca::in<"aim", point_in_trunk> aim,
               cca::in<"side", side_port> side,
               cca::beat now) -> std::tuple<cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                            cca::out<"left_front", point_in_trunk>,
                                            cca::out<"right_front", point_in_trunk>,
                                            cca::out<"left_hind", point_in_trunk>,
                                            cca::out<"right_hind", point_in_trunk>,
                                            cca::out<"stiffness", wanted_stiffness>,
                                            cca::out<"supports", supports>> {
    const int now_on = static_cast<int>(step[cca::step_axis{}]);
    const auto from_to = [&](int first, int last) { return first <= now_on && now_on <= last; };
    const bool trots = now_on == plan::at<"trot"> || now_on == plan::at<"trot on">;
    const bool shifted = from_to(plan::at<"shift weight">, plan::at<"put down">);
    const bool raised = from_to(plan::at<"lift paw">, plan::at<"draw back">);
    const bool reaching = from_to(plan::at<"reach">, plan::at<"touch">);
    const std::size_t paw = side.is(paw_side::right) ? 1 : 0;

    std::array<Eigen::Vector3d, 4> feet;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const foot_place& at = shifted ? p.stand.feet : oncilla::is_front(leg) ? p.trot.front : p.trot.hind;
      const double aside = shifted ? oncilla::side_of(paw) * p.stand.aside : 0.0;
      feet[leg] = hip_in_trunk(leg) + Eigen::Vector3d(at.ahead, aside, -at.below);
    }
    if (raised) feet[paw][2] += p.stand.lift;
    if (reaching) feet[paw] = aim.vector();

    double amplitude = -1;
    if (trots && 1e-9 * static_cast<double>(now.time()) >= p.trot.start) {
      amplitude = p.trot.intercept + p.trot.slope * p.trot.speed;
      if (now_on == plan::at<"trot"> && ball.origin() != cca::never)
        amplitude = std::max<double>(p.trot.least, slowed(way_left(ball)));
    }
    stiffness += std::min(1.0, now.dt() / p.stand.stiffening) *
                 ((trots ? p.trot.stiffness : p.stand.stiffness) - stiffness);
    supports::vector_type carrying =
        supports::vector_type::Constant(shifted || now_on == plan::at<"stand"> ? 1.0 : 0.0);
    if (raised) carrying[static_cast<int>(paw)] = 0;
    // The aim rests while no paw reaches.
    const std::int64_t origin =
        reaching ? oldest_origin(step, ball, side, aim) : oldest_origin(step, ball, side);
    return {cca::out<"amplitude", cca::over<cca::amplitude, stride>>(amplitude).with_origin(origin),
            cca::out<"left_front", point_in_trunk>(feet[0]).with_origin(origin),
            cca::out<"right_front", point_in_trunk>(feet[1]).with_origin(origin),
            cca::out<"left_hind", point_in_trunk>(feet[2]).with_origin(origin),
            cca::out<"right_hind", point_in_trunk>(feet[3]).with_origin(origin),
            cca::out<"stiffness", wanted_stiffness>(wanted_stiffness::vector_type::Constant(stiffness))
                .with_origin(origin),
            cca::out<"supports", supports>(carrying).with_origin(origin)};
  }

  void on_start() { stiffness = p.trot.stiffness; }

private:
  double slowed(double way) const {
    return p.trot.intercept + p.trot.slope * std::clamp<double>(p.trot.slowing * way, 0, p.trot.speed);
  }

  double stiffness = 30;
};

}  // namespace skills
