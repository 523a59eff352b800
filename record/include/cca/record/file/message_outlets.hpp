// The messages of a recording on their way to all who get them: a file, a door. Who comes later gets the
// channels, the metadata, and the last message of each channel that is kept.
//
// One thread writes messages; any thread adds and removes a sink, which returns when no call to it is left.
#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/record/file/message_sink.hpp>
#include <cca/record/mcap/bytes.hpp>

namespace cca::recording::detail {

class message_outlets {
public:
  std::uint16_t channel(std::string_view topic,
                        std::string_view type,
                        std::string_view schema,
                        const text_map& metadata = {},
                        bool is_kept = false,
                        replay_role role = replay_role::none) {
    const std::scoped_lock lock(guard);
    channels.push_back({{static_cast<std::uint16_t>(channels.size() + 1), std::string(topic),
                         std::string(type), std::string(schema), metadata, is_kept, role}});
    for (message_sink* one : sinks) one->channel(channels.back().info);
    return channels.back().info.id;
  }
  void message(std::uint16_t id, std::uint64_t log_time, std::uint64_t publish_time, byte_view data) {
    const std::scoped_lock lock(guard);
    if (known_channel& of = channels[id - 1u]; of.info.is_kept) {
      of.last.assign(data.begin(), data.end());
      of.log_time = log_time, of.publish_time = publish_time;
    }
    for (message_sink* one : sinks) one->message(id, log_time, publish_time, data);
  }
  void metadata(const std::string& name, const text_map& entries) {
    const std::scoped_lock lock(guard);
    notes.emplace_back(name, entries);
    for (message_sink* one : sinks) one->metadata(name, entries);
  }
  void hand_over() {
    const std::scoped_lock lock(guard);
    for (message_sink* one : sinks) one->hand_over();
  }
  void flush() {
    const std::scoped_lock lock(guard);
    for (message_sink* one : sinks) one->flush();
  }

  void add(message_sink& one) {
    const std::scoped_lock lock(guard);
    for (const auto& [name, entries] : notes) one.metadata(name, entries);
    for (const known_channel& of : channels) one.channel(of.info);
    for (const known_channel& of : channels)
      if (!of.last.empty()) one.message(of.info.id, of.log_time, of.publish_time, of.last);
    sinks.push_back(&one);
  }
  void remove(message_sink& one) {
    const std::scoped_lock lock(guard);
    std::erase(sinks, &one);
  }

private:
  struct known_channel {
    channel_info info;
    std::vector<unsigned char> last{};
    std::uint64_t log_time = 0, publish_time = 0;
  };

  std::mutex guard;
  std::vector<known_channel> channels;
  std::vector<std::pair<std::string, text_map>> notes;
  std::vector<message_sink*> sinks;
};

}  // namespace cca::recording::detail
