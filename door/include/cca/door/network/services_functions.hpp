// The services of a door: their names and schemas, and what a call of one asks of the controller.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/door/controls.hpp>
#include <cca/door/network/outbox.hpp>
#include <cca/door/network/values_functions.hpp>

namespace cca::detail::door_network {

struct door_service {
  enum class does {
    take_command,
    give_command,
    undo,
    test,
    end_test,
    response,
    request
  } what = does::request;
  std::string name{};
  door_request::what about = door_request::what::pause;
  std::vector<door_command::argument> numbers{};  // of a call of a command
  std::vector<std::string> texts{};               // names of arguments that are texts
  std::string command{};                          // of call and release
  bool is_held = false;
};

inline std::vector<door_service> services_of(const door_description& of) {
  using does = door_service::does;
  using about = door_request::what;
  const double most = 1e6;
  std::vector<door_service> all{{does::take_command, "/cca/take_command"},
                                {does::give_command, "/cca/give_command"},
                                {does::request, "/cca/pause", about::pause},
                                {does::request, "/cca/go_on", about::go_on},
                                {does::request, "/cca/step", about::step, {{"beats", "", 1, 1, most}}},
                                {does::request, "/cca/speed", about::speed, {{"factor", "", 1, 1e-3, 1000}}},
                                {does::request, "/cca/stop", about::end_run},
                                {does::request, "/cca/resume", about::resume},
                                {does::request, "/cca/start", about::start},
                                {does::request, "/cca/stop_part", about::stop_part, {}, {"part"}},
                                {does::request, "/cca/start_part", about::start_part, {}, {"part"}},
                                {does::request, "/cca/switch_mode", about::switch_mode, {}, {"mode"}},
                                {does::request, "/cca/load", about::load, {}, {"file", "scope"}},
                                {does::request, "/cca/save", about::save, {}, {"file", "scope"}},
                                {does::request, "/cca/record", about::record, {}, {"file"}},
                                {does::request, "/cca/end_recording", about::end_recording},
                                {does::undo, "/cca/undo"}};
  for (const auto& one : of.commands) {
    all.push_back(
        {does::request, "/cca/command/" + one.name, about::call, one.arguments, {}, one.name, one.is_held});
    if (one.is_held)
      all.push_back({does::request, "/cca/release/" + one.name, about::release, {}, {}, one.name, true});
  }
  if (of.tests.empty()) return all;
  all.push_back({.what = does::test,
                 .name = "/cca/test",
                 .numbers = {{"axis"},
                             {"amplitude"},
                             {"frequency", "Hz", 1},
                             {"to", "Hz", 10},
                             {"duration", "s", 10},
                             {"output_axis"},
                             {"from_axis"}},
                 .texts = {"input", "signal", "output", "from"}});
  all.push_back({.what = does::end_test, .name = "/cca/end_test"});
  all.push_back({.what = does::response, .name = "/cca/response"});
  return all;
}

inline json schema_of(const door_service& of) {
  json properties = json::object();
  for (const auto& one : of.numbers) {
    json number{{"type", "number"}, {"default", json_of(one.value)}};
    if (one.lower < one.upper) number["minimum"] = one.lower, number["maximum"] = one.upper;
    if (!one.unit.empty()) number["description"] = "in " + one.unit;
    properties[one.name] = number;
  }
  for (const auto& one : of.texts) properties[one] = {{"type", "string"}};
  return {{"type", "object"}, {"properties", properties}};
}

// Their ids are their places, from 1 on. The schemas are there twice: requestSchema and responseSchema are
// what viewers read that know an older protocol; without them one of those shows nothing at all.
inline std::string advertised_services(const std::vector<door_service>& all) {
  const std::string answer =
      R"({"type":"object","properties":{"success":{"type":"boolean"},"message":{"type":"string"}}})";
  json services = json::array();
  std::uint32_t id = 0;
  for (const auto& one : all)
    services.push_back({{"id", ++id},
                        {"name", one.name},
                        {"type", one.name.substr(1)},
                        {"requestSchema", written(schema_of(one))},
                        {"responseSchema", answer},
                        {"request",
                         {{"encoding", "json"},
                          {"schemaName", one.name.substr(1) + ".request"},
                          {"schemaEncoding", "jsonschema"},
                          {"schema", written(schema_of(one))}}},
                        {"response",
                         {{"encoding", "json"},
                          {"schemaName", "cca.answer"},
                          {"schemaEncoding", "jsonschema"},
                          {"schema", answer}}}});
  return written({{"op", "advertiseServices"}, {"services", std::move(services)}});
}

// A file that a client names is below the folder in which the program runs, and has the ending of its kind
// after a name that everybody sees.
inline std::string wrong_file(const std::string& name, std::string_view ending) {
  const std::string bounded = "/" + name + "/";
  const bool has_control =
      std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; });
  if (name.empty() || name.size() > 255 || name.front() == '/' || has_control ||
      bounded.find("/../") != std::string::npos || !name.ends_with(ending) ||
      bounded.ends_with("/" + std::string(ending) + "/") || bounded.find("/ ") != std::string::npos)
    return "expected a file below the folder in which the program runs, without `..`, with the ending " +
           std::string(ending) + " and a name before it that begins with no space";
  return {};
}

