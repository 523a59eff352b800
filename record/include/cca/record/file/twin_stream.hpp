// What a twin needs of a robot that runs, as a stream of bytes: what its resource nodes sensed, what happened
// between two beats, and of each sample that its components computed a hash. A twin is the same controller
// elsewhere, which is fed with it and finds the first sample that differs (record/twin.hpp).
//
// An entry begins with two bytes; numbers are little endian:
//
//   0xFFFE       size (4), the text of the architecture
//   0xFFFF       a channel: its number (2), its role (1), size (4) and topic, size (4) and schema of parameters
//   0            a beat (8): all that follows is of this one
//   a channel    fed:       origin (8), coordinates (8 each)
//                computed:  hash (4)
//                event:     size (4), the message of the recording
//
// The hash of a port goes on from sample to sample: once a sample differs, all hashes after it do, but one in
// 2^32 by chance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/record/file/message_sink.hpp>
#include <cca/record/file/topics.hpp>
#include <cca/record/mcap/bytes.hpp>

namespace cca::recording::detail {

inline constexpr std::uint16_t of_beat = 0, of_architecture = 0xFFFE, of_channel = 0xFFFF;

// Of all samples of a port so far: origin and coordinates, with all their bits.
class port_hash {
public:
  template <class Word>
  std::uint32_t add(std::int64_t origin, const Word* coordinates, std::size_t count) {
    static_assert(sizeof(Word) == 8);
    mix(static_cast<std::uint64_t>(origin));
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t bits;
      std::memcpy(&bits, coordinates + i, sizeof bits);
      mix(bits);
    }
    return static_cast<std::uint32_t>(all >> 32);
  }

private:
  // Both steps can be undone, so two states stay different while the same words are added.
  void mix(std::uint64_t word) {
    all = (all ^ word) * 0x9e3779b97f4a7c15;
    all ^= all >> 29;
  }
  std::uint64_t all = 0x9e3779b97f4a7c15;
};

// Makes the stream of a recording's messages.
class twin_writer {
public:
  void metadata(const std::string& name, const text_map& entries) {
    if (name != "cca.architecture") return;
    const auto text = entries.find("text");
    if (text != entries.end()) to.add(of_architecture).add(std::string_view(text->second));
  }
  void channel(const channel_info& one) {
    if (one.role == replay_role::none) return;
    if (channels.size() <= one.id) channels.resize(one.id + std::size_t{1});
    channels[one.id] = {one.role, {}};
    const bool is_of_parameters = one.topic.starts_with(parameter_topics);
    to.add(of_channel).add(one.id).add(static_cast<std::uint8_t>(one.role)).add(std::string_view(one.topic));
    to.add(is_of_parameters ? std::string_view(one.schema) : std::string_view());
  }
  // As message_sink::message.
  void message(std::uint16_t id, byte_view data) {
    constexpr std::size_t head = 4, beat_size = 8, numbers = head + beat_size + 8;
    if (id >= channels.size() || channels[id].role == replay_role::none || data.size() < head + beat_size)
      return;
    std::int64_t beat;
    std::memcpy(&beat, data.data() + head, sizeof beat);
    if (beat != last_beat || !has_beat) to.add(of_beat).add(last_beat = beat), has_beat = true;
    to.add(id);
    if (channels[id].role == replay_role::event) {
      to.add(static_cast<std::uint32_t>(data.size())).add(data);
    } else if (channels[id].role == replay_role::fed) {
      to.add(data.subspan(head + beat_size));
    } else {
      std::int64_t origin;
      std::memcpy(&origin, data.data() + head + beat_size, sizeof origin);
      const auto* const words = reinterpret_cast<const unsigned char(*)[8]>(data.data() + numbers);
      to.add(channels[id].hash.add(origin, words, (data.size() - numbers) / 8));
    }
  }

  // What has been written since the last call.
  byte_view view() const { return to.view(); }
  void clear() { to.clear(); }

private:
  struct known {
    replay_role role = replay_role::none;
    port_hash hash{};
  };
  std::vector<known> channels{};
  byte_writer to{};
  std::int64_t last_beat = 0;
  bool has_beat = false;
};

}  // namespace cca::recording::detail
