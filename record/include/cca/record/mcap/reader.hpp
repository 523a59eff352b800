// Reads an MCAP file from its beginning, one chunk in memory at a time. It needs no summary: a file that was
// cut off, by SIGKILL or a full disk, is read up to its last whole chunk.
//
//   mcap_reader file("leg.mcap");
//   for (mcap_message m; file.next(m);) ...
//   if (!file.damage().empty()) ...            // where and why it ended early
//
// It reads what mcap_writer writes, and what other tools make of that: chunks with zstd, lz4 or without
// compression, or messages outside of chunks, which only the checksum of all data covers. Any bytes may come:
// lengths are compared with what is there and with the most that is read, and checksums are compared. Errors:
// std::system_error if it can't be opened; cca::refused if it does not begin like an MCAP file.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/crc32.hpp>
#include <cca/record/mcap/format.hpp>
#include <cca/record/mcap/lz4.hpp>
#include <cca/record/mcap/zstd.hpp>

namespace cca::recording {

struct mcap_message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;  // ns
  detail::byte_view data{};                      // valid until the next call
};
struct mcap_channel {
  std::uint16_t schema = 0;
  std::string topic, encoding;
  detail::text_map metadata;
  bool operator==(const mcap_channel&) const = default;
};
struct mcap_schema {
  std::string name, encoding, text;
  bool operator==(const mcap_schema&) const = default;
};

class mcap_reader {
public:
  explicit mcap_reader(const std::string& name) : file(std::fopen(name.c_str(), "rb")) {
    if (!file) throw std::system_error(errno, std::generic_category(), name);
    std::fseek(file.get(), 0, SEEK_END);
    const long end = std::ftell(file.get());
    size = end < 0 ? 0 : static_cast<std::uint64_t>(end);
    std::fseek(file.get(), 0, SEEK_SET);
    std::array<unsigned char, detail::magic.size()> start{};
    if (!read(start) || start != detail::magic) throw refused(name + " is not an MCAP file");
  }

  bool next(mcap_message& m) {
    for (;;) {
      while (in_chunk.size() > 0) {
        const auto code = static_cast<detail::op>(in_chunk.number<std::uint8_t>());
        const detail::byte_view content = in_chunk.block(in_chunk.number<std::uint64_t>());
        if (in_chunk.is_bad()) return stop("a record that does not fit into its chunk");
        if (code == detail::op::message) return read_message(content, m);
        if (!read_definition(code, content)) return false;
      }
      if (is_over || !damaged.empty() || !read_record()) return false;
      if (code_of_record == detail::op::message) return takes_from(place::records) && read_message(record, m);
    }
  }

  // Why reading ended before the end of the data; empty: it did not.
  const std::string& damage() const { return damaged; }
  bool has_ended() const { return is_over; }

  const std::map<std::uint16_t, mcap_channel>& channels() const { return all_channels; }
  const std::map<std::uint16_t, mcap_schema>& schemas() const { return all_schemas; }
  // In the order of the file.
  const std::vector<std::pair<std::string, detail::text_map>>& metadata() const { return all_metadata; }

private:
  // Larger ones are taken for damage.
  static constexpr std::uint64_t most_in_chunk = 1u << 28, most_in_record = most_in_chunk + (1u << 20),
                                 most_in_definitions = 1u << 24;
  // Where the messages of this file are. No tool writes both, so the other one is damage.
  enum class place { unknown, chunks, records };

