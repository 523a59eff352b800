// A subscriber: a resource node that publishes in the graph what comes from a ROS 2 system.
//
//   cca::node<"command", cca::ros2::subscriber<"leg_command", cca::ros2::joint_state<leg_angles>>>
//
//   out  a port for each space of the message, with the name of the message's field: "position", ... (maybe)
//
// In each beat it publishes the newest message that has come since its last firing, if there is one. Its
// origin is the beat: the stamps of other machines are not compared with anything here. Put a watchdog
// after a command, and a limiter before an actuator.
//
// A message is checked before it is used: length, names, frame, fields, finite numbers (each header in
// ros2/messages says what it refuses). One that is refused changes nothing and is counted: `refused()`,
// `why_refused()` the last reason, `received()`. A message that no beat takes for 0.1 s is dropped,
// `too_late()`. Any thread may ask for all of these, after `load()`.
//
// Third argument: `default_qos`, `sensor_data` or `transient_local`. Domain: the variable ROS_DOMAIN_ID, else
// 0. Errors: `cca::refused` from `load()`, if DDS can't be opened. A copy of a controller receives nothing.
// Cost of a beat: numbers are read from a ring; a thread receives and checks. Example: examples/ros2/leg.cpp.
// Page: docs/ros2.md.
#pragma once

#include <cstdint>
#include <tuple>

#include <cca/component/port.hpp>
#include <cca/dds/nodes/subscribing.hpp>
#include <cca/ros2/address.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/ros2/quality.hpp>

namespace cca::ros2 {

namespace detail {

template <fixed_string Topic, class Message, class Quality, class Ports>
class subscriber_of;
template <fixed_string Topic, class Message, class Quality, class... Ports>
class subscriber_of<Topic, Message, Quality, port_list<Ports...>> : public subscribes<Message, Quality> {
public:
  auto sense() -> std::tuple<maybe<Ports::name, typename Ports::space>...> {
    std::tuple<maybe<Ports::name, typename Ports::space>...> found;
    typename subscriber_of::vector_type all;
    std::int64_t age = 0;
    if (!this->take(all, age)) return found;
    std::apply(
        [&](auto&... one) {
          int next = 0;
          ((one.vector() = all.template segment<Ports::space::size>(next), next += Ports::space::size), ...);
        },
        found);
    return found;
  }
  void on_load() { this->open(address_of<Topic>(Message::type)); }
};

}  // namespace detail

template <fixed_string Topic, class Message, class Quality = default_qos>
struct subscriber : detail::subscriber_of<Topic, Message, Quality, typename Message::ports> {};

}  // namespace cca::ros2
