// Who may change anything, and who commands: one client at a time. It asks, it gives back, it loses the right
// with its connection; what it held is released then. hub.hpp
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include <cca/door/network/hub.hpp>
#include <cca/door/network/messages_functions.hpp>

namespace cca::detail::door_network {

inline const std::string how_to_show_token =
    "offer the sub-protocol cca.token.<token>, or send {\"op\":\"cca.token\",\"token\":\"<token>\"}; the "
    "program prints it at start";

inline void hub::show_token(door_client& c, const std::string& offered) {
  const bool could_read = c.may_read();
  if (is_same_secret(offered, token)) {
    c.has_token = true;
    if (!could_read) welcome(c);
  } else if (++c.wrong_tokens >= limits.wrong_tokens) {
    c.say(status_message(2, "a wrong token, for the last time"));
    log(c.name, "was sent away after " + std::to_string(c.wrong_tokens) + " wrong tokens", false);
    c.close(unwelcome, "wrong tokens");
  } else {
    c.say(status_message(2, "this is not the token of this door: " + how_to_show_token));
  }
  tell_rights(c);
}

inline void hub::tell_rights(door_client& c) {
  if (c.knows_cca) c.say(rights_message(c.has_token, commander == &c, commander_name()));
}
inline void hub::tell_rights() {
  for (door_client& c : clients) tell_rights(c);
}

inline std::string hub::take_command(door_client& c) {
  if (commander == &c) return {};
  if (commander) return commander->name + " commands: it must give the command back first";
  commander = &c;
  log(c.name, "takes the command", true);
  tell_rights();
  return {};
}

inline void hub::give_command(door_client& c, time_point now) {
  for (const std::string& one : std::exchange(held, {})) release(one, now);
  cut_test(now);
  speed_before.reset(), has_stepped = false;  // they stay
  commander = nullptr;
  log(c.name, "gives the command back", true);
  tell_rights();
}

// The client is gone already. First what it held ends, then happens what the program was told at start.
inline void hub::lose_command(const std::string& client, time_point now) {
  using about = door_request::what;
  if (settings.on_lost != when_lost::go_on) {
    door_task task{.name = "door",
                   .what = settings.on_lost == when_lost::stop ? "stops the run: its commander is lost"
                                                               : "holds: its commander is lost"};
    task.request.about = settings.on_lost == when_lost::stop ? about::end_run : about::pause;
    if (settings.on_lost == when_lost::stop)
      task.request.text = client + " lost its connection while it commanded, which has ended the run";
    requests.add_first(std::move(task), now);
  }
  for (const std::string& one : std::exchange(held, {})) release(one, now);
  cut_test(now);
  if (const auto before = std::exchange(speed_before, {})) set_speed_back(*before, now);
  if (std::exchange(has_stepped, false)) {
    door_task task{.name = "door", .what = "ends the single beats"};
    task.request.about = about::end_steps;
    requests.add_first(std::move(task), now);
  }
}

inline void hub::set_speed_back(double to, time_point now) {
  door_task task{.name = "door", .what = "sets the speed back to " + number_text(to)};
  task.request.about = door_request::what::speed;
  task.request.number = to;
  requests.add_first(std::move(task), now);
}

inline void hub::release(const std::string& command, time_point now) {
  door_task task{.name = "door", .what = "releases " + command};
  task.request.about = door_request::what::release;
  task.request.text = command;
  requests.add_first(std::move(task), now);
}

inline std::string hub::why_not(const door_client& c, bool needs_command) const {
  if (!c.has_token) return "this needs the token: " + how_to_show_token;
  if (!needs_command || commander == &c) return {};
  if (!commander) return "this needs the right to command: call /cca/take_command";
  return "this needs the right to command: " + commander->name + " has it and must give it back first";
}

inline void hub::log(const std::string& client, const std::string& what, bool is_change) {
  const double seconds =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  channels.log(written({{"time", seconds}, {"client", client}, {"what", what}}), is_change);
  if (is_change) controls.note(client, what);
}

}  // namespace cca::detail::door_network