// Empty: it has all these arguments.
inline std::string unknown_argument(const door_service& of, const json& given) {
  for (const auto& [name, value] : given.items()) {
    const bool known = std::any_of(of.numbers.begin(), of.numbers.end(),
                                   [&](const auto& one) { return one.name == name; }) ||
                       std::find(of.texts.begin(), of.texts.end(), name) != of.texts.end();
    if (known) continue;
    std::string names;
    for (const auto& one : of.numbers) names += " " + one.name;
    for (const auto& one : of.texts) names += " " + one;
    return "it has no argument " + text_of(name) + (names.empty() ? ", and no other" : ", only" + names);
  }
  return {};
}

// The request of a call; else `why` says what is wrong.
inline std::optional<door_request> request_of(const door_service& of, const json& given, std::string& why) {
  door_request request{.about = of.about};
  const auto refuse = [&](const std::string& what) {
    why = of.name + ": " + what;
    return std::nullopt;
  };
  if (const std::string wrong = unknown_argument(of, given); !wrong.empty()) return refuse(wrong);
  for (const auto& one : of.numbers) {
    const json* number = member(given, one.name.c_str());
    const std::optional<double> lower = one.lower < one.upper ? std::optional(one.lower) : std::nullopt;
    const std::optional<double> upper = one.lower < one.upper ? std::optional(one.upper) : std::nullopt;
    const std::string range = lower              ? " " + range_text(lower, upper, one.unit)
                              : one.unit.empty() ? ""
                                                 : " in " + one.unit;
    if (number && (!number->is_number() || !is_within(number->get<double>(), lower, upper)))
      return refuse(one.name + " = " + text_of(*number) + ": expected a number" + range);
    const double value = number ? number->get<double>() : one.value;
    if (of.about == door_request::what::step && value != std::floor(value))
      return refuse("beats = " + text_of(*number) + ": expected a whole number" + range);
    request.number = value;
    if (of.about == door_request::what::call)
      request.values.emplace_back(one.name, door_value{.number = value});
  }
  for (const auto& one : of.texts) {
    const json* text = member(given, one.c_str());
    if (text && !text->is_string()) return refuse(one + " = " + text_of(*text) + ": expected a text");
    (one == "scope" ? request.scope : request.text) = text ? text->get<std::string>() : "";
    if ((one == "part" || one == "mode") && request.text.empty()) return refuse("say which " + one);
  }
  if (!of.command.empty()) request.text = of.command;
  using about = door_request::what;
  if (of.about == about::load || of.about == about::save || of.about == about::record)
    if (const std::string wrong = wrong_file(request.text, of.about == about::record ? ".mcap" : ".toml");
        !wrong.empty())
      return refuse((request.text.empty() ? "say which file: " : "file = " + text_of(request.text) + ": ") +
                    wrong);
  return request;
}

// For the log: what has changed.
inline std::string text_of(const door_request& of, const std::string& service) {
  std::string text = service;
  for (const auto& [name, value] : of.values) text += " " + name + "=" + text_of(json_of(value));
  if (of.about == door_request::what::step || of.about == door_request::what::speed)
    text += " " + number_text(of.number);
  if (!of.text.empty() && of.about != door_request::what::call && of.about != door_request::what::release)
    text += " " + of.text;
  if (!of.scope.empty()) text += " of " + of.scope;
  return text;
}

// The bytes of a call: `op` 2, the service, the call, the length of the encoding, the encoding, the payload.
struct service_call {
  std::uint32_t service = 0, call = 0;
  std::string_view encoding{}, payload{};
};
inline std::optional<service_call> read_call(std::string_view bytes) {
  std::uint32_t size = 0;
  if (bytes.size() < 13 || bytes[0] != 2) return {};
  service_call one;
  std::memcpy(&one.service, bytes.data() + 1, 4);
  std::memcpy(&one.call, bytes.data() + 5, 4);
  std::memcpy(&size, bytes.data() + 9, 4);
  if (size > bytes.size() - 13) return {};
  one.encoding = bytes.substr(13, size);
  one.payload = bytes.substr(13 + size);
  return one;
}
inline std::string bytes_of_answer(std::uint32_t service, std::uint32_t call, const std::string& answer) {
  std::string bytes = "\3";
  add_number(bytes, service);
  add_number(bytes, call);
  add_number(bytes, std::uint32_t{4});
  return bytes + "json" + answer;
}
inline std::string answer_of_call(std::uint32_t service,
                                  std::uint32_t call,
                                  bool success,
                                  const std::string& message) {
  return bytes_of_answer(service, call, written({{"success", success}, {"message", message}}));
}

}  // namespace cca::detail::door_network
