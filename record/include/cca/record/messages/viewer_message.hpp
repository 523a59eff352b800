// A message of ROS 2 that viewers draw, made of a sample whose space it fits:
//
//   joint_angles, joint_velocities, joint_torques   sensor_msgs/msg/JointState: position, velocity, effort
//   cartesian_position<F> over x, y, z or some      geometry_msgs/msg/PointStamped
//   orientation<F>                                  geometry_msgs/msg/QuaternionStamped
//   pose<F>                                         geometry_msgs/msg/PoseStamped
//   twist<At, F>                                    geometry_msgs/msg/TwistStamped
//   wrench<F, F>                                    geometry_msgs/msg/WrenchStamped
//
// The stamp is the sample's time of origin, frame_id is F, and the names of the joints are those of the axes.
// A wrench acts at the origin of frame_id, so one that is about another point fits none.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/messages/cdr.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

// The arguments of "wrench<foot, leg<2, a>>": "foot" and "leg<2, a>".
std::vector<std::string_view> frames_of(std::string_view domain);

class viewer_message {
public:
  explicit viewer_message(const cca::detail::space_info& of);

  bool fits() const { return what != kind::none; }
  std::string_view type() const { return description().type; }
  // With the types that it contains, as MCAP's `ros2msg` has it.
  std::string schema() const;

  // Until the next call.
  std::span<const unsigned char> made_of(const double* sample, std::int64_t origin);

private:
  enum class kind { none, position, velocity, effort, point, quaternion, pose, twist, wrench };
  struct part {
    std::string_view name, fields;
  };
  struct described {
    std::string_view type, fields;
  };
  static constexpr std::string_view vector = "float64 x\nfloat64 y\nfloat64 z\n";
  static constexpr part parts[] = {
      {"geometry_msgs/Point", vector},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"geometry_msgs/Vector3", vector},
      {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/Wrench", "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n"},
  };

  described description() const;

  static bool is_point(const cca::detail::space_info& of);

  void add_joints(cdr_writer& to, const double* sample) const;

  kind what = kind::none;
  std::string frame;
  std::vector<std::string> names;
  std::vector<unsigned char> memory;
};

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/messages/viewer_message_functions.hpp>
#endif
