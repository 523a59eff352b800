// A connection for one call: it asks, and waits for the answer.
//
// Errors: cca::refused, what the door refuses, with its reason; no_connection, for everything about the
// connection.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/runtime/interruption.hpp>

#include "../client.hpp"
#include "../known_door.hpp"
#include "../parameter.hpp"

namespace cca_door {

struct no_connection : std::runtime_error {
  using runtime_error::runtime_error;
};
// A signal came while it waited.
struct interrupted : std::runtime_error {
  interrupted() : runtime_error("interrupted") {}
};

class conversation {
public:
  using clock = std::chrono::steady_clock;

  conversation(const door_address& to,
               const std::string& token,
               const cca::interruption& ends,
               std::chrono::milliseconds most)
      : address(to),
        signals(ends),
        answers_within(most),
        line(to, token, {.connecting = most, .silence = std::max(most, std::chrono::milliseconds(1000))}),
        has_token(!token.empty()) {
    until([this](const event&) { return door.has_rights; }, "the door does not greet");
    if (has_token && !door.may_change)
      throw cca::refused("this is not the token of the door at " + address.text() +
                         ": the program printed it at its start");
    if (!door.may_read)
      throw cca::refused("the door at " + address.text() +
                         " needs a token for reading, too: --token or --token-file");
  }

  const known_door& told() const { return door; }

  void send(const json& message) { line.send(message); }

  // Each event, until `is_enough(event)`.
  template <class Enough>
  void until(Enough is_enough, const std::string& complaint) {
    const auto end = clock::now() + answers_within;
    while (!next([&](const event& one) { return is_enough(one); }))
      if (clock::now() > end)
        throw no_connection(address.text() + ": " + complaint + " within " +
                            std::to_string(answers_within.count()) + " ms");
  }
  // Those that have come within 50 ms, until `is_enough`. False: it was not.
  template <class Enough>
  bool next(Enough is_enough) {
    line.wait(std::chrono::milliseconds(50));
    if (signals) throw interrupted();
    while (const auto one = line.next()) {
      if (one->what == event::kind::closed) throw no_connection(address.text() + ": " + one->bytes);
      if (one->what == event::kind::text) door.take(one->message);
      if (is_enough(*one)) return true;
    }
    return false;
  }

  json describe() {
    json described;
    send({{"op", "cca.describe"}});
    until(
        [&](const event& one) {
          if (text_in(one.message, "op") != "cca.description") return false;
          described = one.message;
          return true;
        },
        "it does not describe itself");
    return described;
  }

  json call(const std::string& service, const json& arguments = json::object()) {
    const auto found = door.services.find(service);
    if (found == door.services.end()) throw cca::refused("this door has no service " + service);
    const std::uint32_t number = line.call(found->second, arguments);
    json answer;
    until(
        [&](const event& one) {
          const bool is_failure = text_in(one.message, "op") == "serviceCallFailure" &&
                                  whole_in(one.message, "callId") == static_cast<std::int64_t>(number);
          if (one.what == event::kind::answer ? one.id != number : !is_failure) return false;
          answer = one.message;
          return true;
        },
        service + " was not answered");
    if (!is_set(answer, "success")) {
      const std::string why = text_in(answer, "message");
      throw cca::refused(why.empty() ? service + " was refused without a reason" : why);
    }
    return answer;
  }

  void need_token(const std::string& what) const {
    if (!has_token) throw cca::refused(what + " needs the token: --token, --token-file or CCA_TOKEN");
  }
  void take_command() {
    need_token("a change");
    call("/cca/take_command");
  }
  // It comes to this also after a refusal, and where the connection is lost.
  void give_command() noexcept {
    try {
      const auto found = door.services.find("/cca/give_command");
      if (found != door.services.end() && line.is_open()) line.call(found->second, json::object());
      line.close();
    } catch (...) {}  // the door takes it back with the connection
  }
  void end() { line.close(); }

private:
  door_address address;
  const cca::interruption& signals;
  std::chrono::milliseconds answers_within;
  client line;
  known_door door{};
  bool has_token;
};

// The right to command, for as long as this lives.
class command_right {
public:
  explicit command_right(conversation& c) : of(c) { of.take_command(); }
  ~command_right() { of.give_command(); }
  command_right(const command_right&) = delete;
  command_right& operator=(const command_right&) = delete;

private:
  conversation& of;
};

// "; did you mean `gait.frequency`?", or empty.
template <class Names>
std::string meant(const std::string& wrong, const Names& names) {
  const std::string_view near = cca::detail::nearest_path(wrong, names);
  return near.empty() ? std::string() : ", did you mean `" + std::string(near) + "`?";
}

}  // namespace cca_door
