// What cca-top knows of the program, made of what its door tells; and what it wants to tell the door.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../client.hpp"
#include "../known_door.hpp"
#include "../parameter.hpp"
#include "watched_output.hpp"

namespace cca_door {

// To the door: a message, or the call of a service.
struct to_door {
  json message{};
  std::string service{};  // empty: the message
  std::string said{};     // what the user asked for
};

// What the program offers beside what every run knows. Held: it acts until it is released.
struct command {
  std::string name{}, help{};
  bool is_held = false;
  std::vector<parameter> arguments{};  // numbers
};

inline std::vector<command> commands_of(const json& description) {
  std::vector<command> all;
  for (const json& one : list_in(description, "commands")) {
    command c{text_in(one, "name"), text_in(one, "help"), is_set(one, "held"), {}};
    for (const json& argument : list_in(one, "arguments")) {
      parameter p{text_in(argument, "name"),
                  "number",
                  text_in(argument, "unit"),
                  member(argument, "value"),
                  {},
                  {},
                  {}};
      const double lower = number_in(argument, "lower"), upper = number_in(argument, "upper");
      if (lower < upper) p.lower = lower, p.upper = upper;
      c.arguments.push_back(std::move(p));
    }
    all.push_back(std::move(c));
  }
  return all;
}

struct log_line {
  double time = 0;  // s since 1970
  std::string client{}, what{};
};

class top_model {
public:
  explicit top_model(bool token) : has_token(token) {}

  bool has_token;
  bool is_open = false;
  std::string why_closed = "connecting";
  known_door door{};
  json status{}, description{};
  std::vector<watched_output> outputs{};
  std::vector<parameter> parameters{};
  std::vector<command> commands{};
  std::set<std::string> held{};  // commands that this client holds
  std::deque<log_line> log{};
  std::uint64_t now = 0;  // ns, virtual
  std::vector<to_door> outgoing{};
  // The last answer, refusal or remark.
  std::string remark{};
  bool is_refusal = false;

  void remark_on(std::string text, bool refusal = false) { remark = std::move(text), is_refusal = refusal; }

  void take(const event& one) {
    switch (one.what) {
      case event::kind::opened:
        opened();
        break;
      case event::kind::closed:
        closed(one.bytes);
        break;
      case event::kind::text:
        text(one.message);
        break;
      case event::kind::sample:
        sample(one);
        break;
      case event::kind::time:
        now = std::max(now, one.time);
        break;
      case event::kind::answer:
        answer(one);
        break;
    }
  }

  // The client has sent a call: its answer will have this number.
  void called(std::uint32_t number, const to_door& what) { calls[number] = what; }

  void ask(const std::string& service, const std::string& said, json arguments = json::object()) {
    outgoing.push_back({std::move(arguments), service, said});
  }
  void set(const parameter& of, const json& value) {
    outgoing.push_back(
        {{{"op", "setParameters"}, {"id", "top"}, {"parameters", {{{"name", of.path}, {"value", value}}}}},
         {},
         {}});
    last_set = of.path;
  }

  // Only what is looked at is subscribed: hundreds of outputs at 1 kHz would cost the robot a core.
  void look_at(const std::set<std::string>& paths) {
    json more = json::array(), less = json::array();
    for (watched_output& one : outputs) {
      const bool is_wanted = paths.contains(one.path);
      if (is_wanted == (one.subscription != 0)) continue;
      if (is_wanted) {
        one.begin(++last_subscription, now);
        more.push_back({{"id", last_subscription}, {"channelId", one.channel_id}});
        by_subscription[last_subscription] = one.path;
      } else {
        less.push_back(one.subscription);
        by_subscription.erase(one.subscription);
        one.subscription = 0;
      }
    }
    if (!less.empty()) outgoing.push_back({{{"op", "unsubscribe"}, {"subscriptionIds", less}}, {}, {}});
    if (!more.empty()) outgoing.push_back({{{"op", "subscribe"}, {"subscriptions", more}}, {}, {}});
  }

  void each_second() {
    for (watched_output& one : outputs) one.measure(now);
  }

  bool is_stopped(const std::string& node) const {
    const auto parts = texts_in(status, "stopped_parts");
    return std::any_of(parts.begin(), parts.end(),
                       [&](const std::string& part) { return node == part || node.starts_with(part + "."); });
  }
  bool is_faulty(const std::string& node) const {
    const std::string path = text_in(status, "fault_path");
    return !path.empty() && (path == node || path.starts_with(node + "."));
  }

private:
  static constexpr std::uint32_t status_subscription = 1, log_subscription = 2;
  static constexpr std::size_t most_lines = 500;

  std::map<std::uint32_t, std::string> by_subscription{};
  std::map<std::uint32_t, to_door> calls{};
  std::map<std::string, std::size_t> place{};  // of an output, by path
  std::uint32_t last_subscription = log_subscription;
  std::string last_set{};
  bool has_asked = false;

