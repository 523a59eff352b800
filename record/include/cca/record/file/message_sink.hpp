// Who gets the messages of a recording: a file, a door into the running controller, or both.
#pragma once

#include <cstdint>
#include <string>

#include <cca/record/mcap/bytes.hpp>

namespace cca::recording {

// What a replay does with a channel: nothing; compute it anew; feed it, because a resource node sensed it; or
// repeat what happened between two beats.
enum class replay_role { none, computed, fed, event };

// The number of a channel is that of the recording, from 1 on.
struct channel_info {
  std::uint16_t id = 0;
  std::string topic, type, schema;  // ROS 2's message definition; the messages are CDR
  detail::text_map metadata{};
  // A reader that comes later gets the last message of this channel: states, parameters, what the robot is.
  bool is_kept = false;
  replay_role role = replay_role::none;
};

class message_sink {
public:
  message_sink() = default;
  message_sink(const message_sink&) = delete;
  message_sink& operator=(const message_sink&) = delete;
  virtual ~message_sink() = default;

  // Before its first message. Calls come from one thread at a time.
  virtual void channel(const channel_info& one) = 0;
  // Times in ns of virtual time.
  virtual void message(std::uint16_t channel,
                       std::uint64_t log_time,
                       std::uint64_t publish_time,
                       detail::byte_view data) = 0;
  virtual void metadata(const std::string& name, const detail::text_map& entries) = 0;
  // The writer has nothing more for now: what waits here goes to those who look on.
  virtual void hand_over() {}
  // Regularly: what waits here goes to the disk.
  virtual void flush() {}
};

}  // namespace cca::recording
