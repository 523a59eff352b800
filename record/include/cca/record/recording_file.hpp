// What a recording of a graph contains, and how it is written: frames and events become messages.
//
//   /<path of the port>           a sample (messages/sample_message.hpp)
//   /ros2/<path of the port>      a message of ROS 2 where one fits, for viewers
//   (messages/viewer_message.hpp) /cca/parameters/<component>   its parameters, at the start and where they
//   change /cca/state                    the life-cycle /cca/fault                    component and reason
//   /cca/lost                     beats that did not fit into the ring
//
// and metadata: `cca.architecture`, and the notes of the program.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/refused.hpp>
#include <cca/record/event_ring.hpp>
#include <cca/record/mcap/writer.hpp>
#include <cca/record/messages/architecture_text.hpp>
#include <cca/record/messages/parameter_message.hpp>
#include <cca/record/messages/sample_message.hpp>
#include <cca/record/messages/viewer_message.hpp>
#include <cca/record/settings.hpp>
#include <cca/runtime/recording/frame_layout.hpp>

namespace cca::recording::detail {

inline constexpr std::string_view state_topic = "/cca/state", fault_topic = "/cca/fault",
                                  lost_topic = "/cca/lost", parameter_topics = "/cca/parameters/",
                                  viewer_topics = "/ros2";

// "dmp", "dmp.status", "dmp.*" or "*".
inline bool is_in_scope(std::string_view path, std::string_view scope) {
  if (scope.ends_with('*')) scope.remove_suffix(1);
  if (scope.ends_with('.')) scope.remove_suffix(1);
  return scope.empty() || path == scope ||
         (path.starts_with(scope) && path.size() > scope.size() && path[scope.size()] == '.');
}

template <class Graph>
std::string path_of_port(int output) {
  const auto& o = cca::detail::plan_of<Graph>.outputs[cca::detail::array_size(output)];
  const auto& call = cca::detail::plan_of<Graph>.calls[cca::detail::array_size(o.call)];
  return cca::detail::path_of_node<Graph>(call.node) + "." + std::string(call.function->outputs[o.port].name);
}
template <class Graph>
const cca::detail::space_info& space_of_port(int output) {
  const auto& o = cca::detail::plan_of<Graph>.outputs[cca::detail::array_size(output)];
  return *cca::detail::plan_of<Graph>.calls[cca::detail::array_size(o.call)].function->outputs[o.port].space;
}

template <class Graph>
class recording_file {
  static constexpr int output_count = cca::detail::counts_of<Graph>.output_count;
  static constexpr std::int64_t period = cca::detail::counts_of<Graph>.period;
  static constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;

public:
  // `parameters`: of each node, or null.
  recording_file(const std::string& name, const settings& s, const std::vector<const schema*>& parameters)
      : file(name, s.chunk_bytes, s.compression_level) {
    std::vector<std::string> unused = s.scopes;
    const std::string text = architecture_text<Graph>();
    file.metadata("cca.architecture", {{"name", std::string(cca::detail::type_name<Graph>())},
                                       {"hash", hash_of_architecture(text)},
                                       {"text", text},
                                       {"ns_a_beat", std::to_string(period)}});
    for (int o = 0; o < output_count; ++o) {
      const std::string path = path_of_port<Graph>(o);
      bool is_wanted = s.scopes.empty();
      for (const std::string& scope : s.scopes)
        if (is_in_scope(path, scope)) {
          is_wanted = true;
          std::erase(unused, scope);
        }
      ports.push_back(is_wanted ? port_channel(path, space_of_port<Graph>(o)) : std::uint16_t{0});
      if (is_wanted && s.viewer_hz > 0) add_view(o, path);
    }
    if (!unused.empty()) throw refused("cca::record: there is no port under `" + unused.front() + "`");
    for (int n = 0; n < static_cast<int>(parameters.size()); ++n) {
      const schema* const type = parameters[cca::detail::array_size(n)];
      const std::string path = cca::detail::path_of_node<Graph>(n);
      nodes.push_back(type ? file.channel(std::string(parameter_topics) + topic_of(path).substr(1),
                                          message_type(path) + "_parameters", parameter_schema(*type))
                           : std::uint16_t{0});
    }
    state = file.channel(state_topic, "cca/msg/state", "int64 beat\nstring state\n");
    fault = file.channel(fault_topic, "cca/msg/fault", "int64 beat\nstring component\nstring reason\n");
    view_period = s.viewer_hz > 0 ? static_cast<std::int64_t>(1e9 / s.viewer_hz) : 0;
    lost = file.channel(lost_topic, "cca/msg/lost", "int64 beat  # the first that is missing\nint64 beats\n");
  }

