// The items of a replay from the stream of a robot that runs (file/twin_stream.hpp), as its bytes come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/refused.hpp>
#include <cca/record/file/role_in_replay.hpp>
#include <cca/record/file/twin_stream.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/messages/architecture_text.hpp>
#include <cca/record/replay/compared_outputs.hpp>
#include <cca/record/replay/recorded_channels.hpp>
#include <cca/runtime/environments/exchange/cycle_results.hpp>

namespace cca::recording::detail {

template <class Graph>
class twin_items {
  using channels = recorded_channels<Graph>;
  using kind = typename channels::kind;
  static constexpr const auto& layout = cca::detail::frame_layout_of<Graph>;
  static std::size_t at(int n) { return cca::detail::array_size(n); }

public:
  static constexpr const char *called_whole = "the robot's door", *of_there = "robot", *of_here = "twin",
                              *why_missing = "it was lost on the way";

  explicit twin_items(std::string called) : of(std::move(called)) {}

  void add(byte_view bytes) {
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(taken));
    taken = 0;
    waiting.insert(waiting.end(), bytes.begin(), bytes.end());
  }

  // False: the next one has not come yet. Errors: cca::refused, if it is the stream of another architecture,
  // or none.
  bool next(recorded_item& item) {
    for (;;) {
      byte_reader from(byte_view(waiting).subspan(taken));
      const bool has_item = read(from, item);
      if (from.is_bad()) return false;
      taken = waiting.size() - from.size();
      if (has_item) return true;
    }
  }

  const std::string& name() const { return of; }
  bool has(int output) const { return outputs[at(output)].is_known; }
  bool ran_here(int output) const { return has(output); }
  bool node_ran_here(int node) const { return nodes[at(node)]; }
  const std::string* parameter_schema_of(int node) const {
    const auto found = schemas.find(node);
    return found == schemas.end() ? nullptr : &found->second;
  }
  const std::string& damage() const { return none; }
  const std::string& missing_end() const { return none; }