  void opened() {
    is_open = true;
    has_asked = false;
    door = {};
    outputs.clear(), place.clear(), by_subscription.clear(), calls.clear();
    log.clear();  // the door sends its last lines again
    now = 0;
    last_subscription = log_subscription;
    outgoing.clear();
  }
  void closed(const std::string& why) {
    is_open = false;
    why_closed = why;
    door.commands = false, door.has_rights = false;
    held.clear();
    outgoing.clear();
    calls.clear();
  }

  void text(const json& message) {
    const std::string op = text_in(message, "op");
    const bool had_rights = door.has_rights;
    if (door.take(message)) channels_changed();
    if (op == "cca.rights") rights(had_rights);
    else if (op == "status") told(message);
    else if (op == "cca.description") {
      description = message;
      parameters = parameters_of(message);
      commands = commands_of(message);
    } else if (op == "parameterValues") {
      values(message);
    } else if (op == "serviceCallFailure") {
      remark_on(text_in(message, "message"), true);
      calls.erase(static_cast<std::uint32_t>(whole_in(message, "callId")));
    }
  }
  void rights(bool had_rights) {
    if (!door.commands) held.clear();  // the door releases what it held
    if (!had_rights && has_token && !door.may_change)
      remark_on("this is not the token of this door: you only read", true);
    if (!door.may_read || has_asked) return;
    has_asked = true;
    outgoing.push_back({{{"op", "cca.describe"}}, {}, {}});
    outgoing.push_back({{{"op", "subscribeParameterUpdates"}, {"parameterNames", json::array()}}, {}, {}});
  }
  void told(const json& message) {
    const std::string what = text_in(message, "message");
    constexpr std::string_view refusal = "setParameters: ";
    remark_on(what.starts_with(refusal) ? what.substr(refusal.size()) : what, whole_in(message, "level") > 0);
    if (what.starts_with(refusal)) last_set.clear();
  }
  void values(const json& message) {
    for (const json& one : list_in(message, "parameters"))
      for (parameter& p : parameters)
        if (p.path == text_in(one, "name")) {
          p.value = member(one, "value");
          if (text_in(message, "id") == "top" && p.path == last_set)
            remark_on(p.path + " is " + text_of_value(p.value) + (p.unit.empty() ? "" : " " + p.unit));
        }
  }

  void channels_changed() {
    // What is watched already goes on.
    std::map<std::uint32_t, watched_output> before;
    for (watched_output& one : outputs) before.emplace(one.channel_id, std::move(one));
    outputs.clear(), place.clear();
    for (const channel& one : door.channels) {
      if (one.topic == "/cca/status") subscribe_once(status_subscription, one.id);
      else if (one.topic == "/cca/log") subscribe_once(log_subscription, one.id);
      if (one.encoding != "cdr") continue;
      watched_output output(one);
      if (!output.schema.is_of_output()) continue;
      const auto old = before.find(one.id);
      if (old != before.end() && old->second.path == output.path) output = std::move(old->second);
      place[output.path] = outputs.size();
      outputs.push_back(std::move(output));
    }
  }
  void subscribe_once(std::uint32_t subscription, std::uint32_t channel_id) {
    if (!by_subscription.emplace(subscription, "").second) return;
    outgoing.push_back(
        {{{"op", "subscribe"}, {"subscriptions", {{{"id", subscription}, {"channelId", channel_id}}}}},
         {},
         {}});
  }

  void sample(const event& one) {
    now = std::max(now, one.time);
    if (one.id == status_subscription) {
      json read = json::parse(one.bytes, nullptr, false);
      if (read.is_object()) status = std::move(read);
      const auto virtual_now = whole_in(status, "beat") * whole_in(status, "period");
      if (virtual_now > 0) now = std::max(now, static_cast<std::uint64_t>(virtual_now));
      return;
    }
    if (one.id == log_subscription) {
      const json line = json::parse(one.bytes, nullptr, false);
      log.push_back({number_in(line, "time"), text_in(line, "client"), text_in(line, "what")});
      if (log.size() > most_lines) log.pop_front();
      return;
    }
    const auto path = by_subscription.find(one.id);
    if (path == by_subscription.end()) return;
    const auto at = place.find(path->second);
    if (at != place.end() && outputs[at->second].subscription == one.id)
      outputs[at->second].take(one.time, one.bytes);
  }

  void answer(const event& one) {
    const auto call = calls.find(one.id);
    if (call == calls.end()) return;
    const bool is_done = is_set(one.message, "success");
    const std::string why = text_in(one.message, "message"), &said = call->second.said;
    remark_on(is_done       ? said + (why.empty() ? "" : ": " + why)
              : why.empty() ? said + " was refused"
                            : why,
              !is_done);
    if (is_done) done(call->second.service);
    calls.erase(call);
  }
  void done(const std::string& service) {
    constexpr std::string_view begins = "/cca/command/", ends = "/cca/release/";
    if (service.starts_with(ends)) held.erase(service.substr(ends.size()));
    for (const command& one : commands)
      if (one.is_held && door.commands && service == std::string(begins) + one.name) held.insert(one.name);
  }
};

}  // namespace cca_door