  bool stop(const std::string& why) {
    damaged = why + ", before byte " + std::to_string(at);
    return false;
  }
  bool read(std::span<unsigned char> to) {
    if (std::fread(to.data(), 1, to.size(), file.get()) != to.size()) return false;
    crc.add(to);
    at += to.size();
    return true;
  }
  bool skip(std::uint64_t bytes) {
    std::array<unsigned char, 4096> block;
    for (; bytes > 0; bytes -= std::min<std::uint64_t>(bytes, block.size()))
      if (!read(
              std::span(block).first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, block.size())))))
        return false;
    return true;
  }
  bool takes_from(place here) {
    if (messages_are == place::unknown) messages_are = here;
    return messages_are == here || stop(here == place::chunks ? "a chunk after messages outside of chunks"
                                                              : "a message outside of a chunk");
  }

  // The bytes of a record of this kind that are read; 0: it is skipped.
  static std::uint64_t most_of(detail::op code) {
    switch (code) {
      case detail::op::chunk:
      case detail::op::message:
        return most_in_record;
      case detail::op::schema:
      case detail::op::channel:
      case detail::op::metadata:
      case detail::op::data_end:
        return most_in_definitions;
      default:
        return 0;
    }
  }
  bool read_record() {
    const std::uint32_t before = crc.value();
    std::array<unsigned char, detail::head_of_record> head{};
    if (!read(head)) return stop("the file ends without the end of its data");
    detail::byte_reader start(head);
    const auto code = code_of_record = static_cast<detail::op>(start.number<std::uint8_t>());
    const auto length = start.number<std::uint64_t>();
    if (code == detail::op{}) return stop("a record without a kind");
    if (code == detail::op::footer) return stop("a footer without the end of the data");
    if (at > size || length > size - at) return stop("the file ends within a record");
    const std::uint64_t most = most_of(code);
    if (most == 0) return skip(length) || stop("the file ends within a record");
    if (length > most)
      return stop("a record of " + std::to_string(length) + " bytes, more than " + std::to_string(most));
    record.resize(static_cast<std::size_t>(length));
    if (!read(record)) return stop("the file ends within a record");
    switch (code) {
      case detail::op::chunk:
        return takes_from(place::chunks) && read_chunk();
      case detail::op::data_end: {
        detail::byte_reader r(record);
        const auto stated = r.number<std::uint32_t>();
        if (r.is_bad() || (stated != 0 && stated != before)) return stop("a wrong checksum of all data");
        is_over = true;
        return true;
      }
      case detail::op::message:
        return true;
      default:
        return read_definition(code, record);
    }
  }

  bool read_chunk() {
    detail::byte_reader r(record);
    r.number<std::uint64_t>();
    r.number<std::uint64_t>();
    const auto length = r.number<std::uint64_t>();
    const auto stated = r.number<std::uint32_t>();
    const std::string method = r.text();
    const detail::byte_view packed = r.block(r.number<std::uint64_t>());
    if (r.is_bad() || length > most_in_chunk) return stop("a chunk that can't be read");
    if (method != "zstd" && method != "lz4" && !method.empty())
      return stop("a chunk compressed with `" + method.substr(0, 40) +
                  "`, which is not read here (rewrite the file with zstd: mcap compress --compression zstd)");
    // No byte of lz4 becomes more than 255, and no block of zstd, which has four bytes, more than 128 KiB.
    if (!method.empty() && length / (method == "lz4" ? 255 : 32'768) > packed.size())
      return stop("a chunk that can't be decompressed");
    if (method.empty()) {
      if (packed.size() != length) return stop("a chunk of another length than stated");
      chunk.assign(packed.begin(), packed.end());
    } else {
      chunk.resize(static_cast<std::size_t>(length));
      if (!(method == "zstd" ? detail::decompress_zstd(packed, chunk)
                             : detail::decompress_lz4(packed, chunk)))
        return stop("a chunk that can't be decompressed");
    }
    if (stated != 0 && stated != detail::crc_of(chunk)) return stop("a chunk with a wrong checksum");
    in_chunk = detail::byte_reader(chunk);
    return true;
  }

  // In memory a definition takes more than in the file.
  bool adds(std::size_t bytes) {
    defined += bytes + 128;
    return defined <= most_in_definitions || stop("too many channels, schemas or metadata");
  }
  // Some tools repeat schemas and channels in each chunk.
  template <class Map, class Definition>
  bool define(Map& all, std::uint16_t id, Definition one, std::size_t bytes) {
    const auto known = all.find(id);
    if (known != all.end())
      return known->second == one || stop("a channel or a schema that is defined twice, differently");
    all.emplace(id, std::move(one));
    return adds(bytes);
  }
  bool read_definition(detail::op code, detail::byte_view content) {
    if (code != detail::op::schema && code != detail::op::channel && code != detail::op::metadata)
      return true;
    if (content.size() > most_in_definitions) return stop("too many channels, schemas or metadata");
    detail::byte_reader r(content);
    if (code == detail::op::metadata) {
      std::string name = r.text();
      all_metadata.emplace_back(std::move(name), r.texts());
      return r.is_bad() ? stop("metadata that can't be read") : adds(content.size());
    }
    const auto id = r.number<std::uint16_t>();
    if (code == detail::op::schema) {
      mcap_schema one{r.text(), r.text(), r.text()};
      if (r.is_bad() || id == 0) return stop("a schema that can't be read");
      return define(all_schemas, id, std::move(one), content.size());
    }
    mcap_channel one;
    one.schema = r.number<std::uint16_t>();
    one.topic = r.text();
    one.encoding = r.text();
    one.metadata = r.texts();
    if (r.is_bad()) return stop("a channel that can't be read");
    return define(all_channels, id, std::move(one), content.size());
  }

  bool read_message(detail::byte_view content, mcap_message& m) {
    detail::byte_reader r(content);
    m.channel = r.number<std::uint16_t>();
    m.sequence = r.number<std::uint32_t>();
    m.log_time = r.number<std::uint64_t>();
    m.publish_time = r.number<std::uint64_t>();
    m.data = r.rest();
    if (r.is_bad() || !all_channels.contains(m.channel)) return stop("a message that can't be read");
    return true;
  }

  struct close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::unique_ptr<std::FILE, close> file;
  std::uint64_t size = 0, at = 0;
  detail::crc32 crc;
  std::vector<unsigned char> record, chunk;
  detail::byte_reader in_chunk{{}};
  std::map<std::uint16_t, mcap_channel> all_channels;
  std::map<std::uint16_t, mcap_schema> all_schemas;
  std::vector<std::pair<std::string, detail::text_map>> all_metadata;
  std::string damaged;
  std::uint64_t defined = 0;  // bytes
  detail::op code_of_record{};
  place messages_are = place::unknown;
  bool is_over = false;
};

}  // namespace cca::recording
