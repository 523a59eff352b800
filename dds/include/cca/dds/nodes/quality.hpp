// Quality of service of the nodes that talk to other programs, with the names and values of ROS 2's profiles.
// A topic needs one that fits on both sides: a reliable subscriber hears nothing from a best-effort
// publisher.
//
//   default_qos   reliable, volatile, the last 10     what most nodes of ROS 2 use, and commands here
//   sensor_data   best effort, volatile, the last 5   rmw_qos_profile_sensor_data: nothing is sent again
//   transient_local   reliable, kept for those that come later   what never ages: "tf_static", a map
//
// Of `transient_local` a publisher keeps its last message. A subscriber hears it whenever it comes, and it
// does not age while no beat takes it; from a publisher that keeps nothing it hears nothing. So it is for
// what does not age at all, and no command may have it.
//
// A message may be one of many on its topic, as on "tf": it states how many are kept at least, `least_depth`.
//
// Source: rmw/qos_profiles.h, tf2_ros/qos.hpp.
#pragma once

#include <dds/dds.h>

#include <algorithm>
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
struct transient_local {
  static constexpr bool is_reliable = true, is_kept = true;
  static constexpr std::int32_t depth = 1;
};

namespace detail {

using qos = std::unique_ptr<dds_qos_t, void (*)(dds_qos_t*)>;

// What comes late is as good as new.
template <class Quality>
inline constexpr bool is_kept = [] {
  if constexpr (requires { Quality::is_kept; }) return Quality::is_kept;
  else return false;
}();
template <class Message>
inline constexpr std::int32_t least_depth = [] {
  if constexpr (requires { Message::least_depth; }) return Message::least_depth;
  else return 0;
}();

struct terms {
  bool is_reliable, is_kept;
  std::int32_t depth;
};
template <class Message, class Quality>
inline constexpr terms terms_of_reader{Quality::is_reliable, is_kept<Quality>,
                                       std::max(Quality::depth, least_depth<Message>)};
template <class Message, class Quality>
inline constexpr terms terms_of_writer =
    is_kept<Quality> ? terms{Quality::is_reliable, true, Quality::depth} : terms_of_reader<Message, Quality>;

// `hash`: of a type of ROS 2, which looks for it in the user data from Iron on. Empty: another type.
inline qos qos_of(const terms& of, std::string_view hash) {
  qos q(dds_create_qos(), &dds_delete_qos);
  dds_qset_reliability(q.get(), of.is_reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(1));
  dds_qset_durability(q.get(), of.is_kept ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(q.get(), DDS_HISTORY_KEEP_LAST, of.depth);
  const dds_data_representation_id_t plain[] = {DDS_DATA_REPRESENTATION_XCDR1};
  dds_qset_data_representation(q.get(), 1, plain);
  if (hash.empty()) return q;
  const std::string text = "typehash=" + std::string(hash) + ";";
  dds_qset_userdata(q.get(), text.data(), text.size());
  return q;
}

}  // namespace detail
}  // namespace cca::dds
