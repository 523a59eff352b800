// The topics of a recording beside those of its ports.
#pragma once

#include <string_view>

namespace cca::recording::detail {

inline constexpr std::string_view state_topic = "/cca/state", fault_topic = "/cca/fault",
                                  lost_topic = "/cca/lost", mode_topic = "/cca/mode",
                                  part_topic = "/cca/part", freely_topic = "/cca/free_running",
                                  late_topic = "/cca/late", skipped_topic = "/cca/skipped",
                                  dropped_topic = "/cca/dropped", parameter_topics = "/cca/parameters/",
                                  viewer_topics = "/ros2";

}  // namespace cca::recording::detail
