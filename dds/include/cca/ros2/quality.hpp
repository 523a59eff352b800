// Quality of service, with the names and values of ROS 2's profiles: `default_qos`, `sensor_data`,
// `transient_local`.
#pragma once

#include <cca/dds/nodes/quality.hpp>

namespace cca::ros2 {

using dds::default_qos;
using dds::sensor_data;
using dds::transient_local;

}  // namespace cca::ros2
