// Writes a recording again, as other tools do: without chunks, compressed by lz4, with channels where they
// are first needed and metadata at the end; or with other messages.
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <cca/record.hpp>

namespace record_test {

namespace mcap = cca::recording::detail;
using bytes = std::vector<unsigned char>;

// A frame of LZ4, of one block: each four bytes are looked up where they last stood.
inline bytes compressed_by_lz4(mcap::byte_view from) {
  mcap::byte_writer block;
  const auto four = [&](std::size_t i) {
    std::uint32_t all = 0;
    std::memcpy(&all, &from[i], sizeof all);
    return all;
  };
  const auto add_length = [&](std::size_t n) {
    if (n < 15) return;
    for (n -= 15; n >= 255; n -= 255) block.add(std::uint8_t{255});
    block.add(static_cast<std::uint8_t>(n));
  };
  const auto token = [](std::size_t n) { return n < 15 ? n : 15; };
  std::map<std::uint32_t, std::size_t> last;
  std::size_t done = 0, i = 0;
  while (i + 12 < from.size()) {
    const auto [found, is_new] = last.try_emplace(four(i), i);
    const std::size_t at = std::exchange(found->second, i);
    if (is_new || i - at > 65535) {
      ++i;
      continue;
    }
    std::size_t same = 4;
    while (i + same + 5 < from.size() && from[at + same] == from[i + same]) ++same;
    block.add(static_cast<std::uint8_t>(token(i - done) << 4 | token(same - 4)));
    add_length(i - done);
    block.add(from.subspan(done, i - done)).add(static_cast<std::uint16_t>(i - at));
    add_length(same - 4);
    done = i += same;
  }
  block.add(static_cast<std::uint8_t>(token(from.size() - done) << 4));
  add_length(from.size() - done);
  block.add(from.subspan(done));
  mcap::byte_writer frame;
  frame.add(std::uint32_t{0x184D2204}).add(std::uint8_t{0x60}).add(std::uint8_t{0x70}).add(std::uint8_t{0});
  frame.add(static_cast<std::uint32_t>(block.size())).add(block.view()).add(std::uint32_t{0});
  return {frame.view().begin(), frame.view().end()};
}

struct rewriting {
  std::string compression{};  // "none": without chunks; "lz4", "", or any name
  bool lazy = false;          // channels before their first message, metadata at the end, other numbers
  // Changes a message, or leaves it out.
  std::function<bool(const std::string& topic, bytes& data)> change{};
  std::function<bool(const std::string& topic)> keeps{};  // channels
  bool has_schemas = true;
  std::function<void(mcap::text_map& entries)> change_metadata{};
  std::string without{};  // the metadata of this name
};

inline void rewrite(const std::string& from, const std::string& to, const rewriting& how) {
  using mcap::op;
  mcap::byte_writer all, chunk;
  const auto record = [](mcap::byte_writer& into, op code, const mcap::byte_writer& content) {
    into.add(static_cast<std::uint8_t>(code))
        .add(static_cast<std::uint64_t>(content.size()))
        .add(content.view());
  };
  const bool has_chunks = how.compression != "none";
  const auto end_chunk = [&] {
    if (chunk.size() == 0) return;
    const bytes packed = how.compression == "lz4" ? compressed_by_lz4(chunk.view())
                                                  : bytes(chunk.view().begin(), chunk.view().end());
    mcap::byte_writer one;
    one.add(std::uint64_t{0}).add(std::uint64_t{0}).add(static_cast<std::uint64_t>(chunk.size()));
    one.add(mcap::crc_of(chunk.view())).add(how.compression).add(static_cast<std::uint64_t>(packed.size()));
    record(all, op::chunk, one.add(mcap::byte_view(packed)));
    chunk.clear();
  };
  const auto id_of = [&](std::uint16_t id) { return static_cast<std::uint16_t>(how.lazy ? 900 - id : id); };
  const auto define = [&](const cca::recording::mcap_reader& r, std::uint16_t id, mcap::byte_writer& into) {
    const auto& channel = r.channels().at(id);
    const auto& schema = r.schemas().at(channel.schema);
    if (how.has_schemas)
      record(into, op::schema,
             mcap::byte_writer().add(channel.schema).add(schema.name).add(schema.encoding).add(schema.text));
    record(into, op::channel,
           mcap::byte_writer()
               .add(id_of(id))
               .add(static_cast<std::uint16_t>(how.has_schemas ? channel.schema : 0))
               .add(channel.topic)
               .add(channel.encoding)
               .add(channel.metadata));
  };
  const auto put_metadata = [&](const cca::recording::mcap_reader& r) {
    for (auto [name, entries] : r.metadata()) {
      if (name == how.without) continue;
      if (how.change_metadata) how.change_metadata(entries);
      record(all, op::metadata, mcap::byte_writer().add(name).add(entries));
    }
  };
  const auto keeps = [&](const std::string& topic) { return !how.keeps || how.keeps(topic); };

  cca::recording::mcap_reader whole(from);
  for (cca::recording::mcap_message m; whole.next(m);) {}
  all.add(mcap::byte_view(mcap::magic));
  record(all, op::header, mcap::byte_writer().add(std::string_view()).add(std::string_view("a test")));
  if (!how.lazy) {
    put_metadata(whole);
    for (const auto& [id, channel] : whole.channels())
      if (keeps(channel.topic)) define(whole, id, all);
  }
  cca::recording::mcap_reader again(from);
  mcap::byte_writer& messages = has_chunks ? chunk : all;
  std::map<std::uint16_t, bool> is_defined;
  for (cca::recording::mcap_message m; again.next(m);) {
    const std::string& topic = again.channels().at(m.channel).topic;
    bytes data(m.data.begin(), m.data.end());
    if (!keeps(topic) || (how.change && !how.change(topic, data))) continue;
    if (how.lazy && !std::exchange(is_defined[m.channel], true)) define(again, m.channel, messages);
    record(messages, op::message,
           mcap::byte_writer()
               .add(id_of(m.channel))
               .add(m.sequence)
               .add(m.log_time)
               .add(m.publish_time)
               .add(mcap::byte_view(data)));
    if (chunk.size() > 100'000) end_chunk(), is_defined.clear();
  }
  end_chunk();
  if (how.lazy) put_metadata(whole);
  record(all, op::data_end, mcap::byte_writer().add(mcap::crc_of(all.view())));
  record(all, op::footer,
         mcap::byte_writer().add(std::uint64_t{0}).add(std::uint64_t{0}).add(std::uint32_t{0}));
  all.add(mcap::byte_view(mcap::magic));
  std::ofstream(to, std::ios::binary)
      .write(reinterpret_cast<const char*>(all.view().data()), static_cast<std::streamsize>(all.size()));
}

}  // namespace record_test
