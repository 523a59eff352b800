// geometry_msgs/Twist, without a header, of a space over x, y, z: the message of "cmd_vel".
//
//   twist<base_twist>   cca::twist<At, In>   port "twist"
//
// Nothing in it says of which frame it is. By custom a twist of "cmd_vel" is that of the robot's base, along
// the axes of the base. Nothing is refused but numbers that are not finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <cca/ros2/messages/geometry.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/twist_wrench.hpp>

namespace cca::ros2 {

namespace detail {

struct twist_words {
  static constexpr std::string_view name = "twist", holds = "a space of cca::twist<At, In>";
};

}  // namespace detail

template <class Space>
struct twist {
  static_assert(cca::detail::holds_or_tells<cca::detail::is_twist<typename Space::domain>,
                                            detail::other_space<detail::twist_words, Space>>::value);
  using ports = detail::port_list<detail::message_port<"twist", Space>>;
  using message = detail::twist_parts;
  static constexpr int size = 6;
  static constexpr detail::message_type type{
      "geometry_msgs/msg/Twist", detail::twist_fields, sizeof(message), alignof(message),
      "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a"};

  class maker {
  public:
    const message* make(const double* from, std::int64_t) {  // this message has no stamp
      made.angular.set(from);
      made.linear.set(from + 3);
      return &made;
    }

  private:
    message made;
  };

  static const char* read(const message& m, double* to) {
    m.angular.get(to);
    m.linear.get(to + 3);
    return nullptr;
  }
};

}  // namespace cca::ros2
