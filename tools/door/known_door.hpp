// What a door has told: its channels and services, and what this client may do.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "members.hpp"

namespace cca_door {

struct channel {
  std::uint32_t id = 0;
  std::string topic{}, encoding{}, type{}, schema{};
};

// The path of a port, `robot.angles`, of its topic, `/robot/angles`.
inline std::string path_of(std::string_view topic) {
  std::string path(topic.substr(topic.starts_with('/') ? 1 : 0));
  for (char& c : path)
    if (c == '/') c = '.';
  return path;
}

class known_door {
public:
  std::string program{}, session{};
  std::vector<channel> channels{};  // in the order of the door
  std::map<std::string, std::uint32_t> services{};
  // `cca.rights` has come: before it, nothing is known of this client's rights.
  bool has_rights = false;
  bool may_read = false, may_change = false, commands = false;
  std::string commanded_by{};  // empty: nobody

  // Returns whether the channels have changed.
  bool take(const json& message) {
    const std::string op = text_in(message, "op");
    if (op == "serverInfo") program = text_in(message, "name"), session = text_in(message, "sessionId");
    else if (op == "cca.rights") {
      has_rights = true;
      may_change = is_set(message, "mayChange");
      commands = is_set(message, "commands");
      commanded_by = text_in(message, "commandedBy");
    } else if (op == "advertiseServices") {
      for (const json& one : list_in(message, "services"))
        services[text_in(one, "name")] = static_cast<std::uint32_t>(whole_in(one, "id"));
    } else if (op == "advertise") {
      may_read = true;
      for (const json& one : list_in(message, "channels"))
        add({static_cast<std::uint32_t>(whole_in(one, "id")), text_in(one, "topic"), text_in(one, "encoding"),
             text_in(one, "schemaName"), text_in(one, "schema")});
      return true;
    } else if (op == "unadvertise") {
      for (const json& id : list_in(message, "channelIds"))
        std::erase_if(channels, [&](const channel& one) { return id == one.id; });
      return true;
    }
    return false;
  }

  // Of a topic, or of the path of a port; null: there is none.
  const channel* channel_named(std::string_view name) const {
    for (const channel& one : channels)
      if (one.topic == name || path_of(one.topic) == name) return &one;
    return nullptr;
  }

private:
  void add(const channel& one) {
    std::erase_if(channels, [&](const channel& old) { return old.id == one.id; });
    channels.push_back(one);
  }
};

// `cca: trot` is the program trot.
inline std::string program_of(const known_door& door) {
  return door.program.starts_with("cca: ") ? door.program.substr(5) : door.program;
}

}  // namespace cca_door
