// Quality of service, with the names and values of ROS 2's profiles: `default_qos`, `sensor_data`.
#pragma once

#include <cca/dds/nodes/quality.hpp>

namespace cca::ros2 {

using dds::default_qos;
using dds::sensor_data;

}  // namespace cca::ros2
