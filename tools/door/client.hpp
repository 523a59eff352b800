// The client's side of a door: one connection of the Foxglove protocol over WebSocket.
//
// It has no thread. What happens, happens in `wait`; what has arrived waits in a bounded queue, and while
// that is full nothing more is read. Nothing here throws for what the other side does: a connection that
// can't be made, or is lost, is an event `closed` that says why. The program's own words may be wrong: then
// `client` throws. Only client.cpp knows Boost.Beast.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "address.hpp"
#include "members.hpp"

namespace cca_door {

struct event {
  enum class kind { opened, closed, text, sample, time, answer };
  kind what = kind::closed;
  json message{};          // of a text; of an answer {"success", "message"}
  std::uint32_t id = 0;    // the subscription of a sample, the call of an answer
  std::uint64_t time = 0;  // virtual time in ns, of a sample or a time
  std::string bytes{};     // of a sample; closed: why
};

struct patience {
  std::chrono::milliseconds connecting{5000};  // until the other side has greeted
  std::chrono::milliseconds silence{10000};    // after half of it the other side is asked whether it lives
};

class client {
public:
  client(const door_address& to, const std::string& token, patience how_long = {});  // begins to connect
  client(const client&) = delete;
  client& operator=(const client&) = delete;
  ~client();

  // Until something has arrived, `file` (a descriptor) can be read, or the time has passed.
  void wait(std::chrono::milliseconds most, int file = -1);
  std::optional<event> next();

  bool is_open() const;    // from `opened` to `closed`
  bool is_closed() const;  // for good: make a new client
  void send(const json& message);
  // Returns the number that its answer will have.
  std::uint32_t call(std::uint32_t service, const json& arguments);
  // Takes leave, so that the other side does not count this client as lost; at most a second.
  void close();

private:
  struct inside;
  std::unique_ptr<inside> in;
};

}  // namespace cca_door
