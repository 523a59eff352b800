// builtin_interfaces/Time and std_msgs/Header, as structs and as data.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include <cca/ros2/address.hpp>

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

// ROS time is the wall clock. A beat has none, so the thread that sends asks for it, and counts the age back.
inline time_stamp stamp_of(std::int64_t age) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const std::int64_t at = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() - age;
  return {static_cast<std::int32_t>(at / 1'000'000'000), static_cast<std::uint32_t>(at % 1'000'000'000)};
}

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
