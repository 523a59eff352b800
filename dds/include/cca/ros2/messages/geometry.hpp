// geometry_msgs/Vector3, Point, Quaternion, Pose, Transform, Wrench and Twist, as structs and as data.
#pragma once

#include <array>
#include <cstddef>

#include <cca/dds/nodes/space_guard.hpp>
#include <cca/ros2/address.hpp>

namespace cca::ros2::detail {

struct vector_3 {
  double x = 0, y = 0, z = 0;

  void set(const double* from) { x = from[0], y = from[1], z = from[2]; }
  void get(double* to) const { to[0] = x, to[1] = y, to[2] = z; }
};
inline constexpr std::array vector_3_fields{
    message_field{"x", kind::float64, offsetof(vector_3, x)},
    message_field{"y", kind::float64, offsetof(vector_3, y)},
    message_field{"z", kind::float64, offsetof(vector_3, z)},
};
inline constexpr message_type vector_3_type{"geometry_msgs/msg/Vector3", vector_3_fields, sizeof(vector_3),
                                            alignof(vector_3)};

inline constexpr message_type point_type{"geometry_msgs/msg/Point", vector_3_fields, sizeof(vector_3),
                                         alignof(vector_3)};

struct quaternion {
  double x = 0, y = 0, z = 0, w = 1;

  void set(const double* from) { x = from[0], y = from[1], z = from[2], w = from[3]; }
  // Null, or why it is refused.
  const char* get(double* to) const {
    to[0] = x, to[1] = y, to[2] = z, to[3] = w;
    return refuse_quaternion(to);
  }
};
inline constexpr std::array quaternion_fields{
    message_field{"x", kind::float64, offsetof(quaternion, x)},
    message_field{"y", kind::float64, offsetof(quaternion, y)},
    message_field{"z", kind::float64, offsetof(quaternion, z)},
    message_field{"w", kind::float64, offsetof(quaternion, w)},
};
inline constexpr message_type quaternion_type{"geometry_msgs/msg/Quaternion", quaternion_fields,
                                              sizeof(quaternion), alignof(quaternion)};

// Of a Pose and of a Transform: where something is, as cca::pose has it.
struct pose_parts {
  vector_3 position;
  quaternion orientation;

  void set(const double* from) { position.set(from), orientation.set(from + 3); }
  const char* get(double* to) const {
    position.get(to);
    return orientation.get(to + 3);
  }
};
inline constexpr std::array pose_fields{
    message_field{"position", kind::message, offsetof(pose_parts, position), 1, &point_type},
    message_field{"orientation", kind::message, offsetof(pose_parts, orientation), 1, &quaternion_type},
};
inline constexpr message_type pose_type{"geometry_msgs/msg/Pose", pose_fields, sizeof(pose_parts),
                                        alignof(pose_parts)};
inline constexpr std::array transform_fields{
    message_field{"translation", kind::message, offsetof(pose_parts, position), 1, &vector_3_type},
    message_field{"rotation", kind::message, offsetof(pose_parts, orientation), 1, &quaternion_type},
};
inline constexpr message_type transform_type{"geometry_msgs/msg/Transform", transform_fields,
                                             sizeof(pose_parts), alignof(pose_parts)};

struct wrench_parts {
  vector_3 force, torque;
};
inline constexpr std::array wrench_fields{
    message_field{"force", kind::message, offsetof(wrench_parts, force), 1, &vector_3_type},
    message_field{"torque", kind::message, offsetof(wrench_parts, torque), 1, &vector_3_type},
};
inline constexpr message_type wrench_type{"geometry_msgs/msg/Wrench", wrench_fields, sizeof(wrench_parts),
                                          alignof(wrench_parts)};

struct twist_parts {
  vector_3 linear, angular;
};
inline constexpr std::array twist_fields{
    message_field{"linear", kind::message, offsetof(twist_parts, linear), 1, &vector_3_type},
    message_field{"angular", kind::message, offsetof(twist_parts, angular), 1, &vector_3_type},
};
inline constexpr message_type twist_type{"geometry_msgs/msg/Twist", twist_fields, sizeof(twist_parts),
                                         alignof(twist_parts)};

}  // namespace cca::ros2::detail
