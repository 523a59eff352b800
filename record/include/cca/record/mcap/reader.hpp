// Reads an MCAP file from its beginning, one chunk in memory at a time. It needs no summary: a file that was
// cut off, by SIGKILL or a full disk, is read up to its last whole chunk.
//
//   mcap_reader file("leg.mcap");
//   for (mcap_message m; file.next(m);) ...
//   if (!file.damage().empty()) ...            // where and why it ended early
//
// It reads what mcap_writer writes: messages stand in chunks. Any bytes may come: lengths are compared with
// what is there, and checksums are checked. Errors: std::system_error if it can't be opened; cca::refused if
// it does not begin like an MCAP file.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/crc32.hpp>
#include <cca/record/mcap/format.hpp>
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
};
struct mcap_schema {
  std::string name, encoding, text;
};

class mcap_reader {
public:
  explicit mcap_reader(const std::string& name) : file(std::fopen(name.c_str(), "rb")) {
    if (!file) throw std::system_error(errno, std::generic_category(), name);
    std::fseek(file.get(), 0, SEEK_END);
    const long end = std::ftell(file.get());
    size = end < 0 ? 0 : static_cast<std::uint64_t>(end);
    std::fseek(file.get(), 0, SEEK_SET);
    std::vector<unsigned char> start(detail::magic.size());
    if (!read(start) || !std::equal(start.begin(), start.end(), detail::magic.begin()))
      throw refused(name + " is not an MCAP file");
  }

  bool next(mcap_message& m) {
    for (;;) {
      while (in_chunk.size() > 0) {
        const auto code = static_cast<detail::op>(in_chunk.number<std::uint8_t>());
        const detail::byte_view content = in_chunk.block(in_chunk.number<std::uint64_t>());
        if (in_chunk.is_bad()) return stop("a record that does not fit into its chunk");
        if (code == detail::op::message) {
          if (read_message(content, m)) return true;
          return false;
        }
        if (!read_definition(code, content)) return false;
      }
      if (is_over || !damaged.empty() || !read_record()) return false;
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
  static constexpr std::uint64_t most_in_chunk = 1u << 28;

  bool stop(const std::string& why) {
    damaged = why + ", before byte " + std::to_string(at);
    return false;
  }
  bool read(std::vector<unsigned char>& to) {
    if (std::fread(to.data(), 1, to.size(), file.get()) != to.size()) return false;
    crc.add(to);
    at += to.size();
    return true;
  }

  bool read_record() {
    const std::uint32_t before = crc.value();
    std::vector<unsigned char> head(detail::head_of_record);
    if (!read(head)) return stop("the file ends without the end of its data");
    detail::byte_reader start(head);
    const auto code = static_cast<detail::op>(start.number<std::uint8_t>());
    const auto length = start.number<std::uint64_t>();
    if (length > size - at) return stop("the file ends within a record");
    record.resize(static_cast<std::size_t>(length));
    if (!read(record)) return stop("the file ends within a record");
    switch (code) {
      case detail::op::chunk:
        return read_chunk();
      case detail::op::message:
        return stop("a message outside of a chunk, without a checksum");
      case detail::op::metadata: {
        detail::byte_reader r(record);
        std::string name = r.text();
        all_metadata.emplace_back(std::move(name), r.texts());
        return !r.is_bad() || stop("metadata that can't be read");
      }
      case detail::op::data_end: {
        detail::byte_reader r(record);
        const auto stated = r.number<std::uint32_t>();
        if (r.is_bad() || (stated != 0 && stated != before)) return stop("a wrong checksum of all data");
        is_over = true;
        return true;
      }
      case detail::op::footer:
        return stop("a footer without the end of the data");
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
    if (method.empty() && packed.size() == length) chunk.assign(packed.begin(), packed.end());
    else if (method == "zstd") {
      chunk.resize(static_cast<std::size_t>(length));
      if (!detail::decompress_zstd(packed, chunk)) return stop("a chunk that can't be decompressed");
    } else return stop("a chunk with the compression `" + method + "`");
    if (stated != 0 && stated != detail::crc_of(chunk)) return stop("a chunk with a wrong checksum");
    in_chunk = detail::byte_reader(chunk);
    return true;
  }

  bool read_definition(detail::op code, detail::byte_view content) {
    detail::byte_reader r(content);
    if (code == detail::op::schema) {
      const auto id = r.number<std::uint16_t>();
      mcap_schema one{r.text(), r.text(), r.text()};
      if (r.is_bad() || id == 0) return stop("a schema that can't be read");
      all_schemas[id] = std::move(one);
    } else if (code == detail::op::channel) {
      const auto id = r.number<std::uint16_t>();
      mcap_channel one;
      one.schema = r.number<std::uint16_t>();
      one.topic = r.text();
      one.encoding = r.text();
      one.metadata = r.texts();
      if (r.is_bad()) return stop("a channel that can't be read");
      all_channels[id] = std::move(one);
    }
    return true;
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
  bool is_over = false;
};

}  // namespace cca::recording
