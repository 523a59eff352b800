// The channels of a door: those of a recording, and two of the door itself. Who has subscribed to which.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <cca/base/nearest.hpp>
#include <cca/door/network/client.hpp>
#include <cca/door/network/messages_functions.hpp>
#include <cca/record/file/message_sink.hpp>

namespace cca::detail::door_network {

inline constexpr std::uint16_t status_channel = 60001, log_channel = 60002, first_own_channel = 60001;

// Read by the recording's thread: whether a message of that channel is worth a copy.
class wanted_channels {
public:
  bool operator[](std::uint16_t channel) const { return all[channel].load(std::memory_order_relaxed); }
  void set(std::uint16_t channel, bool is_wanted) {
    all[channel].store(is_wanted, std::memory_order_relaxed);
  }

private:
  std::array<std::atomic<bool>, 1 << 16> all{};
};

class shown_channels {
public:
  explicit shown_channels(wanted_channels& of) : wanted(of) {
    add({.id = status_channel, .topic = "/cca/status", .type = "cca.status", .schema = status_schema()});
    add({.id = log_channel, .topic = "/cca/log", .type = "cca.log", .schema = log_schema()});
  }

  std::uint64_t latest = 0;  // ns, the newest time of a message

  std::string advertised() const {
    json channels = json::array();
    for (const std::uint16_t id : order)
      channels.push_back(json_of(all.at(id).info, id >= first_own_channel));
    return written({{"op", "advertise"}, {"channels", std::move(channels)}});
  }
  // A recording that begins again has its channels again. Returns what clients are sent.
  std::vector<std::string> add(const recording::channel_info& info) {
    std::vector<std::string> messages;
    const auto [place, is_new] = all.try_emplace(info.id);
    shown& one = place->second;
    if (is_new) order.push_back(info.id);
    else if (is_same(one.info, info)) return messages;
    else messages.push_back(written({{"op", "unadvertise"}, {"channelIds", {info.id}}}));
    for (const auto& [client, subscription] : std::exchange(one.subscribers, {}))
      client->subscriptions.erase(subscription);
    one.info = info;
    one.last.clear();
    one.listeners = 0;
    wanted.set(info.id, info.is_kept);
    messages.push_back(written(
        {{"op", "advertise"}, {"channels", json::array({json_of(info, info.id >= first_own_channel)})}}));
    return messages;
  }

  void show(std::uint16_t channel, std::uint64_t time, std::string_view data) {
    const auto found = all.find(channel);
    if (found == all.end()) return;
    shown& one = found->second;
    if (one.info.is_kept) one.last.assign(data), one.last_time = time, one.has_last = true;
    for (const auto& [client, subscription] : one.subscribers)
      send(*client, subscription, channel, time, data);
  }
  // The last lines of the log are kept, too: a client sees who has changed what before it came.
  // Refusals have places of their own: so nobody fills the log with them until no change is left in it.
  void log(const std::string& line, bool is_change) {
    const auto is_alike = [&](const log_line& one) { return one.is_change == is_change; };
    if (std::count_if(lines.begin(), lines.end(), is_alike) == (is_change ? 48 : 16))
      lines.erase(std::find_if(lines.begin(), lines.end(), is_alike));
    lines.push_back({latest, line, is_change});
    show(log_channel, latest, line);
  }

