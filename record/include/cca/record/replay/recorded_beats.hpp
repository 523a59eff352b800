// Reads a recording of a graph message by message: samples, and what happened between two beats.
//
// It is read twice. Other tools move channels and metadata to where they are first needed, or to the end, so
// only then it is known what the file has: whether it is of this graph, and which ports were recorded. A file
// that can't be replayed is refused with the reason that comes first: its bytes, then its contents.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/graph/deployment/part.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/mcap/reader.hpp>
#include <cca/record/file/recorded_messages.hpp>
#include <cca/record/replay/architecture_difference.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>

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
class recorded_items {
public:
  explicit recorded_items(const std::string& name) : file(name), called(name) {
    mcap_reader whole(name);
    std::int64_t messages = 0;
    for (mcap_message m; whole.next(m);) ++messages;
    damaged = whole.damage();
    cut_off = whole.is_cut_off();
    for (const auto& note : whole.metadata()) ended = ended || note.first == "cca.end";
    if (messages == 0 && !damaged.empty()) throw refused(called + " can't be read: " + damaged);
    check_architecture(whole);
    find_environments(whole);
    for (const auto& [id, channel] : whole.channels()) {
      by_channel[id] = use_of(channel);
      const auto schema = whole.schemas().find(channel.schema);
      if (by_channel[id].what == use_kind::parameters && schema != whole.schemas().end() &&
          schema->second.encoding == "ros2msg")
        parameter_schemas[by_channel[id].number] = schema->second.text;
    }
    if (!has_states)
      throw refused(
          called + ": the topic " + std::string(state_topic) +
          " is missing, which says when it was loaded and started: keep it when you filter a recording");
    check_ports();
  }

  bool has(int output) const { return is_recorded[cca::detail::array_size(output)]; }
  // Whether the process that recorded it ran the environment of an output.
  bool ran_here(int output) const { return node_ran_here(cca::detail::node_of_output<Graph>(output)); }
  bool node_ran_here([[maybe_unused]] int node) const {
    if constexpr (AnyDeployment<Graph>)
      return is_here[cca::detail::array_size(
          cca::detail::plan_of<Graph>.nodes[cca::detail::array_size(node)].place)];
    else return true;
  }
  // As the file describes the parameters of a component; null: it does not.
  const std::string* parameter_schema_of(int node) const {
    const auto found = parameter_schemas.find(node);
    return found == parameter_schemas.end() ? nullptr : &found->second;
  }
  // Why the file can't be read to its end; empty: it can.
  const std::string& damage() const { return damaged; }
  // Why the recording is not whole; empty: it is. A recorder that is closed says so; what another tool has
  // made of a part does not.
  std::string missing_end() const {
    if (!damaged.empty())
      return (cut_off ? "the recording is cut off: " : "the recording is damaged: ") + damaged;
    return ended ? "" : "the recording does not say that it ended: it is a part of another one";
  }

  bool next(recorded_item& item) {
    for (mcap_message m; file.next(m);) {
      const auto found = by_channel.find(m.channel);
      if (found == by_channel.end() || found->second.what == use_kind::none) continue;
      if (!read(m, found->second, item))
        throw refused(called + ": a message of " + file.channels().at(m.channel).topic + " can't be read");
      if (item.beat > last_beat)
        throw refused(called + ": a message of " + file.channels().at(m.channel).topic + " is of beat " +
                      std::to_string(item.beat) + ", whose time no clock can hold");
      return true;
    }
    return false;
  }

private:
  enum class use_kind {
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
  struct channel_use {
    use_kind what = use_kind::none;
    int number = 0;  // of the output, of the node
  };

  static constexpr std::int64_t last_beat =
      std::numeric_limits<std::int64_t>::max() / cca::detail::counts_of<Graph>.period - 1;

  void check_architecture(const mcap_reader& whole) const {
    for (const auto& [name, entries] : whole.metadata())
      if (name == "cca.architecture") {
        const std::string here = architecture_text<Graph>();
        const auto text = entries.find("text");
        if (text != entries.end() && text->second == here) return;
        spaces_by_hash spaces;
        add_spaces<Graph>(spaces);
        throw refused(called + " is the recording of another architecture: " +
                      architecture_difference(here, text == entries.end() ? std::string() : text->second,
                                              spaces, whole));
      }
    if (!damaged.empty()) throw refused(called + " can't be read to its metadata: " + damaged);
    throw refused(called +
                  " is not a recording of cca: it states no architecture in its metadata, which some tools "
                  "leave out unless they are told to keep it");
  }

