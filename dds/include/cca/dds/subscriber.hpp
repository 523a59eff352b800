// A subscriber: a resource node that publishes in the graph what another program sends, of any space.
//
//   cca::node<"camera", cca::dds::subscriber<ball_in_trunk>>             topic "ball_in_trunk"
//   cca::node<"camera", cca::dds::subscriber<ball_in_trunk, "ball">>     another one
//
//   out  "sample"   Space, maybe: the newest that has come since the last firing
//
// What comes is treated as a sensor's. Its origin is the beat, minus the age that the sender states; so a
// watchdog after it sees how old the data is. It is checked: space, length, age, finite numbers, unit
// quaternions, whole numbers of a status. What is refused changes nothing and is counted: `refused()`,
// `why_refused()` the last reason, `received()`. A sample that no beat takes for 0.1 s is dropped,
// `too_late()`. Any thread may ask for all of these, after `load()`. Put a limiter before an actuator: that a
// command came from outside does not make it safe.
//
// Third argument: `default_qos`, `sensor_data` or `transient_local`. Parameter "domain", 0 to 230.
// `cca::idl<ball_in_trunk>()` is the type for the other program. Errors: `cca::refused` from `load()`, if DDS
// can't be opened. A copy of a controller receives nothing. Cost of a beat: numbers are read from a ring; a
// thread receives and checks. Example: tests/runtime/dds_nodes/nodes.cpp. Page: docs/dds.md.
#pragma once

#include <cstdint>

#include <cca/dds/nodes/subscribing.hpp>
#include <cca/dds/publisher.hpp>

namespace cca::dds {

template <class Space, fixed_string Topic = "", class Quality = default_qos>
class subscriber : public detail::subscribes<detail::space_message<Space>, Quality> {
public:
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (detail::domain_number, domain));
  };
  parameters p{};

  auto sense(beat now) -> maybe<"sample", Space> {
    typename subscriber::vector_type values;
    std::int64_t age = 0;
    if (!this->take(values, age)) return {};
    return maybe<"sample", Space>(values).with_origin(now.time() - age);
  }
  void on_load() { this->open(detail::address_of_space<Space, Topic>(p.domain)); }
};

}  // namespace cca::dds
