// What a door's clients read: channels, parameters, the graph. hub.hpp
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include <cca/door/network/changes_functions.hpp>
#include <cca/door/network/hub.hpp>
#include <cca/door/network/input_tests_functions.hpp>
#include <cca/door/network/messages_functions.hpp>
#include <cca/door/network/rights_functions.hpp>

namespace cca::detail::door_network {

inline hub::hub(const door_settings& given,
                const door_limits& all,
                door_controls& of,
                std::string secret,
                one_time_keys& once,
                bool reading_too,
                wanted_channels& wanted,
                const kept_for_twins& kept)
    : settings(given),
      limits(all),
      controls(of),
      token(std::move(secret)),
      keys(once),
      twins(kept),
      guards_reading(reading_too),
      channels(wanted),
      requests(of, all),
      services(services_of(of.description())),
      told_services(advertised_services(services)),
      session(random_token()) {
  requests.on_end = [this](door_task& task, const door_outcome& outcome, const values* before,
                           const values* after, bool is_late) { end(task, outcome, before, after, is_late); };
}

inline door_client& hub::enter(const std::string& name, const greeting& hello, time_point now) {
  door_client& c = clients.emplace_back(++last_id, name, limits, hello.takes_batches);
  c.needs_token = guards_reading;
  c.knows_cca = hello.knows_cca;
  c.last_sign = c.entered = now;
  c.say(server_info(controls.description().program, session));
  const bool by_key = !hello.once.empty() && keys.take(hello.once);
  c.has_token = by_key;
  if (!by_key && !hello.once.empty())
    c.say(status_message(2, "this URL was valid once: ask the program for another one, or send the token"));
  if (by_key && !commander) take_command(c);
  if (c.may_read()) welcome(c);
  if (hello.has_token) show_token(c, hello.token_offered);
  else tell_rights(c);
  return c;
}

inline void hub::leave(door_client& c, time_point now) {
  requests.forget(c.id);
  std::erase_if(reads, [&](const auto& one) { return one.client == c.id; });
  channels.forget(c);
  const bool commanded = commander == &c;
  const std::string name = c.name;
  clients.remove_if([&](const door_client& one) { return &one == &c; });
  if (!commanded) return;
  commander = nullptr;
  log(name, "lost its connection while it commanded", true);
  lose_command(name, now);
  tell_rights();
}

inline bool hub::makes_room(const greeting& hello) {
  const bool is_right = hello.has_token && is_same_secret(hello.token_offered, token);
  if (!is_right && (hello.once.empty() || !keys.has(hello.once))) return false;
  for (door_client& c : clients)
    if (!c.has_token && c.closing == no_fault)
      return c.close(unwelcome, "this door is full: a client with the token takes the place"), true;
  return false;
}

inline void hub::welcome(door_client& c) {
  c.say(channels.advertised());
  c.say(told_services);
}

inline door_client* hub::client_of(std::uint64_t id) {
  const auto found =
      std::find_if(clients.begin(), clients.end(), [&](const auto& one) { return one.id == id; });
  return found == clients.end() ? nullptr : &*found;
}

inline void hub::refuse_flood(door_client& c) {
  c.close(unwelcome, "this client sends too much: at most " +
                         std::to_string(static_cast<int>(limits.messages_per_second)) + " messages a second");
}
inline bool hub::hears(door_client& c, std::size_t bytes, time_point now) {
  if (!c.bytes.take(static_cast<double>(bytes), now)) refuse_flood(c);
  return c.closing == no_fault;
}

inline void hub::message(door_client& c, frame_kind kind, std::string_view payload, time_point now) {
  c.last_sign = now;
  if (c.closing != no_fault) return;
  if (!c.messages.take(1, now)) return refuse_flood(c);
  if (kind == frame_kind::text) text(c, payload, now);
  if (kind == frame_kind::binary) binary(c, payload, now);
  if (kind == frame_kind::ping && !c.out.answer(frame_kind::pong, payload))
    c.close(unwelcome, "this client does not read its answers");
}

inline void hub::text(door_client& c, std::string_view payload, time_point now) {
  const auto m = read_json(payload, limits.depth);
  const std::string op = m ? text_member(*m, "op") : std::string();
  if (!m || op.empty())
    return c.say(status_message(
        2, "expected an object of JSON with `op`, at most " + std::to_string(limits.depth) + " deep"));
  if (op.starts_with("cca.") && !c.knows_cca) {
    c.knows_cca = true;
    tell_rights(c);
  }
  if (op == "cca.token") return show_token(c, text_member(*m, "token"));
  if (op == "cca.twin") return tell_of_twin(c, text_member(*m, "says"));
  if (!c.may_read())
    return c.say(status_message(
        2, "this door is open to other machines, so reading needs the token, too: " + how_to_show_token));
  const auto each = [&](const char* list, auto&& function) {
    const json* all = member(*m, list);
    if (!all || !all->is_array()) return c.say(status_message(2, op + ": expected a list `" + list + "`"));
    for (const json& one : *all) function(one);
  };
  // A message of many wrong items has few answers.
  std::size_t complaints = 0;
  const auto complain = [&](const std::string& what) {
    if (!what.empty() && ++complaints <= limits.complaints) c.say(status_message(2, what));
  };
  if (op == "subscribe")
    return each("subscriptions", [&](const json& one) {
      const auto id = one.is_object() ? small_number(member(one, "id")) : std::nullopt;
      const auto channel = one.is_object() ? small_number(member(one, "channelId")) : std::nullopt;
      complain(id && channel ? channels.subscribe(c, *id, *channel, limits.subscriptions)
                             : "subscribe: expected whole numbers id and channelId");
    });
  if (op == "unsubscribe")
    return each("subscriptionIds", [&](const json& one) {
      const auto id = small_number(&one);
      complain(id && channels.unsubscribe(c, *id) ? ""
                                                  : "unsubscribe: there is no subscription " + text_of(one));
    });
  if (op == "fetchAsset") return fetch_asset(c, *m);
  if (op == "getParameters") return read_parameters(c, *m, false, now);
  if (op == "cca.describe") return read_parameters(c, *m, true, now);
  if (op == "setParameters") return set_parameters(c, *m, now);
  if (op == "subscribeParameterUpdates") return subscribe_parameters(c, *m, true);
  if (op == "unsubscribeParameterUpdates") return subscribe_parameters(c, *m, false);
  if (op == "subscribeConnectionGraph") {
    std::vector<std::string> names;
    for (const auto& one : services) names.push_back(one.name);
    return c.say(graph_message(controls.description(), names));
  }
  if (op == "unsubscribeConnectionGraph") return;  // the graph never changes
  c.say(status_message(2, "this door does not offer " + text_of(op)));
}

// Everybody reads it in the status, so it needs the token.
inline void hub::tell_of_twin(door_client& c, std::string says) {
  if (const std::string why = why_not(c, false); !why.empty())
    return c.say(status_message(2, "cca.twin: " + why));
  if (says.size() > limits.twin_text) says.resize(limits.twin_text);
  c.twin = std::move(says);
}

inline void hub::fetch_asset(door_client& c, const json& m) {
  const auto request = small_number(member(m, "requestId"));
  if (!request) return c.say(status_message(2, "fetchAsset: expected a whole number requestId"));
  if (!c.out.answer(frame_kind::binary, twins.answer(*request, text_member(m, "uri"))))
    c.close(unwelcome, "this client does not read its answers");
}

inline void hub::binary(door_client& c, std::string_view payload, time_point now) {
  if (!c.may_read()) return c.say(status_message(2, "this door needs the token: " + how_to_show_token));
  if (const auto one = read_call(payload)) return call(c, *one, now);
  c.say(status_message(2, "of binary messages this door takes calls of services only"));
}

inline void hub::read_parameters(door_client& c, const json& m, bool is_description, time_point now) {
  waiting_read one{.client = c.id, .is_description = is_description, .names = {}, .id = {}, .since = now};
  if (const json* names = member(m, "parameterNames"); names && names->is_array())
    for (const json& name : *names)
      if (name.is_string()) one.names.insert(name.get<std::string>());
  if (const json* id = member(m, "id")) one.id = *id;
  if (reads.size() >= limits.requests)
    return c.say(status_message(2, "too many clients ask for parameters: try again"));
  if (!read_now(one, now)) reads.push_back(std::move(one));
}

// Whether it has an answer.
inline bool hub::read_now(const waiting_read& one, time_point now) {
  door_client* c = client_of(one.client);
  if (!c) return true;
  const auto all = controls.parameters();
  if (!all && now - one.since < limits.taken_time) return false;
  if (!all) return c->say(status_message(2, std::string("the parameters can't be read: ") + not_taken)), true;
  if (one.is_description) return c->say(description_message(controls.description(), *all, notes)), true;
  c->say(parameter_values(
      *all, [&](const std::string& name) { return one.names.empty() || one.names.contains(name); }, &one.id));
  std::size_t complaints = 0;
  for (const auto& name : one.names)
    if (complaints < limits.complaints &&
        std::none_of(all->begin(), all->end(), [&](const auto& p) { return p.path == name; }))
      ++complaints, c->say(status_message(2, "there is no parameter " + text_of(name)));
  return true;
}

inline void hub::subscribe_parameters(door_client& c, const json& m, bool is_more) {
  const json* names = member(m, "parameterNames");
  const bool all = !names || !names->is_array() || names->empty();
  if (all) {
    c.all_parameters = is_more;
    if (!is_more) c.parameters.clear();
    return;
  }
  for (const json& one : *names) {
    if (!one.is_string()) continue;
    if (one.get_ref<const std::string&>().size() > limits.name)
      return c.say(status_message(
          2, "subscribeParameterUpdates: a name has at most " + std::to_string(limits.name) + " bytes"));
    if (!is_more) c.parameters.erase(one.get<std::string>());
    else if (c.parameters.size() < limits.subscriptions) c.parameters.insert(one.get<std::string>());
    else
      return c.say(
          status_message(2, "subscribeParameterUpdates: at most " + std::to_string(limits.subscriptions)));
  }
}

// What differs from what was known, to those who have subscribed.
inline void hub::tell_changed(const values& now) {
  std::set<std::string> changed;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (i >= known.size() || known[i].path != now[i].path || known[i].value != now[i].value)
      changed.insert(now[i].path);
  known = now;
  if (changed.empty()) return;
  for (door_client& c : clients) {
    const auto wanted = [&](const std::string& name) {
      return changed.contains(name) && (c.all_parameters || c.parameters.contains(name));
    };
    if (c.may_read() &&
        std::any_of(now.begin(), now.end(), [&](const auto& one) { return wanted(one.path); }))
      c.say(parameter_values(now, wanted, nullptr));
  }
}

// Once, when it happens: a full disk must not be found out at the end.
inline void hub::tell_problem_of_recording() {
  std::string now = controls.recording_problem();
  if (now == told_problem) return;
  told_problem = std::move(now);
  if (told_problem.empty()) return;  // the file has ended
  const std::string what = "the recording is incomplete: " + told_problem;
  log("door", what, true);
  for (door_client& c : clients)
    if (c.may_read()) c.say(status_message(2, what));
}

inline void hub::channel(const recording::channel_info& one) {
  for (const std::string& message : channels.add(one))
    for (door_client& c : clients)
      if (c.may_read()) c.say(message);
}

inline void hub::time(std::uint64_t ns) {
  channels.latest = ns;
  for (door_client& c : clients)
    if (c.may_read()) c.out.time(ns);
}

inline void hub::lost(std::uint64_t count) {
  if (count == 0) return;
  tested.lost(count);
  for (door_client& c : clients)
    if (!c.subscriptions.empty()) c.out.lost += count;
}

inline void hub::tick(time_point now) {
  requests.tick(now);
  std::list<waiting_read> left;
  left.swap(reads);
  for (auto& one : left)
    if (!read_now(one, now)) reads.push_back(std::move(one));
}

inline void hub::regularly(time_point now) {
  tested.rest_if_over(channels.latest, channels);
  tell_problem_of_recording();
  // What is known after nobody has read it is as old as the last reader: that one asks for a look, the next
  // one is told.
  if (!channels.is_wanted(status_channel)) status_is_new = false;
  else if (const door_status seen = controls.status(); std::exchange(status_is_new, true))
    channels.show(status_channel, channels.latest,
                  status_sample(seen, controls.environments(), commander_name(), clients));
  if (now - watched > std::chrono::milliseconds(500)) {
    watched = now;
    if (std::any_of(clients.begin(), clients.end(),
                    [](const auto& c) { return c.all_parameters || !c.parameters.empty(); }))
      if (const auto all = controls.parameters()) tell_changed(*all);
  }
  for (door_client& c : clients) {
    channels.pay(c);
    if (c.out.lost > c.told_lost && c.out.has_room() && now >= c.may_tell_lost) {
      c.say(status_message(
          1, "this client is slow: it has lost " + std::to_string(c.out.lost - c.told_lost) + " messages"));
      c.told_lost = c.out.lost;
      c.may_tell_lost = now + std::chrono::seconds(1);
    }
    if (now - c.last_sign > std::chrono::seconds(1) && now - c.last_ping > std::chrono::seconds(1)) {
      c.last_ping = now;
      if (!c.out.answer(frame_kind::ping, {})) c.close(unwelcome, "this client does not read its answers");
    }
    if (now - c.last_sign > (&c == commander ? limits.commander_silence : limits.silence))
      c.close(going_away, "no sign of life");
    if (!c.may_read() && now - c.entered > limits.greeting_time) c.close(unwelcome, "no token");
  }
}

}  // namespace cca::detail::door_network
