// What the tests of this folder share.
#pragma once

#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include <cca/cca.hpp>
#include <cca/dds/idl.hpp>
#include <cca/dds/publisher.hpp>
#include <cca/dds/subscriber.hpp>

#include "../../idl_peers/spaces.hpp"
#include "../../laws/peer_process.hpp"

namespace talk {

// A domain that no other test of this machine is likely to use now. Its ports are below those that the kernel
// gives to others.
inline int domain() {
  static const int number = 1 + ::getpid() % 98;
  return number;
}

// Calls f each millisecond until it is true. False: it never was.
template <class F>
bool within_seconds(int seconds, F f) {
  for (int i = 0; i < 1000 * seconds; ++i) {
    if (f()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

// As the peer of tests/idl_peers sends it: 1, 1.5, 2, ...; a quaternion is 0, 0, 0.6, 0.8.
template <class Space>
auto told() {
  typename Space::vector_type all;
  constexpr double turned[] = {0, 0, 0.6, 0.8};
  constexpr bool has_poses = std::is_same_v<Space, trunk_pose> || std::is_same_v<Space, paws>;
  for (int i = 0; i < Space::size; ++i)
    if (has_poses && i % 7 >= 3) all[i] = turned[i % 7 - 3];
    else all[i] = std::is_same_v<Space, picture> ? i % 256 : 1 + 0.5 * i;
  return all;
}

template <class Space>
struct speaker {
  auto process() -> cca::out<"value", Space> { return told<Space>(); }
};
template <class Space>
struct recorder {
  void process(const cca::in<"value", Space>& heard, cca::beat now) {
    ++count;
    last = heard.vector();
    age = now.time() - heard.origin();
  }
  int count = 0;
  std::int64_t age = 0;
  typename Space::vector_type last = Space::vector_type::Zero();
};

template <class Space>
struct talker : cca::graph<cca::rate<1000>,
                           cca::node<"speaker", speaker<Space>>,
                           cca::node<"tell", cca::dds::publisher<Space, "cca/said">>,
                           cca::wire<"speaker.value", "tell.sample">> {};
template <class Space>
struct listener : cca::graph<cca::rate<1000>,
                             cca::node<"heard", cca::dds::subscriber<Space, "cca/said">>,
                             cca::node<"here", recorder<Space>>,
                             cca::wire<"heard.sample", "here.value">> {};

inline peer_process peer(const std::string& what, const std::string& type, const std::string& how = "fit") {
  return peer_process({CCA_SPACE_PEER, what, std::to_string(domain()), "cca/said", type, how});
}

}  // namespace talk
