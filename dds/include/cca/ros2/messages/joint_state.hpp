// sensor_msgs/JointState: the domain types decide which field a space is.
//
//   joint_state<leg_angles, leg_velocities, leg_torques>
//
//   joint_angles       port "position"   rad
//   joint_velocities   port "velocity"   rad/s
//   joint_torques      port "effort"     N m
//
// Each at most once, all over the same axes, whose names are the names of the joints. Fields without a space
// are sent empty. Of a message that comes, joints are found by name, in any order; others are ignored.
// Refused: a joint that is missing or named twice, a field that is missing or of another length.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/base/array_size.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/joint_names.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/joint.hpp>

namespace cca::ros2 {

namespace detail {

struct joint_state_message {
  header head;
  message_sequence<char*> name;
  message_sequence<double> position, velocity, effort;
};
inline constexpr std::array joint_state_fields{
    message_field{"header", kind::message, offsetof(joint_state_message, head), 1, &header_type},
    message_field{"name", kind::string, offsetof(joint_state_message, name), message_field::sequence},
    message_field{"position", kind::float64, offsetof(joint_state_message, position),
                  message_field::sequence},
    message_field{"velocity", kind::float64, offsetof(joint_state_message, velocity),
                  message_field::sequence},
    message_field{"effort", kind::float64, offsetof(joint_state_message, effort), message_field::sequence},
};

template <class Domain>
struct joint_field {
  static constexpr fixed_string name{"none"};
  static constexpr message_sequence<double> joint_state_message::* values = nullptr;
};
template <>
struct joint_field<joint_angles> {
  static constexpr fixed_string name{"position"};
  static constexpr auto values = &joint_state_message::position;
};
template <>
struct joint_field<joint_velocities> {
  static constexpr fixed_string name{"velocity"};
  static constexpr auto values = &joint_state_message::velocity;
};
template <>
struct joint_field<joint_torques> {
  static constexpr fixed_string name{"effort"};
  static constexpr auto values = &joint_state_message::effort;
};

template <class Space>
constexpr bool has_joint_field = joint_field<typename Space::domain>::values != nullptr;

struct joint_state_words {
  static constexpr std::string_view name = "joint_state";
  static constexpr std::string_view holds =
      "joint_angles (position), joint_velocities (velocity) and joint_torques (effort)";
  static constexpr std::string_view same = "the same axes, as the axes are the joints";
  template <class Space>
  static constexpr std::string_view field =
      has_joint_field<Space> ? joint_field<typename Space::domain>::name.view() : "";
};

}  // namespace detail

template <class First, class... Rest>
struct joint_state {
  static_assert(
      cca::detail::holds_or_tells<detail::are_fields<detail::joint_state_words, First, Rest...>(),
                                  detail::other_fields<detail::joint_state_words, First, Rest...>>::value);
  static_assert(
      cca::detail::holds_or_tells<detail::share_joints<detail::joint_state_words, First, Rest...>,
                                  detail::other_joints<detail::joint_state_words, First, Rest...>>::value);

  using ports =
      detail::port_list<detail::message_port<detail::joint_field<typename First::domain>::name, First>,
                        detail::message_port<detail::joint_field<typename Rest::domain>::name, Rest>...>;
  using message = detail::joint_state_message;
  static constexpr int size = ports::size;
  static constexpr detail::message_type type{
      "sensor_msgs/msg/JointState", detail::joint_state_fields, sizeof(message), alignof(message),
      "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e"};

  // Holds what a message points to.
  class maker {
  public:
    maker() {
      made.head.frame_id = frame.data();
      made.name = names.all();
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = detail::stamp_of(age);
      std::copy_n(from, size, values.begin());
      double* next = values.data();
      for (const auto field : fields) {
        made.*field = detail::borrowed(next, at(joints));
        next += joints;
      }
      return &made;
    }

  private:
    detail::joint_names<First> names;
    std::array<double, cca::detail::array_size(size)> values{};
    std::string frame;  // joints have none
    message made;
  };

  // Null, or why it is refused.
  static const char* read(const message& m, double* to) {
    for (const auto& all : {m.position, m.velocity, m.effort})
      if (all.length != 0 && all.length != m.name.length) return "a field of another length than the names";
    for (const auto field : fields)
      if ((m.*field).length == 0) return "a field is missing";
    std::array<std::size_t, cca::detail::array_size(joints)> places{};
    if (const char* const why = detail::joint_names<First>::find(m.name, places)) return why;
    for (std::size_t f = 0; f < fields.size(); ++f)
      for (std::size_t i = 0; i < at(joints); ++i) to[f * at(joints) + i] = (m.*fields[f]).buffer[places[i]];
    return nullptr;
  }

private:
  static constexpr int joints = First::size;
  static constexpr std::array fields{detail::joint_field<typename First::domain>::values,
                                     detail::joint_field<typename Rest::domain>::values...};
  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

}  // namespace cca::ros2
