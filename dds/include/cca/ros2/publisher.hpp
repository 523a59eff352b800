// Publishers: nodes that tell a ROS 2 system what is in the graph.
//
//   cca::node<"states", cca::ros2::publisher<"joint_states", cca::ros2::joint_state<leg_angles>>>
//   cca::node<"arm", cca::ros2::command_publisher<"arm/command", cca::ros2::joint_state<arm_angles>>>
//
//   in   a port for each space of the message, with the name of the message's field: "position", ...
//
// A `publisher` is a component like others, for what others watch. A `command_publisher` is a resource node
// (its inputs are of `act`), for what a robot obeys: no joint command reaches it without a limiter
// (robot.unlimited_command).
//
// They send a message each time they fire, once all inputs have a sample. The header's stamp is the wall
// clock when it is sent, minus the age of the oldest input; it is true to about a millisecond, in a
// wall-clock run. Third argument: `default_qos`, `sensor_data` or `transient_local`. Domain: the variable
// ROS_DOMAIN_ID, else 0.
//
// Errors: `cca::refused` from `load()`, if DDS can't be opened. `sent()`, `dropped()`: a message is dropped
// if 64 wait already, or a reliable subscriber does not keep up. Any thread may ask for both, after `load()`.
// A copy of a controller sends nothing. Cost of a beat: the numbers are written into a ring; a thread makes
// the message. Example: examples/ros2/leg.cpp. Page: docs/ros2.md.
#pragma once

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/type_name.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/dds/nodes/publishing.hpp>
#include <cca/ros2/address.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/ros2/quality.hpp>

namespace cca::ros2 {

namespace detail {

template <fixed_string Topic, class Message, class Quality, class Ports>
class publisher_of;
template <fixed_string Topic, class Message, class Quality, class... Ports>
class publisher_of<Topic, Message, Quality, port_list<Ports...>> : public publishes<Message, Quality> {
public:
  void process(const in<Ports::name, typename Ports::space>&... inputs, beat now) {
    this->publish(now, inputs...);
  }
  void on_load() { this->open(address_of<Topic>(Message::type)); }
};

template <fixed_string Topic, class Message, class Quality, class Ports>
class command_publisher_of;
template <fixed_string Topic, class Message, class Quality, class... Ports>
class command_publisher_of<Topic, Message, Quality, port_list<Ports...>>
    : public publishes<Message, Quality> {
public:
  void act(const in<Ports::name, typename Ports::space>&... inputs, beat now) {
    if ((inputs.fresh() || ...)) this->publish(now, inputs...);
  }
  void on_load() { this->open(address_of<Topic>(Message::type)); }
};

template <fixed_string Topic, class Quality>
struct kept_command {
  static constexpr void tell(auto& m) {
    m << "cca::ros2::command_publisher: `" << cca::detail::type_name<Quality>()
      << "` keeps the last command on the topic `" << Topic.view()
      << "`, and a robot that comes later would obey an old one: take `default_qos`";
  }
};

}  // namespace detail

template <fixed_string Topic, class Message, class Quality = default_qos>
struct publisher : detail::publisher_of<Topic, Message, Quality, typename Message::ports> {};

template <fixed_string Topic, class Message, class Quality = default_qos>
struct command_publisher : detail::command_publisher_of<Topic, Message, Quality, typename Message::ports> {
  static_assert(
      cca::detail::holds_or_tells<!detail::is_kept<Quality>, detail::kept_command<Topic, Quality>>::value);
};

}  // namespace cca::ros2
