// What a recording of a graph contains: frames and events become messages.
//
// - /<path of the port>: a sample (messages/sample_message.hpp)
// - /ros2/<path of the port>: a message of ROS 2 where one fits, for viewers (messages/viewer_message.hpp)
// - /tf, /robot_description: the robot, where the graph says how it looks (shown_body.hpp)
// - /cca/parameters/<component>: its parameters, at the start and where they change
// - /cca/state: the life-cycle
// - /cca/fault: component and reason
// - /cca/mode: of a set of modes: the mode, at the start and where it changes
// - /cca/part: parts that may be stopped: where one is stopped or started
// - /cca/free_running: from which beat on free-running environments ran in a wall-clock run
// - /cca/dropped: of a free-running environment: samples of a port that came in one beat and that no queue
// has
//   room for, between those that are written
// - /cca/late, /cca/skipped: of a deployment: samples that came late, beats that an environment left out
// - /cca/lost: beats that did not fit into the ring
//
// and metadata: `cca.architecture`, `cca.environments`, `cca.modes`, and the notes of the program.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/refused.hpp>
#include <cca/graph/items/deployment.hpp>
#include <cca/record/file/event_ring.hpp>
#include <cca/record/file/message_outlets.hpp>
#include <cca/record/file/role_in_replay.hpp>
#include <cca/record/messages/architecture_text.hpp>
#include <cca/record/messages/parameter_message.hpp>
#include <cca/record/messages/sample_message.hpp>
#include <cca/record/messages/viewer_message.hpp>
#include <cca/record/file/settings.hpp>
#include <cca/record/file/shown_body.hpp>
#include <cca/record/file/topics.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/observers/frame_layout.hpp>

