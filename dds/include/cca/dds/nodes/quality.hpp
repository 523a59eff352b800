// Quality of service of the nodes that talk to other programs, with the names and values of ROS 2's profiles.
// A topic needs one that fits on both sides: a reliable subscriber hears nothing from a best-effort
// publisher.
//
//   default_qos   reliable, volatile, the last 10     what most nodes of ROS 2 use, and commands here
//   sensor_data   best effort, volatile, the last 5   rmw_qos_profile_sensor_data: nothing is sent again
//
// Source: rmw/qos_profiles.h.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace cca::dds {

struct default_qos {
  static constexpr bool is_reliable = true;
  static constexpr std::int32_t depth = 10;
};
struct sensor_data {
  static constexpr bool is_reliable = false;
  static constexpr std::int32_t depth = 5;
};

namespace detail {

using qos = std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)>;

// `hash`: of a type of ROS 2, which looks for it in the user data from Iron on. Empty: another type.
inline qos qos_of(bool is_reliable, std::int32_t depth, std::string_view hash) {
  qos q(dds_create_qos(), &dds_delete_qos);
  dds_qset_reliability(q.get(), is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(1));
  dds_qset_durability(q.get(), DDS_DURABILITY_VOLATILE);
  dds_qset_history(q.get(), DDS_HISTORY_KEEP_LAST, depth);
  const dds_data_representation_id_t plain[] = {DDS_DATA_REPRESENTATION_XCDR1};
  dds_qset_data_representation(q.get(), 1, plain);
  if (hash.empty()) return q;
  const std::string text = "typehash=" + std::string(hash) + ";";
  dds_qset_userdata(q.get(), text.data(), text.size());
  return q;
}

}  // namespace detail
}  // namespace cca::dds
