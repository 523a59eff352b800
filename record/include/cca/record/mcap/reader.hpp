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
// std::system_error if it can't be opened; cca::refused if it is empty or does not begin like an MCAP file.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/crc32.hpp>
#include <cca/record/mcap/format.hpp>

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
  explicit mcap_reader(const std::string& name);

  bool next(mcap_message& m);

  // Why reading ended before the end of the data; empty: it did not.
  const std::string& damage() const { return damaged; }
  // It ended because the file does: it was cut off. Else its bytes are damaged.
  bool is_cut_off() const { return is_cut; }
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

  bool stop(const std::string& why);
  // At the end of the file. One that has its last bytes was not cut off: a length in it is wrong.
  bool ends(const std::string& why);
  bool read(std::span<unsigned char> to);
  bool skip(std::uint64_t bytes);
  bool takes_from(place here);

  // The bytes of a record of this kind that are read; 0: it is skipped.
  static std::uint64_t most_of(detail::op code);
  bool read_record();

  bool read_chunk();

  // In memory a definition takes more than in the file.
  bool adds(std::size_t bytes);
  // Some tools repeat schemas and channels in each chunk.
  template <class Map, class Definition>
  bool define(Map& all, std::uint16_t id, Definition one, std::size_t bytes);
  bool read_definition(detail::op code, detail::byte_view content);

  bool read_message(detail::byte_view content, mcap_message& m);

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
  bool is_over = false, is_cut = false, has_end = false;
};

}  // namespace cca::recording

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/mcap/reader_functions.hpp>
#endif