namespace cca::recording::detail {

// "dmp", "dmp.status", "dmp.*" or "*".
inline bool is_in_scope(std::string_view path, std::string_view scope) {
  if (scope.ends_with('*')) scope.remove_suffix(1);
  if (scope.ends_with('.')) scope.remove_suffix(1);
  return scope.empty() || path == scope ||
         (path.starts_with(scope) && path.size() > scope.size() && path[scope.size()] == '.');
}

// `Graph`: a graph, a deployment or a set of modes.
template <class Graph>
class recorded_messages {
  static constexpr int output_count = cca::detail::counts_of<Graph>.output_count;
  static constexpr std::int64_t period = cca::detail::counts_of<Graph>.period;

public:
  // What a recording is of.
  struct contents {
    std::vector<const schema*> parameters{};  // of each node, or null
    std::vector<bool> nodes{}, outputs{};     // those that are recorded in this process
    text_map environments{}, modes{};
  };
  recorded_messages(message_outlets& outlets, const settings& s, const contents& of) : to_all(outlets) {
    std::vector<std::string> unused = s.scopes;
    const std::string text = architecture_text<Graph>();
    if constexpr (AnyDeployment<Graph>) to_all.metadata("cca.places", places_of<Graph>());
    to_all.metadata("cca.architecture", {{"name", std::string(cca::detail::type_name<Graph>())},
                                         {"hash", hash_of_architecture(text)},
                                         {"text", text},
                                         {"ns_a_beat", std::to_string(period)}});
    if (!of.environments.empty()) to_all.metadata("cca.environments", of.environments);
    if (!of.modes.empty()) to_all.metadata("cca.modes", of.modes);
    for (int o = 0; o < output_count; ++o) {
      const std::string path = cca::detail::path_of_output<Graph>(o);
      bool is_wanted = s.scopes.empty();
      for (const std::string& scope : s.scopes)
        if (is_in_scope(path, scope)) {
          is_wanted = true;
          std::erase(unused, scope);
        }
      is_wanted = is_wanted && of.outputs[cca::detail::array_size(o)];
      ports.push_back(
          is_wanted ? port_channel(path, cca::detail::space_of_output<Graph>(o), role_in_replay<Graph>(o))
                    : std::uint16_t{0});
      if (is_wanted && s.viewer_hz > 0) add_view(o, path);
    }
    if (!unused.empty()) throw refused("cca::record: there is no port under `" + unused.front() + "`");
    for (int n = 0; n < static_cast<int>(of.parameters.size()); ++n) {
      const bool is_here = of.nodes[cca::detail::array_size(n)];
      const schema* const type = is_here ? of.parameters[cca::detail::array_size(n)] : nullptr;
      const std::string path = cca::detail::path_of_node<Graph>(n);
      nodes.push_back(type ? to_all.channel(std::string(parameter_topics) + topic_of(path).substr(1),
                                            message_type(path) + "_parameters", parameter_schema(*type), {},
                                            is_kept, event)
                           : std::uint16_t{0});
    }
    state = to_all.channel(state_topic, "cca/msg/state", "int64 beat\nstring state\n", {}, is_kept, event);
    fault = to_all.channel(fault_topic, "cca/msg/fault", "int64 beat\nstring component\nstring reason\n", {},
                           is_kept, event);
    view_period = s.viewer_hz > 0 ? static_cast<std::int64_t>(1e9 / s.viewer_hz) : 0;
    const std::string beats = "int64 beat  # the first\nint64 beats\n", environment = "string environment\n";
    lost = to_all.channel(lost_topic, "cca/msg/lost", has_environments ? beats + environment : beats, {},
                          false, event);
    if (has_environments) {
      late = to_all.channel(late_topic, "cca/msg/late", "int64 beat\n" + environment + "string from\n", {},
                            false, event);
      skipped = to_all.channel(skipped_topic, "cca/msg/skipped", beats + environment, {}, false, event);
    }
    if constexpr (cca::detail::ShowsBody<Graph>)
      if (s.viewer_hz > 0) body.emplace(to_all, cca::detail::space_of_output<Graph>);
    if constexpr (cca::detail::has_free_running<Graph>) {
      freely = to_all.channel(freely_topic, "cca/msg/free_running",
                              "int64 beat  # from which on they ran in a wall-clock run\n"
                              "bool freely  # false: or in a fast run again\n",
                              {}, false, event);
      dropped = to_all.channel(dropped_topic, "cca/msg/dropped", "int64 beat\nint64 samples\nstring port\n",
                               {}, false, event);
    }
    if (!of.modes.empty())
      mode = to_all.channel(mode_topic, "cca/msg/mode",
                            "int64 beat  # from which on it is active\nstring mode\n"
                            "bool requested  # by a component\n",
                            {}, is_kept, event);
    if (cca::detail::counts_of<Graph>.part_count > 0)
      part = to_all.channel(part_topic, "cca/msg/part",
                            "int64 beat  # from which on it rests, or runs again\nstring part\n"
                            "bool stopped\nbool requested  # by a component\n",
                            {}, false, event);
  }

  void note(const std::string& name, const text_map& entries) { to_all.metadata(name, entries); }

  // A frame of one loop.
  template <class Layout>
  void write(const std::int64_t* frame, const Layout& layout) {
    const std::int64_t k = frame[0];
    for (int o = 0; o < output_count; ++o) {
      const std::size_t at = cca::detail::array_size(o);
      if (ports[at] == 0 || layout.origin[at] < 0) continue;
      if (layout.earlier[at] > 0) write_earlier(o, frame + layout.earlier[at], layout.size[at], k);
      if (const std::int64_t origin = frame[layout.origin[at]]; origin != never)
        write_sample(o, origin, frame + layout.at[at], layout.size[at], k);
    }
    if (body) body->write(to_all, frame, layout, k * period, view_period);
    for (view& v : views) {
      const std::size_t at = cca::detail::array_size(v.output);
      if (layout.origin[at] < 0 || k * period < v.next) continue;
      const std::int64_t origin = frame[layout.origin[at]];
      if (origin == never) continue;
      v.next = k * period + view_period;
      double sample[most_coordinates];
      std::memcpy(sample, frame + layout.at[at], 8u * static_cast<std::size_t>(layout.size[at]));
      to_all.message(v.channel, time_of(k), origin < 0 ? time_of(k) : static_cast<std::uint64_t>(origin),
                     v.message.made_of(sample, origin));
    }
  }

