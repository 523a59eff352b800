// Publishers of samples, of any space, for programs that share no code with cca.
//
//   cca::node<"tell", cca::dds::publisher<leg_angles>>                   topic "leg_angles"
//   cca::node<"tell", cca::dds::publisher<leg_angles, "left/angles">>    another one
//   cca::node<"arm", cca::dds::command_publisher<arm_angles, "arm/command">>
//
//   in   "sample"   Space
//
// Both are resource nodes. A `publisher` tells what others watch; a `command_publisher` is for what a robot
// behind DDS obeys, so no command of joints reaches it without a limiter (robot.unlimited_command).
//
// They send each fresh sample; with `timed<10>` what is fresh in every tenth beat. With a sample goes its
// age, never a time: clocks of two machines are not compared. Third argument: `default_qos`, `sensor_data` or
// `transient_local`. Parameter "domain", 0 to 230. `cca::idl<leg_angles>()` is the type for the other
// program.
//
// Errors: `cca::refused` from `load()`, if DDS can't be opened. `sent()`, `dropped()`: a sample is dropped if
// 64 wait already (of more than 4096 numbers: 8), or a reliable reader does not keep up. Any thread may ask
// for both, after `load()`. A copy of a controller sends nothing. Cost of a beat: the numbers are written
// into a ring; a thread sends them. Example: tests/runtime/dds_nodes/nodes.cpp. Page: docs/dds.md.
#pragma once

#include <cstdint>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/type_name.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/field_types.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/dds/idl.hpp>
#include <cca/dds/nodes/publishing.hpp>
#include <cca/dds/space_message.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::dds {

namespace detail {

using domain_number = bounded<int, 0, 230>;

template <class Space, fixed_string Topic>
address address_of_space(int domain) {
  const std::string topic = Topic.view().empty() ? topic_of_space<Space>() : std::string(Topic.view());
  return {static_cast<std::uint32_t>(domain), topic, type_in_dds<Space>()};
}

template <class Space, fixed_string Topic, class Quality>
class publisher_of_space : public publishes<space_message<Space>, Quality> {
public:
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (domain_number, domain));
  };
  parameters p{};

  void act(const in<"sample", Space>& told, beat now) {
    if (told.fresh()) this->publish(now, told);
  }
  void on_load() { this->open(address_of_space<Space, Topic>(p.domain)); }
};

template <class Space, fixed_string Topic, class Quality>
struct kept_command {
  static constexpr void tell(auto& m) {
    m << "cca::dds::command_publisher: `" << cca::detail::type_name<Quality>()
      << "` keeps the last command of " << cca::detail::space_in_words<Space>();
    if (!Topic.view().empty()) m << " on the topic `" << Topic.view() << "`";
    m << ", and a robot that comes later would obey an old one: take `default_qos`";
  }
};

}  // namespace detail

template <class Space, fixed_string Topic = "", class Quality = default_qos>
struct publisher : detail::publisher_of_space<Space, Topic, Quality> {
  static constexpr bool moves_nothing = true;
};

template <class Space, fixed_string Topic = "", class Quality = default_qos>
struct command_publisher : detail::publisher_of_space<Space, Topic, Quality> {
  static_assert(cca::detail::holds_or_tells<!detail::is_kept<Quality>,
                                            detail::kept_command<Space, Topic, Quality>>::value);
};

}  // namespace cca::dds
