// trajectory_msgs/JointTrajectory: arrays of N elements, one for each point.
//
//   struct way : cca::array_of<arm_angles, 20> {};
//   joint_trajectory<way>                    and with way_velocities, way_accelerations, way_torques
//
//   always                    port "times"           trajectory_times<N>: s from the start, rising
//   of joint_angles           port "positions"       rad
//   of joint_velocities       port "velocities"      rad/s
//   of joint_accelerations    port "accelerations"   rad/s^2
//   of joint_torques          port "effort"          N m
//
// Each at most once, all over the same axes, whose names are the names of the joints, and all of N elements.
// A trajectory may have fewer points: those after the last time that rises are not sent, and where fewer come
// the last one is repeated. The stamp is 0, which means "at once": a controller of ROS 2 refuses a trajectory
// that ends in its past.
//
// Of a message that comes, joints are found by name, in any order; others are ignored. Refused: no point,
// more than N, times that do not rise, a joint that is missing or named twice, a field that is missing or of
// another length.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/base/array_size.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/joint_names.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/array.hpp>
#include <cca/space/joint.hpp>

namespace cca::ros2 {

// Seconds since the start of a trajectory, of each of its points.
struct trajectory_time : cca::detail::linear_domain {
  using quantity = duration;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
struct trajectory_point_axis : dimension<"time"> {};
struct trajectory_point_time : space<trajectory_time, axes<trajectory_point_axis>> {};
template <int Points>
struct trajectory_times : array_of<trajectory_point_time, Points> {};

namespace detail {

struct trajectory_point {
  message_sequence<double> positions, velocities, accelerations, effort;
  time_stamp time_from_start;
};
inline constexpr message_type duration_type{"builtin_interfaces/msg/Duration", time_fields,
                                            sizeof(time_stamp), alignof(time_stamp)};
inline constexpr std::array trajectory_point_fields{
    message_field{"positions", kind::float64, offsetof(trajectory_point, positions), message_field::sequence},
    message_field{"velocities", kind::float64, offsetof(trajectory_point, velocities),
                  message_field::sequence},
    message_field{"accelerations", kind::float64, offsetof(trajectory_point, accelerations),
                  message_field::sequence},
    message_field{"effort", kind::float64, offsetof(trajectory_point, effort), message_field::sequence},
    message_field{"time_from_start", kind::message, offsetof(trajectory_point, time_from_start), 1,
                  &duration_type},
};
inline constexpr message_type trajectory_point_type{"trajectory_msgs/msg/JointTrajectoryPoint",
                                                    trajectory_point_fields, sizeof(trajectory_point),
                                                    alignof(trajectory_point)};

struct trajectory_message {
  header head;
  message_sequence<char*> joint_names;
  message_sequence<trajectory_point> points;
};
inline constexpr std::array trajectory_message_fields{
    message_field{"header", kind::message, offsetof(trajectory_message, head), 1, &header_type},
    message_field{"joint_names", kind::string, offsetof(trajectory_message, joint_names),
                  message_field::sequence},
    message_field{"points", kind::message, offsetof(trajectory_message, points), message_field::sequence,
                  &trajectory_point_type},
};

template <class Domain>
struct trajectory_field {
  static constexpr fixed_string name{"none"};
  static constexpr message_sequence<double> trajectory_point::* values = nullptr;
};
template <>
struct trajectory_field<joint_angles> {
  static constexpr fixed_string name{"positions"};
  static constexpr auto values = &trajectory_point::positions;
};
template <>
struct trajectory_field<joint_velocities> {
  static constexpr fixed_string name{"velocities"};
  static constexpr auto values = &trajectory_point::velocities;
};
template <>
struct trajectory_field<joint_accelerations> {
  static constexpr fixed_string name{"accelerations"};
  static constexpr auto values = &trajectory_point::accelerations;
};
template <>
struct trajectory_field<joint_torques> {
  static constexpr fixed_string name{"effort"};
  static constexpr auto values = &trajectory_point::effort;
};

template <class Space> concept ArraySpace = requires { typename Space::element_space; };

template <class Space>
struct element_of {
  using type = Space;
};
template <ArraySpace Space>
struct element_of<Space> {
  using type = typename Space::element_space;
};

struct trajectory_words {
  static constexpr std::string_view name = "joint_trajectory";
  static constexpr std::string_view holds =
      "arrays with an element for each point, as in `struct way : cca::array_of<arm_angles, 20> {};`, of "
      "joint_angles (positions), joint_velocities (velocities), joint_accelerations (accelerations) and "
      "joint_torques (effort)";
  static constexpr std::string_view same =
      "the same axes and as many elements, as the axes are the joints and the elements the points";
  template <class Space>
  static constexpr std::string_view field = [] {
    using of_element = trajectory_field<typename element_of<Space>::type::domain>;
    return ArraySpace<Space> && of_element::values != nullptr ? of_element::name.view() : "";
  }();
};

inline time_stamp duration_of(double seconds) {
  const auto ns = std::isfinite(seconds)
                      ? static_cast<std::int64_t>(std::clamp(seconds, 0.0, 2e9) * 1e9 + 0.5)
                      : std::int64_t{0};
  return {static_cast<std::int32_t>(ns / 1'000'000'000), static_cast<std::uint32_t>(ns % 1'000'000'000)};
}
inline double seconds_of(const time_stamp& t) { return t.sec + 1e-9 * t.nanosec; }

}  // namespace detail

template <class First, class... Rest>
struct joint_trajectory {
  static_assert(
      cca::detail::holds_or_tells<detail::are_fields<detail::trajectory_words, First, Rest...>(),
                                  detail::other_fields<detail::trajectory_words, First, Rest...>>::value);
  static_assert(
      cca::detail::holds_or_tells<detail::share_joints<detail::trajectory_words, First, Rest...>,
                                  detail::other_joints<detail::trajectory_words, First, Rest...>>::value);
  template <class Space>
  using element = typename detail::element_of<Space>::type;

