#pragma once
// The policy as symmetric as the robot: the mean of its answer and of the mirror image of its answer to the
// mirror image of what it observes.
//
// Left and right change places, and the stride is half a turn further on, since each leg does what that of
// the other side did half a stride ago. So a turn to the left is the mirror image of one to the right, and
// what training has learned of the one counts for the other.
//
// Ports, errors: those of cca::policy. Where it publishes nothing, this publishes nothing. Parameters: `file`
// of the weights, and `symmetric`: false, the policy alone. Source: Abdolhosseini, Ling, Xie, Peng, van de
// Panne, On learning symmetric locomotion, MIG 2019 (a symmetric network).
#include <tuple>

#include <cca/cca.hpp>

#include "policy.hpp"

namespace walking {

namespace mirrored {

inline stride_clock::vector_type clock(const stride_clock::vector_type& v) { return {-v[0], -v[1], v[2]}; }
inline downwards::vector_type down(const downwards::vector_type& v) { return {v[0], -v[1], v[2]}; }
// About the axes of the trunk: roll and yaw change their sign, pitch does not.
inline oncilla::trunk_angular_velocity::vector_type rates(
    const oncilla::trunk_angular_velocity::vector_type& v) {
  return {-v[0], v[1], -v[2]};
}
inline walking::course::vector_type course(const walking::course::vector_type& v) {
  return {-v[0], -v[1], v[2]};
}
// Of two neighbours one is a left leg, one a right leg.
inline oncilla::leg_angles::vector_type angles(const oncilla::leg_angles::vector_type& v) {
  oncilla::leg_angles::vector_type swapped;
  for (int i = 0; i < v.size(); i += 2) swapped[i] = v[i + 1], swapped[i + 1] = v[i];
  return swapped;
}

}  // namespace mirrored

struct symmetric_policy : policy {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::text<200>, file), (bool, symmetric));
  };
  parameters p{{}, true};

  auto process(cca::in<"clock", stride_clock> clock,
               cca::in<"down", downwards> down,
               cca::in<"rates", oncilla::trunk_angular_velocity> rates,
               cca::in<"course", course> course,
               cca::in<"angles", oncilla::leg_angles> angles)
      -> std::tuple<cca::maybe<"output", commanded_angles>, cca::out<"status", cca::input_status_port>> {
    const auto answer = policy::process(clock, down, rates, course, angles);
    const auto& here = std::get<0>(answer);
    if (!p.symmetric || !here) return answer;
    const auto image = [](const auto& input, const auto& numbers) {
      return std::remove_cvref_t<decltype(input)>(numbers, input.origin(), true);
    };
    const auto [there, status] = policy::process(
        image(clock, mirrored::clock(clock.vector())), image(down, mirrored::down(down.vector())),
        image(rates, mirrored::rates(rates.vector())), image(course, mirrored::course(course.vector())),
        image(angles, mirrored::angles(angles.vector())));
    const commanded_angles::vector_type mean = 0.5 * (here.vector() + mirrored::angles(there.vector()));
    return {mean, std::get<1>(answer)};
  }

  void on_load() {
    policy::p.file = p.file;
    policy::on_load();
  }
};

}  // namespace walking
