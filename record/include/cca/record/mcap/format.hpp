// The records of an MCAP file, version 0: https://mcap.dev/spec
#pragma once

#include <array>
#include <cstdint>

namespace cca::recording::detail {

inline constexpr std::array<unsigned char, 8> magic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class op : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

inline constexpr std::uint64_t head_of_record = 9;  // bytes: its code and its length

}  // namespace cca::recording::detail