  void note(const std::string& name, const text_map& entries) { file.metadata(name, entries); }

  void write(const std::int64_t* frame) {
    const std::int64_t k = frame[0];
    if (k > next_beat && next_beat >= 0) write_lost(next_beat, k - next_beat);
    next_beat = k + 1;
    for (int o = 0; o < output_count; ++o) {
      const std::size_t at = cca::detail::array_size(o);
      const std::int64_t origin = frame[1 + o];
      if (ports[at] == 0 || origin == never) continue;
      message.clear();
      message.add(std::uint32_t{0x0100}).add(k).add(origin);
      message.add_raw(frame + layout.at[at], 8u * static_cast<std::size_t>(layout.size[at]));
      file.message(ports[at], time_of(k), origin < 0 ? time_of(k) : static_cast<std::uint64_t>(origin),
                   message.view());
    }
    for (view& v : views) {
      const std::int64_t origin = frame[1 + v.output];
      if (origin == never || k * period < v.next) continue;
      v.next = k * period + view_period;
      double sample[most_coordinates];
      std::memcpy(sample, frame + layout.at[cca::detail::array_size(v.output)],
                  8u * static_cast<std::size_t>(layout.size[cca::detail::array_size(v.output)]));
      file.message(v.channel, time_of(k), origin < 0 ? time_of(k) : static_cast<std::uint64_t>(origin),
                   v.message.made_of(sample, origin));
    }
  }

  void write(const event& e, std::span<const unsigned char> payload) {
    switch (e.kind) {
      case event_kind::parameters:
        return file.message(nodes[cca::detail::array_size(e.node)], time_of(e.beat), time_of(e.beat),
                            payload);
      case event_kind::state:
        return file.message(state, time_of(e.beat), time_of(e.beat), payload);
      case event_kind::fault:
        return file.message(fault, time_of(e.beat), time_of(e.beat), payload);
    }
  }

  // Beats that are missing.
  void write_lost(std::int64_t first, std::int64_t beats) {
    unsigned char memory[64];
    cdr_writer to(memory);
    file.message(lost, time_of(first), time_of(first), to.add(first).add(beats).view());
  }
  // Up to this beat, at the end.
  void write_lost_up_to(std::int64_t end) {
    if (next_beat >= 0 && end > next_beat) write_lost(next_beat, end - next_beat);
    next_beat = end;
  }
  void expect(std::int64_t k) { next_beat = k; }

  void flush() { file.flush(); }
  void close() { file.close(); }
  std::uint64_t bytes() const { return file.bytes(); }

private:
  static std::uint64_t time_of(std::int64_t k) { return static_cast<std::uint64_t>(k * period); }
  std::uint16_t port_channel(const std::string& path, const cca::detail::space_info& space) {
    return file.channel(topic_of(path), message_type(space.name), sample_schema(space),
                        sample_metadata(space));
  }

  // What a viewer draws of an output, at most `viewer_hz` times a second.
  struct view {
    int output;
    std::uint16_t channel;
    viewer_message message;
    std::int64_t next = 0;  // ns
  };
  static constexpr int most_coordinates = [] {
    int most = 1;
    for (const int size : layout.size) most = size > most ? size : most;
    return most;
  }();
  void add_view(int output, const std::string& path) {
    viewer_message view_of(space_of_port<Graph>(output));
    if (!view_of.fits()) return;
    const std::uint16_t channel =
        file.channel(std::string(viewer_topics) + topic_of(path), view_of.type(), view_of.schema());
    views.push_back({output, channel, std::move(view_of)});
  }

  mcap_writer file;
  std::vector<std::uint16_t> ports, nodes;  // channels; 0: not recorded
  std::vector<view> views;
  std::int64_t view_period = 0;
  std::uint16_t state = 0, fault = 0, lost = 0;
  std::int64_t next_beat = -1;
  byte_writer message;
};

}  // namespace cca::recording::detail
