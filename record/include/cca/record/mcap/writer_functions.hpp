// The functions of a writer of MCAP. writer.hpp includes this, unless they are compiled once
// for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <cca/record/mcap/writer.hpp>
#include <cca/version.hpp>

namespace cca::recording {

CCA_RECORD_INLINE mcap_writer::mcap_writer(const std::string& name,
                                           std::size_t bytes_of_chunk,
                                           int compression_level)
    : file(name), most_in_chunk(bytes_of_chunk), compressor(compression_level) {
  const std::string library = "cca " + std::to_string(version_major) + '.' + std::to_string(version_minor) +
                              '.' + std::to_string(version_patch);
  detail::byte_writer start;
  start.add(detail::byte_view(detail::magic));
  add_record(start, detail::op::header, detail::byte_writer().add(std::string_view()).add(library).view());
  put(start.view());
}

CCA_RECORD_INLINE mcap_writer::~mcap_writer() {
  if (chunks == 0) file.discard();
}

CCA_RECORD_INLINE std::uint16_t mcap_writer::channel(std::string_view topic,
                                                     std::string_view type,
                                                     std::string_view schema,
                                                     const detail::text_map& metadata) {
  detail::byte_writer both;
  const auto schema_id = static_cast<std::uint16_t>(++schemas);
  add_record(
      both, detail::op::schema,
      detail::byte_writer().add(schema_id).add(type).add(std::string_view("ros2msg")).add(schema).view());
  summary_of_schemas.add(both.view());
  const auto id = static_cast<std::uint16_t>(counts.size() + 1);
  detail::byte_writer one;
  add_record(one, detail::op::channel,
             detail::byte_writer()
                 .add(id)
                 .add(schema_id)
                 .add(topic)
                 .add(std::string_view("cdr"))
                 .add(metadata)
                 .view());
  summary_of_channels.add(one.view());
  put(both.add(one.view()).view());
  counts.push_back(0);
  index.emplace_back();
  return id;
}

CCA_RECORD_INLINE void mcap_writer::message(std::uint16_t id,
                                            std::uint64_t log_time,
                                            std::uint64_t publish_time,
                                            detail::byte_view data) {
  auto& count = counts[id - 1u];
  index[id - 1u].emplace_back(log_time, chunk.size());
  chunk.add(static_cast<std::uint8_t>(detail::op::message))
      .add(static_cast<std::uint64_t>(22 + data.size()))
      .add(id)
      .add(static_cast<std::uint32_t>(count++))
      .add(log_time)
      .add(publish_time)
      .add(data);
  in_chunk.add(log_time);
  if (chunk.size() >= most_in_chunk) flush();
}

CCA_RECORD_INLINE void mcap_writer::metadata(std::string_view name, const detail::text_map& entries) {
  detail::byte_writer one;
  add_record(one, detail::op::metadata, detail::byte_writer().add(name).add(entries).view());
  add_record(summary_of_metadata, detail::op::metadata_index,
             detail::byte_writer().add(at).add(static_cast<std::uint64_t>(one.size())).add(name).view());
  ++metadata_records;
  put(one.view());
}

CCA_RECORD_INLINE void mcap_writer::flush() {
  if (chunk.size() == 0) return;
  const detail::byte_view packed = compressor.compress(chunk.view());
  const std::string_view method = "zstd";
  const std::uint64_t start = at;
  detail::byte_writer body;
  body.add(in_chunk.first)
      .add(in_chunk.last)
      .add(static_cast<std::uint64_t>(chunk.size()))
      .add(detail::crc_of(chunk.view()))
      .add(method)
      .add(static_cast<std::uint64_t>(packed.size()))
      .add(packed);
  detail::byte_writer all;
  add_record(all, detail::op::chunk, body.view());
  const std::uint64_t length = all.size();
  detail::byte_writer offsets;
  for (std::size_t c = 0; c < index.size(); ++c) {
    if (index[c].empty()) continue;
    const auto id = static_cast<std::uint16_t>(c + 1);
    offsets.add(id).add(start + all.size());
    detail::byte_writer entries;
    entries.add(id).add(static_cast<std::uint32_t>(16 * index[c].size()));
    for (const auto& [time, offset] : index[c]) entries.add(time).add(offset);
    add_record(all, detail::op::message_index, entries.view());
    index[c].clear();
  }
  add_record(summary_of_chunks, detail::op::chunk_index,
             detail::byte_writer()
                 .add(in_chunk.first)
                 .add(in_chunk.last)
                 .add(start)
                 .add(length)
                 .add(static_cast<std::uint32_t>(offsets.size()))
                 .add(offsets.view())
                 .add(static_cast<std::uint64_t>(all.size() - length))
                 .add(method)
                 .add(static_cast<std::uint64_t>(packed.size()))
                 .add(static_cast<std::uint64_t>(chunk.size()))
                 .view());
  ++chunks;
  in_file.add(in_chunk.first);
  in_file.add(in_chunk.last);
  in_chunk = {};
  chunk.clear();
  put(all.view());
}

CCA_RECORD_INLINE void mcap_writer::close() {
  if (!file.is_open()) return;
  flush();
  const std::uint32_t crc = crc_of_data.value();
  detail::byte_writer end;
  add_record(end, detail::op::data_end, detail::byte_writer().add(crc).view());
  put(end.view());
  put(summary());
  file.keep();
}

CCA_RECORD_INLINE void mcap_writer::add_record(detail::byte_writer& to,
                                               detail::op code,
                                               detail::byte_view content) {
  to.add(static_cast<std::uint8_t>(code)).add(static_cast<std::uint64_t>(content.size())).add(content);
}

CCA_RECORD_INLINE detail::byte_view mcap_writer::summary() {
  detail::byte_writer numbers;
  std::uint64_t messages = 0;
  for (std::size_t c = 0; c < counts.size(); ++c) {
    numbers.add(static_cast<std::uint16_t>(c + 1)).add(counts[c]);
    messages += counts[c];
  }
  detail::byte_writer statistics;
  add_record(statistics, detail::op::statistics,
             detail::byte_writer()
                 .add(messages)
                 .add(static_cast<std::uint16_t>(schemas))
                 .add(static_cast<std::uint32_t>(counts.size()))
                 .add(std::uint32_t{0})
                 .add(metadata_records)
                 .add(chunks)
                 .add(in_file.first)
                 .add(in_file.last)
                 .add(static_cast<std::uint32_t>(numbers.size()))
                 .add(numbers.view())
                 .view());
  const std::uint64_t start = at;
  ended.clear();
  detail::byte_writer groups;
  const auto add_group = [&](detail::op code, const detail::byte_writer& group) {
    if (group.size() == 0) return;
    add_record(groups, detail::op::summary_offset,
               detail::byte_writer()
                   .add(static_cast<std::uint8_t>(code))
                   .add(start + ended.size())
                   .add(static_cast<std::uint64_t>(group.size()))
                   .view());
    ended.add(group.view());
  };
  add_group(detail::op::schema, summary_of_schemas);
  add_group(detail::op::channel, summary_of_channels);
  add_group(detail::op::statistics, statistics);
  add_group(detail::op::metadata_index, summary_of_metadata);
  add_group(detail::op::chunk_index, summary_of_chunks);
  const std::uint64_t start_of_offsets = start + ended.size();
  ended.add(groups.view())
      .add(static_cast<std::uint8_t>(detail::op::footer))
      .add(std::uint64_t{20})
      .add(start)
      .add(start_of_offsets);
  const std::uint32_t crc = detail::crc_of(ended.view());
  ended.add(crc).add(detail::byte_view(detail::magic));
  return ended.view();
}

CCA_RECORD_INLINE void mcap_writer::put(detail::byte_view bytes) {
  crc_of_data.add(bytes);
  at += bytes.size();
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace cca::recording