  std::optional<std::uint16_t> channel_of(std::string_view topic) const {
    for (const auto& [id, one] : all)
      if (one.info.topic == topic) return id;
    return {};
  }
  // The names of its numbers; none: it is no output.
  std::vector<std::string> axes_of(std::uint16_t channel) const {
    const auto& metadata = all.at(channel).info.metadata;
    const auto found = metadata.find("axes");
    std::istringstream words(found == metadata.end() ? std::string() : found->second);
    return {std::istream_iterator<std::string>(words), {}};
  }
  // ", did you mean `robot.angles.whole`?", or where all are listed.
  std::string near_output(const std::string& wrong) const {
    std::vector<std::string> paths;
    for (const std::uint16_t id : order)
      if (id < first_own_channel) paths.push_back(path_of(all.at(id).info.topic));
    const std::string_view near =
        nearest_path(wrong, std::vector<std::string_view>(paths.begin(), paths.end()));
    return near.empty() ? ", as `cca.describe` lists them" : ", did you mean `" + std::string(near) + "`?";
  }
  // For the door itself, as one more subscription.
  void listen(std::uint16_t channel, bool does) {
    const auto found = all.find(channel);
    if (found == all.end()) return;
    shown& one = found->second;
    one.listeners += does ? 1 : -1;
    wanted.set(channel, one.is_wanted());
  }
  bool is_wanted(std::uint16_t channel) const { return wanted[channel]; }
  // Empty, or why not.
  std::string subscribe(door_client& c, std::uint32_t subscription, std::uint32_t channel, std::size_t most) {
    const auto found = channel <= 0xffff ? all.find(static_cast<std::uint16_t>(channel)) : all.end();
    if (found == all.end()) return "subscribe: there is no channel " + std::to_string(channel);
    shown& one = found->second;
    if (c.subscriptions.contains(subscription))
      return "subscribe: the subscription " + std::to_string(subscription) + " is used already";
    if (c.subscriptions.size() >= most)
      return "subscribe: at most " + std::to_string(most) + " subscriptions";
    if (std::any_of(one.subscribers.begin(), one.subscribers.end(),
                    [&](const auto& s) { return s.first == &c; }))
      return "subscribe: channel " + std::to_string(channel) + " is subscribed already";
    c.subscriptions[subscription] = one.info.id;
    one.subscribers.emplace_back(&c, subscription);
    wanted.set(one.info.id, true);
    if (one.has_last) send(c, subscription, one.info.id, one.last_time, one.last);
    if (one.info.id == log_channel)
      for (const log_line& said : lines) send(c, subscription, log_channel, said.time, said.text);
    return {};
  }
  bool unsubscribe(door_client& c, std::uint32_t subscription) {
    const auto found = c.subscriptions.find(subscription);
    if (found == c.subscriptions.end()) return false;
    shown& one = all.at(found->second);
    std::erase_if(one.subscribers, [&](const auto& s) { return s.first == &c; });
    wanted.set(one.info.id, one.is_wanted());
    c.subscriptions.erase(found);
    return true;
  }
  void forget(door_client& c) {
    while (!c.subscriptions.empty()) unsubscribe(c, c.subscriptions.begin()->first);
  }
  // The last samples of kept channels that a slow client has lost.
  void pay(door_client& c) {
    if (c.out.owed.empty() || !c.out.has_room()) return;
    for (const std::uint16_t channel : std::exchange(c.out.owed, {}))
      for (const auto& [client, subscription] : all.at(channel).subscribers)
        if (client == &c) send(c, subscription, channel, all.at(channel).last_time, all.at(channel).last);
  }

private:
  struct shown {
    recording::channel_info info{};
    std::string last{};
    std::uint64_t last_time = 0;
    bool has_last = false;
    std::vector<std::pair<door_client*, std::uint32_t>> subscribers{};
    int listeners = 0;
    bool is_wanted() const { return info.is_kept || listeners > 0 || !subscribers.empty(); }
  };
  struct log_line {
    std::uint64_t time;
    std::string text;
    bool is_change;
  };
  wanted_channels& wanted;
  std::unordered_map<std::uint16_t, shown> all{};
  std::vector<std::uint16_t> order{};
  std::deque<log_line> lines{};

  static bool is_same(const recording::channel_info& a, const recording::channel_info& b) {
    return a.topic == b.topic && a.type == b.type && a.schema == b.schema && a.metadata == b.metadata &&
           a.is_kept == b.is_kept;
  }
  void send(door_client& c,
            std::uint32_t subscription,
            std::uint16_t channel,
            std::uint64_t time,
            std::string_view data) {
    c.out.sample([this](std::uint16_t of) { return all.at(of).info.is_kept; }, channel, subscription, time,
                 data);
  }
};

}  // namespace cca::detail::door_network
