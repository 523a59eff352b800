// What cca-call does with a door, command by command.
#pragma once

#include <chrono>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/main/run_program.hpp>

#include "../sample_fields.hpp"
#include "conversation.hpp"
#include "input_test.hpp"
#include "options.hpp"

namespace cca_door {

inline const parameter& parameter_named(const std::vector<parameter>& all, const std::string& name) {
  std::vector<std::string_view> names;
  for (const parameter& one : all) {
    if (one.path == name) return one;
    names.push_back(one.path);
  }
  throw cca::refused("there is no parameter " + name + meant(name, names));
}

inline void get(conversation& door, const call_options& o, std::ostream& out) {
  const auto all = parameters_of(door.describe());
  std::vector<parameter> wanted;
  for (const std::string& name : o.words) wanted.push_back(parameter_named(all, name));
  if (o.words.empty()) wanted = all;
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const parameter& one : wanted) {
    if (o.json) object[one.path] = one.value;
    else
      out << one.path << ' ' << text_of_value(one.value) << (one.unit.empty() ? "" : " " + one.unit) << '\n';
  }
  if (o.json) out << object.dump(2, ' ', false, json::error_handler_t::replace) << '\n';
}

// `NAME VALUE` and `NAME=VALUE`.
inline std::vector<std::pair<std::string, std::string>> assignments_in(
    const std::vector<std::string>& words) {
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (equals != 0 && equals != std::string::npos) {
      all.emplace_back(words[i].substr(0, equals), words[i].substr(equals + 1));
      continue;
    }
    if (i + 1 == words.size()) throw cca::command_line_error(words[i] + ": expected a value after it");
    all.emplace_back(words[i], words[i + 1]);
    ++i;
  }
  return all;
}

using assignments = std::vector<std::pair<std::string, std::string>>;
inline void set(conversation& door, const assignments& given) {
  const auto all = parameters_of(door.describe());
  json values = json::array();
  for (const auto& [name, text] : given)
    values.push_back({{"name", name}, {"value", value_in(parameter_named(all, name), text)}});
  const command_right mine(door);
  door.send({{"op", "setParameters"}, {"parameters", values}, {"id", "set"}});
  door.until(
      [](const event& one) {
        const std::string op = text_in(one.message, "op"), what = text_in(one.message, "message");
        constexpr std::string_view refusal = "setParameters: ";
        if (op == "status" && whole_in(one.message, "level") == 2 && what.starts_with(refusal))
          throw cca::refused(what.substr(refusal.size()));
        return op == "parameterValues" && text_in(one.message, "id") == "set";
      },
      "the parameters were not set");
}

inline void status(conversation& door, const call_options& o, std::ostream& out) {
  const channel* const of = door.told().channel_named("/cca/status");
  if (!of) throw cca::refused("this door has no status");
  door.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", of->id}}}}});
  json now;
  door.until(
      [&](const event& one) {
        if (one.what != event::kind::sample) return false;
        now = json::parse(one.bytes, nullptr, false);
        return now.is_object();
      },
      "no status comes");
  if (o.json) return void(out << written(now, 2) << '\n');
  for (const auto& [name, value] : now.items()) {
    if (name != "environments" && name != "twins")
      out << name << ' ' << text_of_value(value.is_null() ? json("") : value) << '\n';
  }
  for (const json& one : list_in(now, "environments"))
    for (const auto& [name, value] : one.items())
      if (name != "name")
        out << "environments." << text_in(one, "name") << '.' << name << ' ' << text_of_value(value) << '\n';
  for (const json& one : list_in(now, "twins"))
    out << "twins." << text_in(one, "client") << ' ' << text_in(one, "says") << '\n';
}

