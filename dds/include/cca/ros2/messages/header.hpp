// builtin_interfaces/Time and std_msgs/Header, as structs and as data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <cca/ros2/message_type.hpp>

namespace cca::ros2::detail {

struct time_stamp {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};
inline constexpr std::array time_fields{
    message_field{"sec", kind::int32, offsetof(time_stamp, sec)},
    message_field{"nanosec", kind::uint32, offsetof(time_stamp, nanosec)},
};
inline constexpr message_type time_type{"builtin_interfaces/msg/Time", time_fields, sizeof(time_stamp),
                                        alignof(time_stamp)};

struct header {
  time_stamp stamp;
  char* frame_id = nullptr;
};
inline constexpr std::array header_fields{
    message_field{"stamp", kind::message, offsetof(header, stamp), 1, &time_type},
    message_field{"frame_id", kind::string, offsetof(header, frame_id)},
};
inline constexpr message_type header_type{"std_msgs/msg/Header", header_fields, sizeof(header),
                                          alignof(header)};

}  // namespace cca::ros2::detail
