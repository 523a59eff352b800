// The functions of messages that viewers draw. viewer_message.hpp includes this, unless they are compiled
// once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cca/record/messages/cdr.hpp>
#include <cca/record/messages/viewer_message.hpp>

namespace cca::recording::detail {

CCA_RECORD_INLINE std::vector<std::string_view> frames_of(std::string_view domain) {
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

CCA_RECORD_INLINE viewer_message::viewer_message(const cca::detail::space_info& of) {
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

CCA_RECORD_INLINE std::string viewer_message::schema() const {
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

CCA_RECORD_INLINE std::span<const unsigned char> viewer_message::made_of(const double* sample,
                                                                         std::int64_t origin) {
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

CCA_RECORD_INLINE viewer_message::described viewer_message::description() const {
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

CCA_RECORD_INLINE bool viewer_message::is_point(const cca::detail::space_info& of) {
  for (int i = 0; i < of.axis_count; ++i)
    if (of.labels[i] != "x" && of.labels[i] != "y" && of.labels[i] != "z") return false;
  return of.unit == "m" && of.size == of.axis_count;
}

CCA_RECORD_INLINE void viewer_message::add_joints(cdr_writer& to, const double* sample) const {
  const auto count = static_cast<std::uint32_t>(names.size());
  to.add(count);
  for (const std::string& name : names) to.add(std::string_view(name));
  for (const kind field : {kind::position, kind::velocity, kind::effort}) {
    to.add(field == what ? count : 0u);
    for (std::uint32_t i = 0; field == what && i < count; ++i) to.add(sample[i]);
  }
}

}  // namespace cca::recording::detail
