// A program of tests/ros2_peers, as a child process.
#pragma once

#include <string>

#include "../../laws/peer_process.hpp"
#include "spaces.hpp"

namespace ros2_test {

class peer : public peer_process {
public:
  peer(const char* program, const std::string& what, const std::string& type, const std::string& topic)
      : peer_process({program, what, domain(), type, topic}) {}
};

inline constexpr const char* idlc_peer = CCA_IDLC_PEER;
inline constexpr const char* fast_dds_peer = CCA_FAST_DDS_PEER;

}  // namespace ros2_test
