// The messages that a door sends: those of foxglove/ws-protocol, and those of its own, whose `op` begins with
// `cca.`. docs/door.md
#pragma once

#include <algorithm>
#include <cstdint>
#include <list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/controls.hpp>
#include <cca/door/network/client.hpp>
#include <cca/door/network/values_functions.hpp>
#include <cca/record/file/message_sink.hpp>

namespace cca::detail::door_network {

inline std::string server_info(const std::string& program, const std::string& session) {
  return written({{"op", "serverInfo"},
                  {"name", program.empty() ? "cca" : "cca: " + program},
                  {"capabilities", json::array({"parameters", "parametersSubscribe", "services",
                                                "connectionGraph", "time", "assets"})},
                  {"supportedEncodings", json::array({"json"})},
                  {"sessionId", session}});
}

// Level 0: for information, 1: a warning, 2: an error.
inline std::string status_message(int level, const std::string& what) {
  return written({{"op", "status"}, {"level", level}, {"message", what}});
}

inline json json_of(const recording::channel_info& one, bool is_json) {
  json all{{"id", one.id},
           {"topic", one.topic},
           {"encoding", is_json ? "json" : "cdr"},
           {"schemaName", one.type},
           {"schema", one.schema},
           {"schemaEncoding", is_json ? "jsonschema" : "ros2msg"}};
  if (!one.metadata.empty()) all["metadata"] = one.metadata;
  return all;
}

inline json json_of(const door_parameter& one, bool with_ranges) {
  json all{{"name", one.path}, {"value", json_of(one.value)}};
  if (one.value.what == door_value::kind::number) all["type"] = "float64";
  if (one.value.what == door_value::kind::numbers) all["type"] = "float64_array";
  if (!with_ranges) return all;
  all["path"] = one.path;
  all.erase("name");
  all.erase("type");
  all["kind"] = name_of(one.value.what);
  all["unit"] = one.unit;
  all["lower"] = one.lower ? json_of(*one.lower) : json(nullptr);
  all["upper"] = one.upper ? json_of(*one.upper) : json(nullptr);
  all["choices"] = one.choices;
  return all;
}

// `wanted(path)`: whether it is among them.
template <class Wanted>
std::string parameter_values(const std::vector<door_parameter>& all, Wanted&& wanted, const json* id) {
  json values = json::array();
  for (const auto& one : all)
    if (wanted(one.path)) values.push_back(json_of(one, false));
  json message{{"op", "parameterValues"}, {"parameters", std::move(values)}};
  if (id && id->is_string()) message["id"] = *id;
  return written(message);
}

inline std::string rights_message(bool may_change, bool commands, const std::string& commander) {
  return written({{"op", "cca.rights"},
                  {"mayChange", may_change},
                  {"commands", commands},
                  {"commandedBy", commander.empty() ? json(nullptr) : json(commander)}});
}

inline json json_of(const door_command& one) {
  json arguments = json::array();
  for (const auto& a : one.arguments)
    arguments.push_back({{"name", a.name},
                         {"unit", a.unit},
                         {"value", json_of(a.value)},
                         {"lower", json_of(a.lower)},
                         {"upper", json_of(a.upper)}});
  return {{"name", one.name}, {"help", one.help}, {"held", one.is_held}, {"arguments", std::move(arguments)}};
}

inline json json_of(const door_test_input& one) {
  return {{"input", one.input},
          {"node", one.node},
          {"unit", one.unit},
          {"axes", one.axes},
          {"most", json_of(one.most)}};
}

inline std::string description_message(const door_description& of,
                                       const std::vector<door_parameter>& parameters,
                                       const std::map<std::string, recording::detail::text_map>& metadata) {
  json wires = json::array(), commands = json::array(), ranges = json::array();
  for (const auto& [from, to] : of.wires) wires.push_back(json::array({from, to}));
  for (const auto& one : of.commands) commands.push_back(json_of(one));
  json tests = json::array();
  for (const auto& one : of.tests) tests.push_back(json_of(one));
  for (const auto& one : parameters) ranges.push_back(json_of(one, true));
  return written({{"op", "cca.description"},
                  {"program", of.program},
                  {"architecture", of.architecture},
                  {"modes", of.modes},
                  {"parts", of.parts},
                  {"nodes", of.nodes},
                  {"wires", std::move(wires)},
                  {"commands", std::move(commands)},
                  {"tests", std::move(tests)},
                  {"parameters", std::move(ranges)},
                  {"metadata", metadata}});
}

// The sample of /cca/status: the members of door_status and door_environment by their names.
inline std::string status_sample(const door_status& now,
                                 const std::vector<door_environment>& environments,
                                 const std::string& commander,
                                 const std::list<door_client>& clients) {
  json twins = json::array();
  for (const door_client& one : clients)
    if (!one.twin.empty()) twins.push_back({{"client", one.name}, {"says", one.twin}});
  json all = json::array();
  for (const auto& e : environments)
    all.push_back({{"name", e.name},
                   {"beats", e.beats},
                   {"overruns", e.overruns},
                   {"lost_periods", e.lost_periods},
                   {"late", e.late},
                   {"beat_mean", json_of(e.beat_mean)},
                   {"beat_p99", json_of(e.beat_p99)},
                   {"beat_most", json_of(e.beat_most)},
                   {"wake_up_mean", json_of(e.wake_up_mean)},
                   {"wake_up_p99", json_of(e.wake_up_p99)},
                   {"wake_up_most", json_of(e.wake_up_most)}});
  return written({{"state", now.state},
                  {"beat", now.beat},
                  {"overruns", now.overruns},
                  {"period", now.period},
                  {"is_paused", now.is_paused},
                  {"speed", json_of(now.speed)},
                  {"mode", now.mode},
                  {"fault", now.fault},
                  {"fault_path", now.fault_path},
                  {"recording", now.recording},
                  {"recording_problem", now.recording_problem},
                  {"stopped_parts", now.stopped_parts},
                  {"causes", now.causes},
                  {"environments", std::move(all)},
                  {"commandedBy", commander.empty() ? json(nullptr) : json(commander)},
                  {"clients", clients.size()},
                  {"twins", std::move(twins)}});
}

// Schemas of the two channels of the door itself: foxglove's viewers need one to plot.
inline std::string status_schema() {
  const json text{{"type", "string"}}, number{{"type", "number"}}, whole{{"type", "integer"}},
      yes{{"type", "boolean"}};
  json environment{
      {"name", text}, {"beats", whole}, {"overruns", whole}, {"lost_periods", whole}, {"late", whole}};
  for (const char* name :
       {"beat_mean", "beat_p99", "beat_most", "wake_up_mean", "wake_up_p99", "wake_up_most"})
    environment[name] = number;
  return written(
      {{"type", "object"},
       {"properties",
        {{"state", text},
         {"beat", whole},
         {"overruns", whole},
         {"period", whole},
         {"is_paused", yes},
         {"speed", number},
         {"mode", text},
         {"fault", text},
         {"fault_path", text},
         {"recording", text},
         {"recording_problem", text},
         {"stopped_parts", {{"type", "array"}, {"items", text}}},
         {"causes", {{"type", "array"}, {"items", text}}},
         {"environments", {{"type", "array"}, {"items", {{"type", "object"}, {"properties", environment}}}}},
         {"commandedBy", text},
         {"clients", whole},
         {"twins",
          {{"type", "array"},
           {"items", {{"type", "object"}, {"properties", {{"client", text}, {"says", text}}}}}}}}}});
}
inline std::string log_schema() {
  return written(
      {{"type", "object"},
       {"properties",
        {{"time", {{"type", "number"}}}, {"client", {{"type", "string"}}}, {"what", {{"type", "string"}}}}}});
}

// `gait.left.out` is published on /gait/left/out.
inline std::string topic_of(std::string path) {
  std::replace(path.begin(), path.end(), '.', '/');
  return path.starts_with("/") ? path : "/" + path;
}
inline std::string path_of(std::string topic) {
  std::replace(topic.begin(), topic.end(), '/', '.');
  return topic.substr(topic.starts_with('.') ? 1 : 0);
}
// The node of a port: the longest that its path begins with.
inline std::string node_of(const std::string& port, const std::vector<std::string>& nodes) {
  std::string best = port.substr(0, port.find_last_of("./"));
  std::size_t length = 0;
  for (const auto& one : nodes)
    if (one.size() >= length && port.size() > one.size() && port.starts_with(one) &&
        (port[one.size()] == '.' || port[one.size()] == '/'))
      best = one, length = one.size();
  return best;
}

inline std::string graph_message(const door_description& of, const std::vector<std::string>& services) {
  std::map<std::string, std::set<std::string>> publishers, subscribers;
  for (const auto& [from, to] : of.wires) {
    publishers[topic_of(from)].insert(node_of(from, of.nodes));
    subscribers[topic_of(from)].insert(node_of(to, of.nodes));
  }
  json published = json::array(), subscribed = json::array(), offered = json::array();
  for (const auto& [topic, nodes] : publishers)
    published.push_back({{"name", topic}, {"publisherIds", nodes}});
  for (const auto& [topic, nodes] : subscribers)
    subscribed.push_back({{"name", topic}, {"subscriberIds", nodes}});
  for (const auto& one : services) offered.push_back({{"name", one}, {"providerIds", json::array({"cca"})}});
  return written({{"op", "connectionGraphUpdate"},
                  {"publishedTopics", std::move(published)},
                  {"subscribedTopics", std::move(subscribed)},
                  {"advertisedServices", std::move(offered)},
                  {"removedTopics", json::array()},
                  {"removedServices", json::array()}});
}

}  // namespace cca::detail::door_network