  static constexpr int environments = [] {
    if constexpr (AnyDeployment<Graph>) return cca::detail::environment_count<Graph>;
    else return 1;
  }();
  // A file that does not say it has all of them.
  void find_environments([[maybe_unused]] const mcap_reader& whole) {
    is_here.fill(true);
    if constexpr (AnyDeployment<Graph>)
      for (const auto& [name, entries] : whole.metadata())
        if (const auto here = entries.find("here"); name == "cca.environments" && here != entries.end())
          for (std::size_t e = 0; e < is_here.size(); ++e)
            is_here[e] = (" " + here->second + " ")
                             .find(" " + std::string(cca::detail::name_of_environment<Graph>(e)) + " ") !=
                         std::string::npos;
  }

  // All resource nodes were recorded, or nothing can be replayed.
  void check_ports() const {
    using cca::detail::array_size;
    const auto& plan = cca::detail::plan_of<Graph>;
    for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o) {
      const auto& call = plan.calls[array_size(plan.outputs[array_size(o)].call)];
      if (call.phase != cca::detail::phase_of_beat::sense || has(o)) continue;
      if (is_beside_the_beat(o)) continue;
      const std::string what = called + ": what `" + cca::detail::path_of_output<Graph>(o) + "` sensed ";
      if (!damaged.empty()) throw refused(what + "is not in the part that can be read: " + damaged);
      throw refused(what + "was not recorded: record it to replay" +
                    (AnyDeployment<Graph> ? ", with all environments in one process" : ""));
    }
  }

  // An output of a free-running environment that is not read outside of it need not be played.
  static bool is_beside_the_beat([[maybe_unused]] int o) {
    if constexpr (cca::detail::has_free_running<Graph>)
      return cca::detail::is_free_node<Graph>(cca::detail::node_of_output<Graph>(o)) &&
             !cca::detail::leaves_freely<Graph>::holds(cca::detail::array_size(o));
    else return false;
  }

  channel_use use_of(const mcap_channel& channel) {
    channel_use use;
    const std::string& topic = channel.topic;
    for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
      if (topic == topic_of(cca::detail::path_of_output<Graph>(o))) {
        use = {use_kind::sample, o};
        is_recorded[cca::detail::array_size(o)] = true;
      }
    for (int n = 0; n < cca::detail::counts_of<Graph>.node_count; ++n)
      if (topic == std::string(parameter_topics) + topic_of(cca::detail::path_of_node<Graph>(n)).substr(1))
        use = {use_kind::parameters, n};
    if (topic == state_topic) use.what = use_kind::state, has_states = true;
    if (topic == fault_topic) use.what = use_kind::fault;
    if (topic == lost_topic) use.what = use_kind::lost;
    if (topic == mode_topic) use.what = use_kind::mode;
    if (topic == part_topic) use.what = use_kind::part;
    if (topic == freely_topic) use.what = use_kind::freely;
    if (topic == late_topic) use.what = use_kind::late;
    if (topic == skipped_topic) use.what = use_kind::skipped;
    if (topic == dropped_topic) use.what = use_kind::dropped;
    if (use.what != use_kind::none && channel.encoding != "cdr")
      throw refused(called + ": the messages of " + topic + " are encoded as `" +
                    printable(channel.encoding, 40) + "`, not as `cdr`: another tool has converted them");
    return use;
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
      // No clock reaches half of what fits, and ages are differences.
      constexpr auto most = std::numeric_limits<std::int64_t>::max() / 2;
      return from.is_at_end() && s.origin >= -most && s.origin <= most;
    }
    if (use.what == use_kind::lost) {
      item.lost = from.number<std::int64_t>();
      if constexpr (AnyDeployment<Graph>) from.text();
      return from.is_at_end();
    }
    if (use.what == use_kind::dropped) {
      item.dropped = from.number<std::int64_t>();
      const std::string path(from.text());
      item.dropped_by = -1;
      for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
        if (path == cca::detail::path_of_output<Graph>(o)) item.dropped_by = o;
      return from.is_at_end() && item.dropped_by >= 0 && item.dropped > 0;
    }
    recorded_event& e = item.event.emplace();
    if (use.what == use_kind::parameters) {
      e.kind = event_kind::parameters;
      e.node = use.number;
      e.parameters.assign(m.data.begin(), m.data.end());
      return !from.is_bad();
    }
    e.kind = use.what == use_kind::state    ? event_kind::state
             : use.what == use_kind::fault  ? event_kind::fault
             : use.what == use_kind::mode   ? event_kind::mode
             : use.what == use_kind::part   ? event_kind::part
             : use.what == use_kind::freely ? event_kind::freely
             : use.what == use_kind::late   ? event_kind::late
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

  mcap_reader file;
  std::string called, damaged;
  std::map<std::uint16_t, channel_use> by_channel;
  std::map<int, std::string> parameter_schemas;
  std::array<bool, cca::detail::array_size(cca::detail::counts_of<Graph>.output_count + 1)> is_recorded{};
  std::array<bool, cca::detail::array_size(environments)> is_here{};
  bool has_states = false, cut_off = false, ended = false;
};

}  // namespace cca::recording::detail
