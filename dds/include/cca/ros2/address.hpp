// Names of ROS 2 in DDS: the topic `joint_states` is `rt/joint_states`, and `sensor_msgs/msg/JointState` is
// `sensor_msgs::msg::dds_::JointState_`. The domain is ROS_DOMAIN_ID, or 0 if that is not set.
// Source: https://design.ros2.org/articles/topic_and_service_names.html.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include <cca/base/refused.hpp>
#include <cca/dds/nodes/connection.hpp>
#include <cca/dds/nodes/message_type.hpp>

namespace cca::ros2::detail {

using namespace cca::dds::detail;  // messages, topics, connections

inline std::string type_name_in_dds(std::string_view name) {
  std::string all;
  std::string_view last = name;
  for (std::size_t slash; (slash = last.find('/')) != last.npos; last.remove_prefix(slash + 1))
    all += std::string(last.substr(0, slash)) + "::";
  return all + "dds_::" + std::string(last) + "_";
}

inline std::uint32_t domain_of_ros() {
  const char* const given = std::getenv("ROS_DOMAIN_ID");
  const std::string_view text = given ? given : "";
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (!text.empty() && (error != std::errc() || end != text.data() + text.size()))
    throw refused("cca::ros2: ROS_DOMAIN_ID is `" + std::string(text) + "`: it must be a number, 0 to 230");
  return n;
}

inline address address_of(std::string_view topic, const message_type& of) {
  return {domain_of_ros(), "rt/" + std::string(topic), type_name_in_dds(of.name)};
}

}  // namespace cca::ros2::detail
