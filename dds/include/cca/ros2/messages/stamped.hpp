// geometry_msgs/WrenchStamped and TwistStamped, of a space over x, y, z.
//
//   wrench_stamped<foot_wrench>   cca::wrench<Frame, Frame>   port "wrench"
//   twist_stamped<trunk_twist>    cca::twist<At, In>          port "twist"
//
// frame_id is the frame along whose axes the numbers are. ROS 2 takes the torque of a wrench about the origin
// of this frame, so a wrench must act there. Refused: a message with another frame_id.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/ros2/messages/geometry.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/twist_wrench.hpp>

namespace cca::ros2 {

namespace detail {

struct wrench_message {
  header head;
  wrench_parts wrench;

  // Ours have the angular part first.
  vector_3& first() { return wrench.torque; }
  vector_3& second() { return wrench.force; }
};
inline constexpr std::array wrench_message_fields{
    message_field{"header", kind::message, offsetof(wrench_message, head), 1, &header_type},
    message_field{"wrench", kind::message, offsetof(wrench_message, wrench), 1, &wrench_type},
};

struct twist_message {
  header head;
  twist_parts twist;

  vector_3& first() { return twist.angular; }
  vector_3& second() { return twist.linear; }
};
inline constexpr std::array twist_message_fields{
    message_field{"header", kind::message, offsetof(twist_message, head), 1, &header_type},
    message_field{"twist", kind::message, offsetof(twist_message, twist), 1, &twist_type},
};

template <class Space, class Message>
struct stamped {
  using message = Message;
  static constexpr int size = 6;

  class maker {
  public:
    maker() { made.head.frame_id = frame.data(); }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = stamp_of(age);
      made.first().set(from);
      made.second().set(from + 3);
      return &made;
    }

  private:
    std::string frame = frame_name<along>();
    message made;
  };

  static const char* read(message m, double* to) {
    static const std::string wanted = frame_name<along>();
    if (!is_frame(m.head.frame_id, wanted)) return "another frame_id";
    m.first().get(to);
    m.second().get(to + 3);
    return nullptr;
  }

private:
  using along = typename frame_along<typename Space::domain>::type;
};

template <class Domain>
constexpr bool is_wrench_here = false;
template <class Frame>
constexpr bool is_wrench_here<wrench<Frame, Frame>> = true;

struct wrench_words {
  static constexpr std::string_view name = "wrench_stamped";
  static constexpr std::string_view holds =
      "a space of cca::wrench<Frame, Frame>, a load about the origin of the frame along whose axes its "
      "numbers are: `moved_to` and `express` bring one there";
};
struct stamped_twist_words {
  static constexpr std::string_view name = "twist_stamped", holds = "a space of cca::twist<At, In>";
};

}  // namespace detail

template <class Space>
struct wrench_stamped : detail::stamped<Space, detail::wrench_message> {
  static_assert(cca::detail::holds_or_tells<detail::is_wrench_here<typename Space::domain>,
                                            detail::other_space<detail::wrench_words, Space>>::value);
  using ports = detail::port_list<detail::message_port<"wrench", Space>>;
  static constexpr detail::message_type type{
      "geometry_msgs/msg/WrenchStamped", detail::wrench_message_fields, sizeof(detail::wrench_message),
      alignof(detail::wrench_message),
      "RIHS01_8dc3deaf06b2ab281f9f9a742a8961c328ca7cec16e3fd6586d3a5c83fa78f77"};
};

template <class Space>
struct twist_stamped : detail::stamped<Space, detail::twist_message> {
  static_assert(cca::detail::holds_or_tells<cca::detail::is_twist<typename Space::domain>,
                                            detail::other_space<detail::stamped_twist_words, Space>>::value);
  using ports = detail::port_list<detail::message_port<"twist", Space>>;
  static constexpr detail::message_type type{
      "geometry_msgs/msg/TwistStamped", detail::twist_message_fields, sizeof(detail::twist_message),
      alignof(detail::twist_message),
      "RIHS01_5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64"};
};

}  // namespace cca::ros2
