// Reads a recording of a graph beat by beat: the samples as a frame, and what happened before the beat.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/record/mcap/reader.hpp>
#include <cca/record/recording_file.hpp>
#include <cca/runtime/transports/manifest.hpp>

namespace cca::recording::detail {

// One message of a recording.
struct recorded_sample {
  int output = 0;
  std::int64_t origin = 0;
  std::vector<double> coordinates{};
};
struct recorded_event {
  event_kind kind{};
  int node = -1;            // parameters
  std::string text{};       // the state, the mode, the reason of a fault, the environment
  std::string component{};  // of a fault; of late samples the environment that they come from
  bool requested = false;   // a mode, by a component
  std::vector<unsigned char> parameters{};
};
struct recorded_item {
  std::int64_t beat = 0;
  std::optional<recorded_sample> sample{};
  std::optional<recorded_event> event{};
  std::int64_t lost = 0;  // beats
};

template <class Graph>
class recorded_items {
public:
  explicit recorded_items(const std::string& name) : file(name), called(name) {}

  // Whether an output was recorded; known after the first item.
  bool has(int output) const { return is_recorded[cca::detail::array_size(output)]; }
  const std::string& damage() const { return file.damage(); }

  bool next(recorded_item& item) {
    for (mcap_message m; file.next(m);) {
      if (!is_checked) check();
      const auto found = by_channel.find(m.channel);
      const channel_use use = found != by_channel.end() ? found->second : use_of(m.channel);
      if (use.what == use_kind::none) continue;
      if (!read(m, use, item))
        throw refused(called + ": a message of " + file.channels().at(m.channel).topic + " can't be read");
      return true;
    }
    if (!is_checked) check();
    return false;
  }

private:
  enum class use_kind { none, sample, parameters, state, fault, lost, mode, late, skipped };
  struct channel_use {
    use_kind what = use_kind::none;
    int number = 0;  // of the output, of the node
  };

  void check() {
    is_checked = true;
    const std::string here = architecture_text<Graph>();
    for (const auto& [name, entries] : file.metadata())
      if (name == "cca.architecture") {
        const auto text = entries.find("text");
        if (text != entries.end() && text->second == here) {
          for (const auto& [id, channel] : file.channels()) use_of(id);
          return;
        }
        throw refused(called + " is the recording of another architecture: " +
                      cca::detail::first_difference(here, text == entries.end() ? "" : text->second));
      }
    throw refused(called + " is not a recording of cca: it states no architecture");
  }

  channel_use use_of(std::uint16_t id) {
    channel_use use;
    const std::string& topic = file.channels().at(id).topic;
    for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
      if (topic == topic_of(cca::detail::path_of_output<Graph>(o))) {
        use = {use_kind::sample, o};
        is_recorded[cca::detail::array_size(o)] = true;
      }
    for (int n = 0; n < cca::detail::counts_of<Graph>.node_count; ++n)
      if (topic == std::string(parameter_topics) + topic_of(cca::detail::path_of_node<Graph>(n)).substr(1))
        use = {use_kind::parameters, n};
    if (topic == state_topic) use.what = use_kind::state;
    if (topic == fault_topic) use.what = use_kind::fault;
    if (topic == lost_topic) use.what = use_kind::lost;
    if (topic == mode_topic) use.what = use_kind::mode;
    if (topic == late_topic) use.what = use_kind::late;
    if (topic == skipped_topic) use.what = use_kind::skipped;
    return by_channel[id] = use;
  }

  static bool read(const mcap_message& m, channel_use use, recorded_item& item) {
    cdr_reader from(m.data);
    item = {};
    item.beat = from.number<std::int64_t>();
    if (item.beat < 0) return false;
    if (use.what == use_kind::sample) {
      recorded_sample& s = item.sample.emplace();
      s.output = use.number;
      s.origin = from.number<std::int64_t>();
      s.coordinates.resize(array_size_of(use.number));
      for (double& c : s.coordinates) c = from.number<double>();
      return from.is_at_end() && s.origin != never;
    }
    if (use.what == use_kind::lost) {
      item.lost = from.number<std::int64_t>();
      if constexpr (Deployment<Graph>) from.text();
      return from.is_at_end();
    }
    recorded_event& e = item.event.emplace();
    if (use.what == use_kind::parameters) {
      e.kind = event_kind::parameters;
      e.node = use.number;
      e.parameters.assign(m.data.begin(), m.data.end());
      return !from.is_bad();
    }
    e.kind = use.what == use_kind::state   ? event_kind::state
             : use.what == use_kind::fault ? event_kind::fault
             : use.what == use_kind::mode  ? event_kind::mode
             : use.what == use_kind::late  ? event_kind::late
                                           : event_kind::skipped;
    if (e.kind == event_kind::skipped) from.number<std::int64_t>();
    if (e.kind == event_kind::fault) e.component = from.text();
    e.text = from.text();
    if (e.kind == event_kind::late) e.component = from.text();
    if (e.kind == event_kind::mode) e.requested = from.number<std::uint8_t>() != 0;
    return from.is_at_end();
  }
  static std::size_t array_size_of(int output) {
    return static_cast<std::size_t>(
        cca::detail::frame_layout_of<Graph>.size[cca::detail::array_size(output)]);
  }

  mcap_reader file;
  std::string called;
  std::map<std::uint16_t, channel_use> by_channel;
  std::array<bool, cca::detail::array_size(cca::detail::counts_of<Graph>.output_count + 1)> is_recorded{};
  bool is_checked = false;
};

}  // namespace cca::recording::detail