inline void describe(conversation& door, const call_options& o, std::ostream& out) {
  const json all = door.describe();
  if (o.json) return void(out << written(all, 2) << '\n');
  out << "program " << text_in(all, "program") << '\n';
  for (const char* const list : {"modes", "parts", "nodes"})
    for (const std::string& one : texts_in(all, list))
      out << std::string(list).substr(0, std::string_view(list).size() - 1) << ' ' << one << '\n';
  for (const channel& one : door.told().channels) {
    const message_schema schema(one.schema);
    if (one.encoding != "cdr" || !schema.is_of_output()) continue;
    out << "output " << path_of(one.topic);
    for (std::size_t i = 2; i < schema.fields().size(); ++i) {
      const auto& field = schema.fields()[i];
      out << (i == 2 ? ": " : ", ") << field.name << (field.unit.empty() ? "" : " " + field.unit);
    }
    out << '\n';
  }
  for (const parameter& one : parameters_of(all)) {
    const std::string range = range_of(one);
    out << "parameter " << one.path << ' ' << text_of_value(one.value)
        << (one.unit.empty() ? "" : " " + one.unit) << (range.empty() ? "" : " (" + range + ")") << '\n';
  }
  for (const json& one : list_in(all, "tests"))
    out << "test " << text_in(one, "input") << " (up to " << text_of(number_in(one, "most")) << ' '
        << text_in(one, "unit") << ")\n";
  for (const json& one : list_in(all, "commands")) {
    out << "command " << text_in(one, "name");
    for (const json& of : list_in(one, "arguments")) {
      out << ' ' << text_in(of, "name") << '=' << text_of_value(member(of, "value"));
      const std::string unit = text_in(of, "unit");
      out << " (" << text_of(number_in(of, "lower")) << " to " << text_of(number_in(of, "upper"))
          << (unit.empty() ? "" : " " + unit) << ')';
    }
    out << (is_set(one, "held") ? ", held" : "") << ": " << text_in(one, "help") << '\n';
  }
}

