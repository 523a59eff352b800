// Spaces and states that the compliant components derive from the user's spaces. They have no rate, so they
// fit any graph.
//
//   stiffness_along<Torques>, damping_along<Torques>   of the joints, over the axes of Torques
//   stiffness_at<Tip, In>, damping_at<Tip, In>         of the origin of Tip, along the axes of In
//   motion_of<Tip, In>, load_on<Tip, In>               twist and wrench of it
//   pose_in<Frame>                                     a pose
//   tip_of<Body, "part">                               the frame in which a part ends
//   saturation_port                                    what was cut in this firing (enum saturation)
//
// NaN: names and functions, they keep nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include <cca/base/after_run.hpp>
#include <cca/component/input_status.hpp>
#include <cca/robot/body.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/space.hpp>

namespace cca {

template <class Torques>
struct stiffness_along : space<joint_stiffness, typename Torques::axes> {};
template <class Torques>
struct damping_along : space<joint_damping, typename Torques::axes> {};

template <class Tip, class In>
struct stiffness_at : space<cartesian_stiffness<Tip, In>, axes<x, y, z>> {};
template <class Tip, class In>
struct damping_at : space<cartesian_damping<Tip, In>, axes<x, y, z>> {};
template <class Tip, class In>
struct motion_of : space<twist<Tip, In>, axes<x, y, z>> {};
template <class Tip, class In>
struct load_on : space<wrench<Tip, In>, axes<x, y, z>> {};

template <class Frame>
struct pose_in : space<pose<Frame>, axes<x, y, z>> {};

// Of two that happen, the larger number is published.
enum class saturation : std::uint8_t {
  none,
  spring,  // the spring pulls with its largest torque or force, less than stiffness times displacement
  motion,  // a displacement or a velocity is at its limit
  torque   // a joint is at the limit of its torque: the compliance is not as designed
};
struct saturation_axis : dimension<"saturation"> {};
struct saturation_port : space<status, axes<saturation_axis>> {};

namespace detail {

template <class Body, fixed_string Part>
struct end_of_part {
  using body = checked_body<Body>;
  static constexpr int index = part_index<body>(Part.view());
  static_assert(holds_or_tells<(index >= 0), unknown_part<body, Part>>::value);
  using frame = typename std::tuple_element_t<static_cast<std::size_t>(index < 0 ? 0 : index),
                                              typename body::parts>::chain::tip_frame;
};

// The worse of two statuses.
constexpr input_status worse(input_status a, input_status b) { return a < b ? b : a; }

// Counts what a compliant component publishes in `status` and `saturation`, whether they are read or not.
struct compliance_counts {
  std::int64_t unreadable = 0, clamped = 0, spring = 0, motion = 0, torque = 0;

  void note(input_status inputs, saturation cut) {
    if (inputs == input_status::usable && cut == saturation::none) [[likely]]
      return;
    unreadable += inputs == input_status::unreadable;
    clamped += inputs == input_status::clamped;
    spring += cut == saturation::spring;
    motion += cut == saturation::motion;
    torque += cut == saturation::torque;
  }
  std::string summary() const {
    std::string text;
    const auto add = [&](std::int64_t times, const char* what) {
      if (times > 0) text += (text.empty() ? "" : "; ") + formatted(what, static_cast<long long>(times));
    };
    add(torque, "%lld times a torque was at the limit of its joint");
    add(spring, "%lld times the spring, or the force control, was at its largest force");
    add(motion, "%lld times the motion was at `fastest` or `farthest`");
    add(unreadable, "%lld times an input was not finite");
    add(clamped, "%lld times an input was beyond its bound");
    return text;
  }
};

// Of a stiffness or a damping: what is negative counts as 0.
template <class Vector>
Vector at_least_zero(input_check& inputs, const Vector& v) {
  Vector x;
  for (int i = 0; i < x.size(); ++i) x[i] = inputs.number(v[i], 0);
  return x;
}

// Within the limits that the axes of Torques state; `cut` becomes true if a number was outside.
template <class Torques>
typename Torques::vector_type within_torque_limits(const typename Torques::vector_type& wanted, bool& cut) {
  const typename Torques::vector_type within = sample<Torques>(wanted).clamped().vector();
  cut = cut || (within.array() != wanted.array()).any();
  return within;
}

}  // namespace detail

template <class Body, fixed_string Part>
using tip_of = typename detail::end_of_part<Body, Part>::frame;

}  // namespace cca
