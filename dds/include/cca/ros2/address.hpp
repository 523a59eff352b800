// Names of ROS 2 in DDS: the topic `joint_states` is `rt/joint_states`, and `sensor_msgs/msg/JointState` is
// `sensor_msgs::msg::dds_::JointState_`. The domain is ROS_DOMAIN_ID, or 0 if that is not set. There are no
// namespaces of nodes here, so `/joint_states` is the same topic, and `~` and `{}` have no meaning.
// Source: https://design.ros2.org/articles/topic_and_service_names.html.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
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

// Whether ROS 2 takes it for a topic: rmw/validate_full_topic_name.h.
constexpr bool names_a_topic(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  constexpr std::size_t longest = 246;  // with the first `/` 247: DDS has 255, and "rt" comes before it
  bool begins_word = true;
  for (const char c : name) {
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    if (c == '/' ? begins_word : !is_letter && (!is_digit || begins_word)) return false;
    begins_word = c == '/';
  }
  return !begins_word && name.size() <= longest;
}

template <fixed_string Topic>
struct no_topic {
  static constexpr void tell(auto& m) {
    m << "cca::ros2: `" << Topic.view()
      << "` is no name of a topic in ROS 2: it has words of letters, digits and `_` that do not begin with a "
         "digit, with one `/` between them, as `arm/command`, and at most 246 letters";
  }
};

template <fixed_string Topic>
address address_of(const message_type& of) {
  static_assert(cca::detail::holds_or_tells<names_a_topic(Topic.view()), no_topic<Topic>>::value);
  std::string_view topic = Topic.view();
  if (topic.starts_with('/')) topic.remove_prefix(1);
  return {domain_of_ros(), "rt/" + std::string(topic), type_name_in_dds(of.name)};
}

}  // namespace cca::ros2::detail