// Seconds with all their nanoseconds.
inline std::string seconds_text(std::uint64_t nanoseconds) {
  std::string rest = std::to_string(nanoseconds % 1'000'000'000);
  return std::to_string(nanoseconds / 1'000'000'000) + "." + std::string(9 - rest.size(), '0') + rest;
}

inline void watch(conversation& door, const call_options& o, std::ostream& out, std::ostream& error) {
  const channel* const found = door.told().channel_named(o.words[0]);
  if (!found) {
    std::vector<std::string> paths;
    for (const channel& one : door.told().channels) paths.push_back(path_of(one.topic));
    const std::string near = meant(o.words[0], std::vector<std::string_view>(paths.begin(), paths.end()));
    throw cca::refused("there is no output " + o.words[0] + (near.empty() ? "; `describe` lists all" : near));
  }
  const channel of = *found;
  const message_schema schema(of.schema);
  const bool is_cdr = of.encoding == "cdr";
  if (!o.json && is_cdr) {
    out << "# time s";
    for (const auto& field : schema.fields()) {
      const std::string unit = field.name == "origin" && field.unit.empty() ? "ns" : field.unit;
      out << ", " << field.name << (unit.empty() ? "" : " " + unit);
    }
    out << '\n' << std::flush;
  }
  door.send({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", of.id}}}}});
  std::uint64_t count = 0;
  const auto show = [&](const event& one) {
    if (text_in(one.message, "op") == "status" && whole_in(one.message, "level") == 1)
      error << "cca-call: " << text_in(one.message, "message") << '\n';
    if (one.what != event::kind::sample) return false;
    if (!is_cdr) out << one.bytes << '\n';
    else if (const auto read = schema.read(one.bytes); !read)
      throw no_connection(of.topic + ": a sample does not fit its schema");
    else if (o.json) {
      nlohmann::ordered_json all{{"time", static_cast<double>(one.time) * 1e-9}};
      all.update(*read);
      out << all.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    } else {
      out << seconds_text(one.time);
      for (const auto& [name, value] : read->items())
        out << ' '
            << (value.is_number_float() && value.get<double>() != value.get<double>() ? "nan"
                : value.is_string() ? value.get<std::string>()
                                    : value.dump(-1, ' ', false, json::error_handler_t::replace));
      out << '\n';
    }
    return ++count == o.count;
  };
  while (out && !door.next(show)) out.flush();
  out.flush();
}

// While it is held nothing else happens; the effect ends with this call, however it ends.
inline void command(conversation& door,
                    const call_options& o,
                    const assignments& given,
                    std::ostream& error) {
  const std::string& name = o.words[0];
  const json described = door.describe();
  json of;
  std::vector<std::string> names;
  for (const json& one : list_in(described, "commands")) {
    names.push_back(text_in(one, "name"));
    if (names.back() == name) of = one;
  }
  if (of.is_null()) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw cca::refused("there is no command " + name + meant(name, views) + "; `describe` lists all");
  }
  const bool is_held = is_set(of, "held");
  if (o.hold_for && !is_held) throw cca::refused("--for: " + name + " is not held, it ends by itself");
  json arguments = json::object();
  for (const auto& [argument, text] : given) {
    parameter as{.path = argument, .kind = "number"};
    for (const json& one : list_in(of, "arguments"))
      if (text_in(one, "name") == argument) as.unit = text_in(one, "unit");
    arguments[argument] = value_in(as, text);
  }

  const command_right mine(door);
  door.call("/cca/command/" + name, arguments);
  if (!is_held) return;
  if (!o.hold_for) error << "cca-call: " << name << " is held until ctrl-c\n" << std::flush;
  const auto end = conversation::clock::now() + std::chrono::duration_cast<conversation::clock::duration>(
                                                    std::chrono::duration<double>(o.hold_for.value_or(1e6)));
  // A signal ends it too: giving the command back releases it.
  while (conversation::clock::now() < end) door.next([](const event&) { return false; });
  door.call("/cca/release/" + name);
}

// The service of a command that is one call, and its arguments. Other commands get their own name, which is
// never called.
inline std::pair<std::string, json> service_of(const call_options& o) {
  const auto& w = o.words;
  const auto word = [&](std::size_t i) { return i < w.size() ? w[i] : std::string(); };
  const std::string& c = o.command;
  const auto file = [&] {
    json all = json::object();
    if (!w.empty()) all["file"] = w[0];
    if (w.size() > 1) all["scope"] = w[1];
    return all;
  };
  if (c == "test") return {"/cca/test", arguments_of_test(o)};
  if (c == "go-on") return {"/cca/go_on", json::object()};
  if (c == "step")
    return {"/cca/step", {{"beats", w.empty() ? 1 : cca::whole_number_in("step", w[0], 1, 1'000'000)}}};
  if (c == "speed") return {"/cca/speed", {{"factor", cca::number_in("speed", w[0], 1e-3, 1000)}}};
  if (c == "mode") return {"/cca/switch_mode", {{"mode", word(0)}}};
  if (c == "start" && !w.empty()) return {"/cca/start_part", {{"part", word(0)}}};
  if (c == "stop" && !w.empty()) return {"/cca/stop_part", {{"part", word(0)}}};
  if (c == "end-recording") return {"/cca/end_recording", json::object()};
  if (c == "release") return {"/cca/release/" + word(0), json::object()};
  if (c == "load" || c == "save" || c == "record") return {"/cca/" + c, file()};
  return {"/cca/" + c, json::object()};  // pause, resume, undo, start, stop
}

inline int run_call(call_options& o, std::ostream& out, std::ostream& error) {
  o.split();
  const std::string token = o.token.value();
  // Before it connects: what is wrong is refused first.
  const std::string& c = o.command;
  const auto [service, arguments] = service_of(o);
  const assignments given = c == "set"       ? assignments_in(o.words)
                            : c == "command" ? assignments_in({o.words.begin() + 1, o.words.end()})
                                             : assignments();
  const cca::interruption signals;
  try {
    conversation door(o.door, token, signals,
                      std::chrono::milliseconds(static_cast<std::int64_t>(o.answers_within * 1000)));
    if (c == "get") get(door, o, out);
    else if (c == "set") set(door, given);
    else if (c == "status") status(door, o, out);
    else if (c == "describe") describe(door, o, out);
    else if (c == "watch") watch(door, o, out, error);
    else if (c == "command") command(door, o, given, error);
    else if (c == "test") test(door, arguments, o.json, out);
    else if (c == "stop" && o.words.empty()) {  // whoever commands
      door.need_token("to stop the run");
      door.call(service, arguments);
    } else {
      const command_right mine(door);
      door.call(service, arguments);
    }
    door.end();
    return cca::exit_code::done;
  } catch (const interrupted&) { return signals.exit_code(); }
}

}  // namespace cca_door
