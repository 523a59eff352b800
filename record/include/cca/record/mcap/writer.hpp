// Writes an MCAP file: chunked, indexed, compressed, with checksums and a summary.
//
//   mcap_writer file("leg.mcap");
//   const auto angles = file.channel("/leg/angles", "cca/msg/leg_angles", "float64 hip\n");
//   file.message(angles, time, time, bytes);   // ns
//   file.flush();                              // ends the chunk: what is in the file survives a SIGKILL
//   file.close();
//
// Until it is closed the bytes are in leg.mcap.part, and an older leg.mcap stays
// (base/system/output_file.hpp). Without close() the part stays, readable up to its last chunk, or goes if it
// has none.
//
// Errors: std::system_error of open and of write, cca::refused if another program writes this file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/base/system/output_file.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/record/mcap/crc32.hpp>
#include <cca/record/mcap/format.hpp>
#include <cca/record/mcap/zstd.hpp>

namespace cca::recording {

class mcap_writer {
public:
  explicit mcap_writer(const std::string& name,
                       std::size_t bytes_of_chunk = 1 << 20,
                       int compression_level = 1);
  mcap_writer(const mcap_writer&) = delete;
  mcap_writer& operator=(const mcap_writer&) = delete;
  ~mcap_writer();

  // A schema without text is none: then the encoding of its messages says all.
  std::uint16_t channel(std::string_view topic,
                        std::string_view type,
                        std::string_view schema,
                        const detail::text_map& metadata = {});

  // Appends a message to the chunk. Times in ns.
  void message(std::uint16_t id, std::uint64_t log_time, std::uint64_t publish_time, detail::byte_view data);

  void metadata(std::string_view name, const detail::text_map& entries);

  void flush();

  // With the summary. Without it the file is readable up to its last chunk.
  void close();
  // An older file of this name stays.
  void discard() { file.discard(); }

  std::uint64_t bytes() const { return at; }
  const std::string& written_to() const { return file.written_to(); }  // until it is closed

private:
  struct span_of_times {
    std::uint64_t first = 0, last = 0;
    bool is_empty = true;
    void add(std::uint64_t time) {
      first = is_empty ? time : std::min(first, time);
      last = is_empty ? time : std::max(last, time);
      is_empty = false;
    }
  };

  static void add_record(detail::byte_writer& to, detail::op code, detail::byte_view content);

  detail::byte_view summary();

  void put(detail::byte_view bytes);

  output_file file;
  std::size_t most_in_chunk;
  detail::zstd_compressor compressor;
  std::uint64_t at = 0;
  detail::crc32 crc_of_data;
  detail::byte_writer chunk, summary_of_schemas, summary_of_channels, summary_of_chunks, summary_of_metadata,
      ended;
  span_of_times in_chunk, in_file;
  std::vector<std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;  // of the chunk: time and offset
  std::vector<std::uint64_t> counts;                                        // messages of each channel
  std::uint32_t schemas = 0, chunks = 0, metadata_records = 0;
};

}  // namespace cca::recording

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/mcap/writer_functions.hpp>
#endif
