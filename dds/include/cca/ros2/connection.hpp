// This process in ROS 2's domain ROS_DOMAIN_ID (0 if that is not set), with one thread that sends and
// receives for all publishers and subscribers. A beat only writes into or reads from their rings.
//
// The thread wakes when a message comes, and every 0.5 ms to look for what beats have left. Its mutex is
// never taken in a beat: only while nodes are loaded or end.
#pragma once

#include <dds/dds.h>
#include <sys/prctl.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/dds/participant.hpp>

namespace cca::ros2::detail {

// A publisher or subscriber, for the thread.
class endpoint {
public:
  virtual ~endpoint() = default;
  virtual void work() = 0;
};

class connection {
public:
  // The same for all that ask, as long as one of them lives.
  static std::shared_ptr<connection> open() {
    static std::mutex one_at_a_time;
    static std::weak_ptr<connection> known;
    const std::lock_guard lock(one_at_a_time);
    auto own = known.lock();
    if (!own) known = own = std::make_shared<connection>(number());
    return own;
  }

  explicit connection(std::uint32_t domain)
      : self(domain, ""), wakes(dds_create_waitset(self.get()), "no waitset") {
    worker = std::thread([this] { run(); });
  }
  ~connection() {
    is_over = true;
    worker.join();
  }
  connection(const connection&) = delete;
  connection& operator=(const connection&) = delete;

  const cca::dds::detail::participant& in() const { return self; }

  void add(endpoint& one) {
    const std::lock_guard lock(busy);
    all.push_back(&one);
  }
  void remove(endpoint& one) {
    const std::lock_guard lock(busy);
    std::erase(all, &one);
  }
  // Messages for this reader wake the thread.
  void listen_to(dds_entity_t reader) {
    const auto arrival = cca::dds::detail::checked(dds_create_readcondition(reader, DDS_ANY_STATE),
                                                   "no condition");  // it ends with its reader
    cca::dds::detail::checked(dds_waitset_attach(wakes.get(), arrival, 0), "no waitset");
  }

private:
  static std::uint32_t number() {
    const char* const given = std::getenv("ROS_DOMAIN_ID");
    const std::string_view text = given ? given : "";
    std::uint32_t n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (!text.empty() && (error != std::errc() || end != text.data() + text.size()))
      throw refused("cca::ros2: ROS_DOMAIN_ID is `" + std::string(text) + "`: it must be a number, 0 to 230");
    return n;
  }
  void run() {
    ::prctl(PR_SET_TIMERSLACK, 1UL);
    while (!is_over) {
      dds_attach_t some[8];
      dds_waitset_wait(wakes.get(), some, 8, DDS_USECS(500));
      const std::lock_guard lock(busy);
      for (endpoint* const one : all) one->work();
    }
  }

  cca::dds::detail::participant self;
  cca::dds::detail::entity wakes;
  std::mutex busy;
  std::vector<endpoint*> all;
  std::atomic<bool> is_over{false};
  std::thread worker;
};

// A node's own endpoint. A copied controller is a snapshot: its copy of the node is not connected, neither
// sends nor receives; and a controller to which a snapshot is assigned keeps its connections.
template <class Endpoint>
class connected {
public:
  connected() = default;
  connected(const connected&) {}
  connected(connected&&) = default;
  connected& operator=(const connected&) { return *this; }
  connected& operator=(connected&&) = default;
  ~connected() = default;

  void open(std::string_view topic) {
    if (!own) own = std::make_unique<Endpoint>(connection::open(), topic);
  }
  explicit operator bool() const { return own != nullptr; }
  Endpoint* operator->() const { return own.get(); }

private:
  std::unique_ptr<Endpoint> own;
};

}  // namespace cca::ros2::detail