  void write(const event& e, std::span<const unsigned char> payload) {
    const std::uint16_t channel = e.kind == event_kind::parameters ? nodes[cca::detail::array_size(e.node)]
                                  : e.kind == event_kind::state    ? state
                                  : e.kind == event_kind::fault    ? fault
                                  : e.kind == event_kind::mode     ? mode
                                  : e.kind == event_kind::part     ? part
                                  : e.kind == event_kind::freely   ? freely
                                  : e.kind == event_kind::late     ? late
                                                                   : skipped;
    to_all.message(channel, time_of(e.beat), time_of(e.beat), payload);
  }

  // Beats that are missing, of an environment.
  void write_lost(std::int64_t first, std::int64_t beats, std::string_view environment) {
    unsigned char memory[256];
    cdr_writer to(memory);
    to.add(first).add(beats);
    if (has_environments) to.add(environment.substr(0, 200));
    to_all.message(lost, time_of(first), time_of(first), to.view());
  }

  void flush() { to_all.flush(); }

private:
  static constexpr bool is_kept = true;  // the last message, for who comes later
  static constexpr replay_role event = replay_role::event;

  static std::uint64_t time_of(std::int64_t k) { return static_cast<std::uint64_t>(k * period); }
  std::uint16_t port_channel(const std::string& path,
                             const cca::detail::space_info& space,
                             replay_role role) {
    return to_all.channel(topic_of(path), message_type(space.name), sample_schema(space),
                          sample_metadata(space), false, role);
  }
  void write_sample(int o, std::int64_t origin, const std::int64_t* coordinates, int size, std::int64_t k) {
    message.clear();
    message.add(std::uint32_t{0x0100}).add(k).add(origin);
    message.add_raw(coordinates, 8u * static_cast<std::size_t>(size));
    to_all.message(ports[cca::detail::array_size(o)], time_of(k),
                   origin < 0 ? time_of(k) : static_cast<std::uint64_t>(origin), message.view());
  }
  // Of a free-running environment, in the same beat.
  void write_earlier(int o, const std::int64_t* earlier, int size, std::int64_t k) {
    const std::int64_t* const end = earlier + 2 + earlier[0] * (1 + size);
    for (const std::int64_t* one = earlier + 2; one < end; one += 1 + size)
      write_sample(o, one[0], one + 1, size, k);
    if (earlier[1] == 0) return;
    unsigned char memory[512];
    cdr_writer to(memory);
    to.add(k).add(earlier[1]).add(std::string_view(cca::detail::path_of_output<Graph>(o)).substr(0, 400));
    to_all.message(dropped, time_of(k), time_of(k), to.view());
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
    for (const int size : cca::detail::frame_layout_of<Graph>.size) most = size > most ? size : most;
    return most;
  }();
  void add_view(int output, const std::string& path) {
    viewer_message view_of(cca::detail::space_of_output<Graph>(output));
    if (!view_of.fits()) return;
    const std::uint16_t channel =
        to_all.channel(std::string(viewer_topics) + topic_of(path), view_of.type(), view_of.schema());
    views.push_back({output, channel, std::move(view_of)});
  }

  message_outlets& to_all;
  std::optional<std::conditional_t<cca::detail::ShowsBody<Graph>, shown_body<Graph>, no_body>> body;
  std::vector<std::uint16_t> ports, nodes;  // channels; 0: not recorded
  std::vector<view> views;
  std::int64_t view_period = 0;
  static constexpr bool has_environments = AnyDeployment<Graph>;
  std::uint16_t state = 0, fault = 0, lost = 0, mode = 0, part = 0, freely = 0, late = 0, skipped = 0,
                dropped = 0;
  byte_writer message;
};

}  // namespace cca::recording::detail
