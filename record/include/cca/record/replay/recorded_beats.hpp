// Reads a recording of a graph message by message: samples, and what happened between two beats.
//
// It is read twice. Other tools move channels and metadata to where they are first needed, or to the end, so
// only then it is known what the file has: whether it is of this graph, and which ports were recorded. A file
// that can't be replayed is refused with the reason that comes first: its bytes, then its contents.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
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
#include <cca/record/replay/compared_outputs.hpp>
#include <cca/record/replay/recorded_channels.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>

namespace cca::recording::detail {

template <class Graph>
class recorded_items {
  using channels = recorded_channels<Graph>;
  using channel_use = typename channels::use;
  using use_kind = typename channels::kind;

public:
  static constexpr const char *called_whole = "the recording", *of_there = "recorded", *of_here = "replayed",
                              *why_missing = "another tool has left out or moved messages";

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
  const std::string& name() const { return called; }
  // `was`: the origin that was recorded.
  static bool is_same(int,
                      std::int64_t was,
                      std::uint32_t,
                      const std::int64_t* then,
                      std::int64_t is,
                      const std::int64_t* now,
                      std::size_t size) {
    return was == is && std::memcmp(then, now, 8 * size) == 0;
  }
  static std::string text_of(int, std::int64_t was, const std::int64_t* then, std::size_t size) {
    return sample_text(was, then, size);
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
      if (!channels::read(m.data, found->second, item))
        throw refused(called + ": a message of " + file.channels().at(m.channel).topic + " can't be read");
      if (item.beat > channels::last_beat)
        throw refused(called + ": a message of " + file.channels().at(m.channel).topic + " is of beat " +
                      std::to_string(item.beat) + ", whose time no clock can hold");
      return true;
    }
    return false;
  }

private:
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
    const channel_use use = channels::use_of(channel.topic);
    if (use.what == use_kind::sample) is_recorded[cca::detail::array_size(use.number)] = true;
    if (use.what == use_kind::state) has_states = true;
    if (use.what != use_kind::none && channel.encoding != "cdr")
      throw refused(called + ": the messages of " + channel.topic + " are encoded as `" +
                    printable(channel.encoding, 40) + "`, not as `cdr`: another tool has converted them");
    return use;
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
