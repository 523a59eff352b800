// This process in a domain, with one thread that sends and receives for all its publishers and subscribers
// there. A beat only writes into or reads from their rings.
//
// The thread wakes when a message comes, and every 0.5 ms to look for what beats have left. Its mutex is
// never taken in a beat: only while nodes are loaded or end.
#pragma once

#include <dds/dds.h>
#include <sys/prctl.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <cca/dds/domain/participant.hpp>

namespace cca::dds::detail {

// A publisher or subscriber, for the thread.
class endpoint {
public:
  virtual ~endpoint() = default;
  virtual void work() = 0;
};

class connection {
public:
  // The same for all that ask for this domain, as long as one of them lives.
  static std::shared_ptr<connection> open(std::uint32_t domain) {
    static std::mutex one_at_a_time;
    static std::map<std::uint32_t, std::weak_ptr<connection>> known;
    const std::lock_guard lock(one_at_a_time);
    auto own = known[domain].lock();
    if (!own) known[domain] = own = std::make_shared<connection>(domain);
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

  const participant& in() const { return self; }

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
    const auto arrival = checked(dds_create_readcondition(reader, DDS_ANY_STATE),
                                 "no condition");  // it ends with its reader
    checked(dds_waitset_attach(wakes.get(), arrival, 0), "no waitset");
  }

private:
  void run() {
    ::prctl(PR_SET_TIMERSLACK, 1UL);
    while (!is_over) {
      dds_attach_t some[8];
      dds_waitset_wait(wakes.get(), some, 8, DDS_USECS(500));
      const std::lock_guard lock(busy);
      for (endpoint* const one : all) one->work();
    }
  }

  participant self;
  entity wakes;
  std::mutex busy;
  std::vector<endpoint*> all;
  std::atomic<bool> is_over{false};
  std::thread worker;
};

// Where the messages of a node are: `topic` and `type` as they are named in DDS.
struct address {
  std::uint32_t domain = 0;
  std::string topic, type;
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

  void open(const address& at) {
    if (!own) own = std::make_unique<Endpoint>(connection::open(at.domain), at);
  }
  explicit operator bool() const { return own != nullptr; }
  Endpoint* operator->() const { return own.get(); }

private:
  std::unique_ptr<Endpoint> own;
};

}  // namespace cca::dds::detail
