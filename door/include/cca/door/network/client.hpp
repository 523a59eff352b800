// One client of a door: its rights, its subscriptions, and the messages that wait for it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <cca/door/network/frames_functions.hpp>
#include <cca/door/network/limits.hpp>
#include <cca/door/network/outbox.hpp>

namespace cca::detail::door_network {

using time_point = std::chrono::steady_clock::time_point;

// How much of something a client may send: it fills up with time, to twice what comes in a second.
class allowance {
public:
  explicit allowance(double in_a_second) : rate(in_a_second), left(2 * in_a_second) {}
  bool take(double amount, time_point now) {
    if (last != time_point{})
      left = std::min(2 * rate, left + rate * std::chrono::duration<double>(now - last).count());
    last = now;
    return (left -= amount) >= 0;
  }

private:
  double rate, left;
  time_point last{};
};

struct door_client {
  door_client(std::uint64_t number, std::string address, const door_limits& limits, bool takes_batches)
      : id(number),
        name(std::move(address)),
        out(limits, takes_batches),
        messages(limits.messages_per_second),
        bytes(limits.bytes_per_second) {}

  std::uint64_t id;
  std::string name;                             // `127.0.0.1:40312`
  bool has_token = false, needs_token = false;  // to read, too
  bool knows_cca =
      false;  // it has sent a message that is the door's own: others would take ours for an error
  int wrong_tokens = 0;
  std::string twin{};  // what it says that its twin finds; empty: it runs none
  std::map<std::uint32_t, std::uint16_t> subscriptions{};  // to its channel
  bool all_parameters = false, wants_graph = false;
  std::set<std::string, std::less<>> parameters{};  // subscribed to
  outbox out;
  std::uint64_t told_lost = 0;
  time_point may_tell_lost{}, entered{}, last_sign{}, last_ping{};

  // Not 0: it must be closed, once what waits has been sent.
  close_code closing = no_fault;
  std::string why_closing{};

  allowance messages, bytes;

  void close(close_code code, std::string why) {
    if (closing == no_fault) closing = code, why_closing = std::move(why);
  }
  void say(const std::string& text) {
    if (!out.answer(frame_kind::text, text)) close(unwelcome, "this client does not read its answers");
  }
  bool may_read() const { return has_token || !needs_token; }
};

}  // namespace cca::detail::door_network