  static constexpr int joints = element<First>::size, points = First::size / joints;
  using ports = detail::port_list<
      detail::message_port<"times", trajectory_times<points>>,
      detail::message_port<detail::trajectory_field<typename element<First>::domain>::name, First>,
      detail::message_port<detail::trajectory_field<typename element<Rest>::domain>::name, Rest>...>;
  using message = detail::trajectory_message;
  static constexpr int size = ports::size;
  static constexpr detail::message_type type{
      "trajectory_msgs/msg/JointTrajectory", detail::trajectory_message_fields, sizeof(message),
      alignof(message), "RIHS01_179b33eba59d676f6d967ac71fe35e7ca2f64b2f3928f4a018cec115e213796e"};

  // Holds what a message points to.
  class maker {
  public:
    maker() {
      made.head.frame_id = frame.data();
      made.joint_names = names.all();
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t) {  // stamp 0: at once
      std::copy_n(from, size, values.begin());
      std::size_t count = 0;
      for (; count < at(points) && (count == 0 || values[count] > values[count - 1]); ++count) {
        auto& point = sent[count];
        point.time_from_start = detail::duration_of(values[count]);
        for (std::size_t f = 0; f < fields.size(); ++f)
          point.*fields[f] = detail::borrowed(values.data() + place(f, count), at(joints));
      }
      made.points = detail::borrowed(sent.data(), count);
      return &made;
    }

  private:
    detail::joint_names<element<First>> names;
    std::array<double, cca::detail::array_size(size)> values{};
    std::array<detail::trajectory_point, cca::detail::array_size(points)> sent{};
    std::string frame;  // joints have none
    message made;
  };

  // Null, or why it is refused.
  static const char* read(const message& m, double* to) {
    if (m.points.length == 0) return "no points";
    if (m.points.length > at(points)) return "more points than there is room for";
    std::array<std::size_t, cca::detail::array_size(joints)> places{};
    if (const char* const why = detail::joint_names<element<First>>::find(m.joint_names, places)) return why;
    for (std::size_t k = 0; k < at(points); ++k) {
      const auto& point = m.points.buffer[std::min<std::size_t>(k, m.points.length - 1)];
      for (const auto& all : {point.positions, point.velocities, point.accelerations, point.effort})
        if (all.length != 0 && all.length != m.joint_names.length)
          return "a field of another length than the names";
      to[k] = detail::seconds_of(point.time_from_start);
      if (to[k] < 0 || (k > 0 && k < m.points.length && !(to[k] > to[k - 1])))
        return "times that do not rise";
      for (std::size_t f = 0; f < fields.size(); ++f) {
        if ((point.*fields[f]).length == 0) return "a field is missing";
        for (std::size_t i = 0; i < at(joints); ++i)
          to[place(f, k) + i] = (point.*fields[f]).buffer[places[i]];
      }
    }
    return nullptr;
  }

private:
  static constexpr std::array fields{detail::trajectory_field<typename element<First>::domain>::values,
                                     detail::trajectory_field<typename element<Rest>::domain>::values...};
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
  // Of a field of a point: its first number among all; the times stand before them.
  static constexpr std::size_t place(std::size_t field, std::size_t point) {
    return at(points) + (field * at(points) + point) * at(joints);
  }
};

}  // namespace cca::ros2
