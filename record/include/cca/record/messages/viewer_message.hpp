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

#include <cca/record/mcap/bytes.hpp>
#include <cca/record/messages/cdr.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

// The arguments of "wrench<foot, leg<2, a>>": "foot" and "leg<2, a>".
inline std::vector<std::string_view> frames_of(std::string_view domain) {
  std::vector<std::string_view> all;
  const auto open = domain.find('<');
  if (open == domain.npos) return all;
  domain = domain.substr(open + 1, domain.size() - open - 2);
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= domain.size(); ++i) {
    const char c = i < domain.size() ? domain[i] : ',';
    if (c == '<') ++depth;
    if (c == '>') --depth;
    if (c != ',' || depth > 0) continue;
    all.push_back(domain.substr(start, i - start));
    start = domain.find_first_not_of(' ', i + 1);
    if (start == domain.npos) break;
  }
  return all;
}

class viewer_message {
public:
  explicit viewer_message(const cca::detail::space_info& of) {
    const std::string_view domain = of.domain.substr(0, of.domain.find('<'));
    const auto frames = frames_of(of.domain);
    const auto is = [&](std::string_view name, std::string_view unit) {
      return domain == name && of.unit == unit && of.size == of.axis_count && frames.empty();
    };
    if (is("joint_angles", "rad")) what = kind::position;
    else if (is("joint_velocities", "rad/s")) what = kind::velocity;
    else if (is("joint_torques", "N m")) what = kind::effort;
    else if (domain == "cartesian_position" && is_point(of)) what = kind::point;
    else if (of.coordinates && domain == "orientation" && of.size == 4) what = kind::quaternion;
    else if (of.coordinates && domain == "pose" && of.size == 7) what = kind::pose;
    else if (of.coordinates && domain == "twist" && of.size == 6 && frames.size() == 2) what = kind::twist;
    else if (of.coordinates && domain == "wrench" && of.size == 6 && frames.size() == 2 &&
             frames[0] == frames[1])
      what = kind::wrench;
    if (!frames.empty()) frame = frames.back();
    for (int i = 0; i < of.axis_count; ++i) names.emplace_back(of.labels[i]);
    memory.resize(256 + frame.size() + 16 * names.size());
    for (const std::string& name : names) memory.resize(memory.size() + name.size() + 16);
  }

  bool fits() const { return what != kind::none; }
  std::string_view type() const { return description().type; }
  // With the types that it contains, as MCAP's `ros2msg` has it.
  std::string schema() const {
    static constexpr std::string_view time = "builtin_interfaces/Time", head = "std_msgs/Header";
    std::string all = "std_msgs/Header header\n" + std::string(description().fields);
    const auto add = [&](std::string_view name, std::string_view fields) {
      all.append(80, '=').append("\nMSG: ").append(name).append("\n").append(fields);
    };
    add(head, "builtin_interfaces/Time stamp\nstring frame_id\n");
    add(time, "int32 sec\nuint32 nanosec\n");
    for (const part& p : parts)
      if (description().fields.find(p.name) != std::string_view::npos) add(p.name, p.fields);
    if (what == kind::pose)
      for (const part& p : {parts[0], parts[1]}) add(p.name, p.fields);
    if (what == kind::twist || what == kind::wrench) add(parts[2].name, parts[2].fields);
    return all;
  }

  // Until the next call.
  std::span<const unsigned char> made_of(const double* sample, std::int64_t origin) {
    cdr_writer to(memory);
    const std::int64_t stamp = origin < 0 ? 0 : origin;
    to.add(static_cast<std::int32_t>(stamp / 1'000'000'000));
    to.add(static_cast<std::uint32_t>(stamp % 1'000'000'000)).add(std::string_view(frame));
    const auto add = [&](int from, int count) {
      for (int i = 0; i < count; ++i) to.add(sample[from + i]);
    };
    switch (what) {
      case kind::none:
        break;
      case kind::position:
      case kind::velocity:
      case kind::effort:
        add_joints(to, sample);
        break;
      case kind::point:
        for (const std::string_view axis : {"x", "y", "z"}) {
          double at = 0;
          for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == axis) at = sample[i];
          to.add(at);
        }
        break;
      case kind::quaternion:
        add(0, 4);
        break;
      case kind::pose:
        add(0, 7);
        break;
      case kind::twist:
      case kind::wrench:
        add(3, 3), add(0, 3);
        break;  // ROS 2 has the linear part first
    }
    return to.view();
  }

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

  described description() const {
    switch (what) {
      case kind::none:
        break;
      case kind::position:
      case kind::velocity:
      case kind::effort:
        return {"sensor_msgs/msg/JointState",
                "string[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"};
      case kind::point:
        return {"geometry_msgs/msg/PointStamped", "geometry_msgs/Point point\n"};
      case kind::quaternion:
        return {"geometry_msgs/msg/QuaternionStamped", "geometry_msgs/Quaternion quaternion\n"};
      case kind::pose:
        return {"geometry_msgs/msg/PoseStamped", "geometry_msgs/Pose pose\n"};
      case kind::twist:
        return {"geometry_msgs/msg/TwistStamped", "geometry_msgs/Twist twist\n"};
      case kind::wrench:
        return {"geometry_msgs/msg/WrenchStamped", "geometry_msgs/Wrench wrench\n"};
    }
    return {};
  }

  static bool is_point(const cca::detail::space_info& of) {
    for (int i = 0; i < of.axis_count; ++i)
      if (of.labels[i] != "x" && of.labels[i] != "y" && of.labels[i] != "z") return false;
    return of.unit == "m" && of.size == of.axis_count;
  }

  void add_joints(cdr_writer& to, const double* sample) const {
    const auto count = static_cast<std::uint32_t>(names.size());
    to.add(count);
    for (const std::string& name : names) to.add(std::string_view(name));
    for (const kind field : {kind::position, kind::velocity, kind::effort}) {
      to.add(field == what ? count : 0u);
      for (std::uint32_t i = 0; field == what && i < count; ++i) to.add(sample[i]);
    }
  }

  kind what = kind::none;
  std::string frame;
  std::vector<std::string> names;
  std::vector<unsigned char> memory;
};

}  // namespace cca::recording::detail
