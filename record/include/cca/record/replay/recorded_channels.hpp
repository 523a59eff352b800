// What the channels of a recording are to a graph, by their topics, and their messages as items of a replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/graph/items/deployment.hpp>
#include <cca/record/file/event_ring.hpp>
#include <cca/record/file/topics.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/messages/cdr.hpp>
#include <cca/record/messages/sample_message.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/observers/frame_layout.hpp>

namespace cca::recording::detail {

// One message of a recording.
struct recorded_sample {
  int output = 0;
  std::int64_t origin = 0;
  std::vector<double> coordinates{};
  std::uint32_t hash = 0;  // of a twin's stream, in the place of the coordinates
};
struct recorded_event {
  event_kind kind{};
  int node = -1;            // parameters
  std::string text{};       // the state, the mode, the part, the reason of a fault, the environment
  std::string component{};  // of a fault; of late samples the environment that they come from
  bool requested = false;   // a mode or a part, by a component
  bool stopped = false;     // a part
  bool freely = false;      // from here on a wall-clock run
  std::vector<unsigned char> parameters{};
};
struct recorded_item {
  std::int64_t beat = 0;
  std::optional<recorded_sample> sample{};
  std::optional<recorded_event> event{};
  std::int64_t lost = 0;     // beats
  std::int64_t dropped = 0;  // samples of this output, in this beat
  int dropped_by = 0;
};

template <class Graph>
struct recorded_channels {
  enum class kind {
    none,
    sample,
    parameters,
    state,
    fault,
    lost,
    mode,
    part,
    freely,
    late,
    skipped,
    dropped
  };
  struct use {
    kind what = kind::none;
    int number = 0;  // of the output, of the node
  };

  static constexpr std::int64_t last_beat =
      std::numeric_limits<std::int64_t>::max() / cca::detail::counts_of<Graph>.period - 1;

  static use use_of(std::string_view topic) {
    for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
      if (topic == topic_of(cca::detail::path_of_output<Graph>(o))) return {kind::sample, o};
    for (int n = 0; n < cca::detail::counts_of<Graph>.node_count; ++n)
      if (topic == std::string(parameter_topics) + topic_of(cca::detail::path_of_node<Graph>(n)).substr(1))
        return {kind::parameters, n};
    if (topic == state_topic) return {kind::state};
    if (topic == fault_topic) return {kind::fault};
    if (topic == lost_topic) return {kind::lost};
    if (topic == mode_topic) return {kind::mode};
    if (topic == part_topic) return {kind::part};
    if (topic == freely_topic) return {kind::freely};
    if (topic == late_topic) return {kind::late};
    if (topic == skipped_topic) return {kind::skipped};
    if (topic == dropped_topic) return {kind::dropped};
    return {};
  }

  static bool read(byte_view data, use of, recorded_item& item) {
    cdr_reader from(data);
    item = {};
    item.beat = from.number<std::int64_t>();
    if (item.beat < 0) return false;
    if (of.what == kind::sample) {
      recorded_sample& s = item.sample.emplace();
      s.output = of.number;
      s.origin = from.number<std::int64_t>();
      s.coordinates.resize(array_size_of(of.number));
      for (double& c : s.coordinates) c = from.number<double>();
      // No clock reaches half of what fits, and ages are differences.
      constexpr auto most = std::numeric_limits<std::int64_t>::max() / 2;
      return from.is_at_end() && s.origin >= -most && s.origin <= most;
    }
    if (of.what == kind::lost) {
      item.lost = from.number<std::int64_t>();
      if constexpr (AnyDeployment<Graph>) from.text();
      return from.is_at_end();
    }
    if (of.what == kind::dropped) {
      item.dropped = from.number<std::int64_t>();
      const std::string path(from.text());
      item.dropped_by = -1;
      for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
        if (path == cca::detail::path_of_output<Graph>(o)) item.dropped_by = o;
      return from.is_at_end() && item.dropped_by >= 0 && item.dropped > 0;
    }
    recorded_event& e = item.event.emplace();
    if (of.what == kind::parameters) {
      e.kind = event_kind::parameters;
      e.node = of.number;
      e.parameters.assign(data.begin(), data.end());
      return !from.is_bad();
    }
    e.kind = of.what == kind::state    ? event_kind::state
             : of.what == kind::fault  ? event_kind::fault
             : of.what == kind::mode   ? event_kind::mode
             : of.what == kind::part   ? event_kind::part
             : of.what == kind::freely ? event_kind::freely
             : of.what == kind::late   ? event_kind::late
                                       : event_kind::skipped;
    if (e.kind == event_kind::freely) {
      e.freely = from.is_at_end() || from.number<std::uint8_t>() != 0;  // older files don't say it
      return from.is_at_end();
    }
    if (e.kind == event_kind::skipped) from.number<std::int64_t>();
    if (e.kind == event_kind::fault) e.component = printable(from.text());
    // A reason is compared with that of a component, so it stays as it is; the others are names.
    e.text = e.kind == event_kind::fault ? std::string(from.text()) : printable(from.text());
    if (e.kind == event_kind::late) e.component = printable(from.text());
    if (e.kind == event_kind::part) e.stopped = from.number<std::uint8_t>() != 0;
    if (e.kind == event_kind::mode || e.kind == event_kind::part)
      e.requested = from.number<std::uint8_t>() != 0;
    return from.is_at_end();
  }
  static std::size_t array_size_of(int output) {
    return static_cast<std::size_t>(
        cca::detail::frame_layout_of<Graph>.size[cca::detail::array_size(output)]);
  }
};

}  // namespace cca::recording::detail
