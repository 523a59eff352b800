// The functions of a reader of MCAP. reader.hpp includes this, unless they are compiled once
// for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/record/mcap/lz4.hpp>
#include <cca/record/mcap/printable.hpp>
#include <cca/record/mcap/reader.hpp>
#include <cca/record/mcap/zstd.hpp>

namespace cca::recording {

CCA_RECORD_INLINE mcap_reader::mcap_reader(const std::string& name) : file(std::fopen(name.c_str(), "rb")) {
  if (!file) throw std::system_error(errno, std::generic_category(), name);
  std::fseek(file.get(), 0, SEEK_END);
  const long end = std::ftell(file.get());
  size = end < 0 ? 0 : static_cast<std::uint64_t>(end);
  std::array<unsigned char, detail::magic.size()> start{}, last{};
  if (size >= 2 * last.size()) {
    std::fseek(file.get(), -static_cast<long>(last.size()), SEEK_END);
    has_end = std::fread(last.data(), 1, last.size(), file.get()) == last.size() && last == detail::magic;
  }
  std::fseek(file.get(), 0, SEEK_SET);
  const bool is_read = read(start);
  if (std::ferror(file.get())) throw std::system_error(errno, std::generic_category(), name);
  if (size == 0) throw refused(name + " is empty");
  if (!is_read && std::equal(start.begin(), start.begin() + static_cast<long>(size), detail::magic.begin()))
    throw refused(name + " is cut off: it has only " + std::to_string(size) + " bytes");
  if (!is_read || start != detail::magic) throw refused(name + " is not an MCAP file");
}

CCA_RECORD_INLINE bool mcap_reader::next(mcap_message& m) {
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

CCA_RECORD_INLINE bool mcap_reader::stop(const std::string& why) {
  damaged = why + ", before byte " + std::to_string(at);
  return false;
}

CCA_RECORD_INLINE bool mcap_reader::ends(const std::string& why) {
  is_cut = !has_end;
  return stop(why);
}

CCA_RECORD_INLINE bool mcap_reader::read(std::span<unsigned char> to) {
  if (std::fread(to.data(), 1, to.size(), file.get()) != to.size()) return false;
  crc.add(to);
  at += to.size();
  return true;
}

CCA_RECORD_INLINE bool mcap_reader::skip(std::uint64_t bytes) {
  std::array<unsigned char, 4096> block;
  for (; bytes > 0; bytes -= std::min<std::uint64_t>(bytes, block.size()))
    if (!read(std::span(block).first(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, block.size())))))
      return false;
  return true;
}

CCA_RECORD_INLINE bool mcap_reader::takes_from(place here) {
  if (messages_are == place::unknown) messages_are = here;
  return messages_are == here || stop(here == place::chunks ? "a chunk after messages outside of chunks"
                                                            : "a message outside of a chunk");
}

CCA_RECORD_INLINE std::uint64_t mcap_reader::most_of(detail::op code) {
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

CCA_RECORD_INLINE bool mcap_reader::read_record() {
  const std::uint32_t before = crc.value();
  std::array<unsigned char, detail::head_of_record> head{};
  if (!read(head)) return ends("the file ends without the end of its data");
  detail::byte_reader start(head);
  const auto code = code_of_record = static_cast<detail::op>(start.number<std::uint8_t>());
  const auto length = start.number<std::uint64_t>();
  if (code == detail::op{}) return stop("a record without a kind");
  if (code == detail::op::footer) return stop("a footer without the end of the data");
  if (at > size || length > size - at) return ends("the file ends within a record");
  const std::uint64_t most = most_of(code);
  if (most == 0) return skip(length) || ends("the file ends within a record");
  if (length > most)
    return stop("a record of " + std::to_string(length) + " bytes, more than " + std::to_string(most));
  record.resize(static_cast<std::size_t>(length));
  if (!read(record)) return ends("the file ends within a record");
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

CCA_RECORD_INLINE bool mcap_reader::read_chunk() {
  detail::byte_reader r(record);
  r.number<std::uint64_t>();
  r.number<std::uint64_t>();
  const auto length = r.number<std::uint64_t>();
  const auto stated = r.number<std::uint32_t>();
  const std::string method = r.text();
  const detail::byte_view packed = r.block(r.number<std::uint64_t>());
  if (r.is_bad() || length > most_in_chunk) return stop("a chunk that can't be read");
  if (method != "zstd" && method != "lz4" && !method.empty())
    return stop("a chunk compressed with `" + detail::printable(method, 40) +
                "`, which is not read here (rewrite the file with zstd: mcap compress --compression zstd)");
  // No byte of lz4 becomes more than 255, and no block of zstd, which has four bytes, more than 128 KiB.
  if (!method.empty() && length / (method == "lz4" ? 255 : 32'768) > packed.size())
    return stop("a chunk that can't be decompressed");
  if (method.empty()) {
    if (packed.size() != length) return stop("a chunk of another length than stated");
    chunk.assign(packed.begin(), packed.end());
  } else {
    chunk.resize(static_cast<std::size_t>(length));
    if (!(method == "zstd" ? detail::decompress_zstd(packed, chunk) : detail::decompress_lz4(packed, chunk)))
      return stop("a chunk that can't be decompressed");
  }
  if (stated != 0 && stated != detail::crc_of(chunk)) return stop("a chunk with a wrong checksum");
  in_chunk = detail::byte_reader(chunk);
  return true;
}

CCA_RECORD_INLINE bool mcap_reader::adds(std::size_t bytes) {
  defined += bytes + 128;
  return defined <= most_in_definitions || stop("too many channels, schemas or metadata");
}

template <class Map, class Definition>
bool mcap_reader::define(Map& all, std::uint16_t id, Definition one, std::size_t bytes) {
  const auto known = all.find(id);
  if (known != all.end())
    return known->second == one || stop("a channel or a schema that is defined twice, differently");
  all.emplace(id, std::move(one));
  return adds(bytes);
}

CCA_RECORD_INLINE bool mcap_reader::read_definition(detail::op code, detail::byte_view content) {
  if (code != detail::op::schema && code != detail::op::channel && code != detail::op::metadata) return true;
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

CCA_RECORD_INLINE bool mcap_reader::read_message(detail::byte_view content, mcap_message& m) {
  detail::byte_reader r(content);
  m.channel = r.number<std::uint16_t>();
  m.sequence = r.number<std::uint32_t>();
  m.log_time = r.number<std::uint64_t>();
  m.publish_time = r.number<std::uint64_t>();
  m.data = r.rest();
  if (r.is_bad() || !all_channels.contains(m.channel)) return stop("a message that can't be read");
  return true;
}

}  // namespace cca::recording