  // Of a port that is computed only the hash is known.
  bool is_same(int o,
               std::int64_t was,
               std::uint32_t hash,
               const std::int64_t* then,
               std::int64_t is,
               const std::int64_t* now,
               std::size_t size) {
    if (!outputs[at(o)].is_hashed) return was == is && std::memcmp(then, now, 8 * size) == 0;
    return was != never && is != never && outputs[at(o)].hash.add(is, now, size) == hash;
  }
  std::string text_of(int o, std::int64_t was, const std::int64_t* then, std::size_t size) const {
    return outputs[at(o)].is_hashed && was != never ? "other bits" : sample_text(was, then, size);
  }

private:
  // Whether it was an item; from.is_bad(): it is not whole yet.
  bool read(byte_reader& from, recorded_item& item) {
    const auto code = from.number<std::uint16_t>();
    if (from.is_bad()) return false;
    if (code == of_beat) {
      const auto beat = from.number<std::int64_t>();
      if (from.is_bad()) return false;
      if (!is_checked) check();
      if (beat < 0 || beat > channels::last_beat) refuse("beat " + std::to_string(beat));
      k = beat;
      return false;
    }
    if (code == of_architecture) {
      const std::string text = from.text();
      if (from.is_bad()) return false;
      const std::string mine = architecture_text<Graph>();
      if (text != mine) throw refused(of + " has another architecture: " + first_difference(mine, text));
      has_architecture = true;
      return false;
    }
    if (code == of_channel) return read_channel(from), false;
    const auto found = by_channel.find(code);
    if (found == by_channel.end()) refuse("channel " + std::to_string(code) + " is not described");
    const use& one = found->second;
    item = {};
    item.beat = k;
    if (one.role == replay_role::event) {
      const byte_view message = from.block(from.number<std::uint32_t>());
      if (from.is_bad()) return false;
      if (one.is.what == kind::none) return false;
      if (!channels::read(message, one.is, item)) refuse("an event can't be read");
      return true;
    }
    recorded_sample& sample = item.sample.emplace();
    sample.output = one.is.number;
    if (one.role == replay_role::computed) {
      sample.hash = from.number<std::uint32_t>();
      return !from.is_bad();
    }
    sample.origin = from.number<std::int64_t>();
    sample.coordinates.resize(static_cast<std::size_t>(layout.size[at(one.is.number)]));
    for (double& c : sample.coordinates) c = from.number<double>();
    constexpr auto most = std::numeric_limits<std::int64_t>::max() / 2;
    if (!from.is_bad() && (sample.origin < -most || sample.origin > most)) refuse("a time that no clock has");
    return !from.is_bad();
  }
  void read_channel(byte_reader& from) {
    const auto id = from.number<std::uint16_t>();
    const auto role = static_cast<replay_role>(from.number<std::uint8_t>());
    const std::string topic = from.text(), schema = from.text();
    if (from.is_bad()) return;
    const auto is = channels::use_of(topic);
    const bool is_port = role == replay_role::fed || role == replay_role::computed;
    if (is_port != (is.what == kind::sample) || (!is_port && role != replay_role::event))
      refuse("the channel " + printable(topic, 60) + " has another role");
    by_channel[id] = {role, is};
    if (is_port) {
      auto& out = outputs[at(is.number)];
      out = {.is_known = true, .is_hashed = role == replay_role::computed, .hash = {}};
      nodes[at(cca::detail::node_of_output<Graph>(is.number))] = true;
    } else if (is.what == kind::parameters) {
      nodes[at(is.number)] = true;
      schemas[is.number] = schema;
    }
  }
  // Before the first beat.
  void check() {
    is_checked = true;
    if (!has_architecture) refuse("it states no architecture");
    for (int o = 0; o < cca::detail::counts_of<Graph>.output_count; ++o)
      if (!has(o) && role_in_replay<Graph>(o) == replay_role::fed && !is_beside_the_beat(o))
        throw refused(of + ": what `" + cca::detail::path_of_output<Graph>(o) +
                      "` sensed is not sent: a program that records only some ports has no twin");
  }
  // As in a recording: an output of a free-running environment that is not read outside of it.
  static bool is_beside_the_beat([[maybe_unused]] int o) {
    if constexpr (cca::detail::has_free_running<Graph>)
      return cca::detail::is_free_node<Graph>(cca::detail::node_of_output<Graph>(o)) &&
             !cca::detail::leaves_freely<Graph>::holds(at(o));
    else return false;
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw refused(of + ": its stream is damaged: " + what);
  }
  static std::string first_difference(std::string_view mine, std::string_view theirs) {
    for (;;) {
      const auto a = mine.substr(0, mine.find('\n')), b = theirs.substr(0, theirs.find('\n'));
      if (a != b || (mine.size() == a.size() && theirs.size() == b.size()))
        return "robot `" + printable(b, 120) + "`, twin `" + std::string(a) + "`";
      mine.remove_prefix(std::min(mine.size(), a.size() + 1));
      theirs.remove_prefix(std::min(theirs.size(), b.size() + 1));
    }
  }

  struct use {
    replay_role role = replay_role::none;
    typename channels::use is{};
  };
  struct known_output {
    bool is_known = false, is_hashed = false;
    port_hash hash{};
  };
  const std::string of, none{};
  std::vector<unsigned char> waiting{};
  std::size_t taken = 0;
  std::map<std::uint16_t, use> by_channel{};
  std::map<int, std::string> schemas{};
  std::array<known_output, cca::detail::array_size(cca::detail::counts_of<Graph>.output_count + 1)> outputs{};
  std::array<bool, cca::detail::array_size(cca::detail::counts_of<Graph>.node_count + 1)> nodes{};
  std::int64_t k = 0;
  bool is_checked = false, has_architecture = false;
};

}  // namespace cca::recording::detail
