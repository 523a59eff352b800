// What a door keeps for twins (record/twin.hpp): the stream from the first beat on, the last values of what
// components computed, and the controller as WebAssembly. A client asks for a piece after the other, as for
// an asset of the protocol, so none is lost on the way:
//
//   cca://twin/program?from=N            total size (8), then bytes of the WebAssembly from N on
//   cca://twin/stream?from=N             size so far (8), then bytes of the stream from N on
//   cca://twin/value?channel=C&beat=B    the message of that channel and beat
//
// Memory is bounded: the oldest bytes of the stream go first, and who has not read them can't have a twin. A
// door without twins makes no stream.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/network/outbox.hpp>
#include <cca/record/file/message_sink.hpp>
#include <cca/record/file/twin_stream.hpp>

namespace cca::detail::door_network {

// Bytes by their place since the beginning; at most so many of the newest.
class newest_bytes {
public:
  explicit newest_bytes(std::size_t bytes) : most(bytes) {}

  void add(std::string_view bytes) {
    if (most == 0) return;
    if (blocks.empty() || blocks.back().size() + bytes.size() > std::max(block, bytes.size()))
      blocks.emplace_back().reserve(std::max(block, bytes.size()));
    blocks.back() += bytes;
    held += bytes.size();
    while (held > most && blocks.size() > 1) {
      held -= blocks.front().size();
      gone += blocks.front().size();
      blocks.pop_front();
    }
  }
  std::uint64_t begin() const { return gone; }
  std::uint64_t end() const { return gone + held; }
  // At most `size` from `from` on, which is between begin() and end().
  void copy(std::string& to, std::uint64_t from, std::size_t size) const {
    std::uint64_t at = gone;
    for (const std::string& one : blocks) {
      if (size == 0) return;
      if (from < at + one.size()) {
        const std::string_view piece =
            std::string_view(one).substr(static_cast<std::size_t>(from - at)).substr(0, size);
        to += piece;
        from += piece.size();
        size -= piece.size();
      }
      at += one.size();
    }
  }
  // Each block, the newest first, until one returns true.
  template <class F>
  void each_block(F f) const {
    for (auto one = blocks.rbegin(); one != blocks.rend(); ++one)
      if (f(std::string_view(*one))) return;
  }

private:
  static constexpr std::size_t block = 128 << 10;
  std::size_t most, held = 0;
  std::uint64_t gone = 0;
  std::deque<std::string> blocks{};
};

class kept_for_twins {
public:
  // `most`: bytes of the stream; 0: there are no twins.
  kept_for_twins(std::size_t most, std::string web_assembly)
      : stream(most), values(most > 0 ? values_kept : 0), program(std::move(web_assembly)), is_on(most > 0) {}

  // ---- the thread that records ----

  void channel(const recording::channel_info& one) {
    if (!is_on) return;
    const std::scoped_lock lock(guard);
    if (roles.size() <= one.id) roles.resize(one.id + std::size_t{1});
    roles[one.id] = one.role;
    writer.channel(one);
    keep();
  }
  void metadata(const std::string& name, const recording::detail::text_map& entries) {
    if (!is_on) return;
    const std::scoped_lock lock(guard);
    writer.metadata(name, entries);
    keep();
  }
  void message(std::uint16_t channel, recording::detail::byte_view data) {
    if (!is_on || channel >= roles.size() || roles[channel] == recording::replay_role::none) return;
    const std::scoped_lock lock(guard);
    writer.message(channel, data);
    keep();
    if (roles[channel] != recording::replay_role::computed) return;
    entry.clear();
    add_number(entry, channel);
    add_number(entry, static_cast<std::uint32_t>(data.size()));
    entry.append(reinterpret_cast<const char*>(data.data()), data.size());
    values.add(entry);
  }

  // ---- the thread of the door ----

  // The binary message that answers the request for an asset: its number, a state, a reason or the data.
  std::string answer(std::uint32_t request, std::string_view uri) const {
    std::string data, why = read(uri, data);
    std::string message = "\4";
    add_number(message, request);
    message += why.empty() ? '\0' : '\1';
    add_number(message, static_cast<std::uint32_t>(why.size()));
    return message.append(why).append(data);
  }

private:
  static constexpr std::size_t piece = 256 << 10, values_kept = 1 << 20;

  void keep() {
    const auto bytes = writer.view();
    stream.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    writer.clear();
  }
  static std::optional<std::uint64_t> number_in(std::string_view uri, std::string_view name) {
    const auto found = uri.find(name);
    if (found == std::string_view::npos) return {};
    const std::string_view digits = uri.substr(found + name.size());
    std::uint64_t number = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ec != std::errc()) return {};
    return number;
  }
  // Empty, or why not.
  std::string read(std::string_view uri, std::string& to) const {
    if (uri.starts_with("cca://twin/program?")) return read_program(number_in(uri, "?from="), to);
    if (uri.starts_with("cca://twin/stream?")) return read_stream(number_in(uri, "?from="), to);
    if (uri.starts_with("cca://twin/value?"))
      return read_value(number_in(uri, "?channel="), number_in(uri, "&beat="), to);
    return "this door has no such asset: it has cca://twin/program?from=0, cca://twin/stream?from=0 and "
           "cca://twin/value?channel=1&beat=0";
  }
  std::string read_program(std::optional<std::uint64_t> from, std::string& to) const {
    if (program.empty())
      return "the program was started without its twin: give it the file, by --twin FILE.wasm or "
             "door_settings::twin";
    if (!from || *from > program.size()) return "from: expected a place in the program";
    add_number(to, static_cast<std::uint64_t>(program.size()));
    to.append(std::string_view(program).substr(static_cast<std::size_t>(*from), piece));
    return {};
  }
  std::string read_stream(std::optional<std::uint64_t> from, std::string& to) const {
    if (!is_on)
      return "this door keeps nothing for twins: name one, by --twin FILE.wasm or door_settings::twin, or "
             "state door_settings::twin_memory";
    const std::scoped_lock lock(guard);
    if (!from || *from > stream.end()) return "from: expected a place in the stream";
    if (*from < stream.begin())
      return "too late: this door keeps the last " + std::to_string(stream.end() - stream.begin()) + " of " +
             std::to_string(stream.end()) +
             " bytes of what was sensed, and a twin begins with the first beat. Open it earlier, or begin "
             "the "
             "program anew, with more door_settings::twin_memory";
    add_number(to, stream.end());
    stream.copy(to, *from, piece);
    return {};
  }
  std::string read_value(std::optional<std::uint64_t> channel,
                         std::optional<std::uint64_t> beat,
                         std::string& to) const {
    const std::scoped_lock lock(guard);
    values.each_block([&](std::string_view block) {
      while (!block.empty()) {
        std::uint16_t of;
        std::uint32_t size;
        std::uint64_t k;
        std::memcpy(&of, block.data(), sizeof of);
        std::memcpy(&size, block.data() + sizeof of, sizeof size);
        const std::string_view data = block.substr(sizeof of + sizeof size, size);
        std::memcpy(&k, data.data() + 4, sizeof k);
        if (of == channel && k == beat) return to = data, true;
        block.remove_prefix(sizeof of + sizeof size + size);
      }
      return false;
    });
    return to.empty() ? "this value is no longer kept" : "";
  }

  mutable std::mutex guard{};
  newest_bytes stream, values;
  const std::string program;
  const bool is_on;
  recording::detail::twin_writer writer{};
  std::vector<recording::replay_role> roles{};
  std::string entry{};
};

}  // namespace cca::detail::door_network
