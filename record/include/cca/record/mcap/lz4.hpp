// Decompresses frames of LZ4, for files that other tools have written: cca itself writes Zstandard. No
// library is needed, since reading is so little: docs/decisions/0031-lz4.md.
//
// Any bytes may come: what is read and what is written stays within its memory. The checksums within a frame
// are not compared, since the chunk has one of its own. Sources: lz4_Frame_format.md and lz4_Block_format.md
// of github.com/lz4/lz4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <cca/record/mcap/bytes.hpp>

namespace cca::recording::detail {

class lz4_reader {
public:
  lz4_reader(byte_view packed, std::vector<unsigned char>& unpacked) : from(packed), to(unpacked) {}

  // False: it is damaged, or not exactly as long as `to`.
  bool read() {
    while (from.size() > 0)
      if (!read_frame()) return false;
    return done == to.size();
  }

private:
  bool read_frame() {
    const auto start = from.number<std::uint32_t>();
    if (start >> 4 == 0x184D2A5) {  // to be skipped
      from.block(from.number<std::uint32_t>());
      return !from.is_bad();
    }
    const auto flags = from.number<std::uint8_t>();
    from.number<std::uint8_t>();  // the most bytes of a block
    const auto is_set = [&](int bit) { return (flags >> bit & 1) != 0; };
    const bool has_dictionary = is_set(0), is_summed = is_set(2), has_size = is_set(3),
               sums_blocks = is_set(4);
    if (has_size) from.number<std::uint64_t>();
    from.number<std::uint8_t>();  // the checksum of the head
    if (from.is_bad() || start != 0x184D2204 || flags >> 6 != 1 || has_dictionary) return false;
    for (;;) {
      constexpr std::uint32_t is_plain = 1u << 31;
      const auto size = from.number<std::uint32_t>();
      if (from.is_bad()) return false;
      if (size == 0) break;
      const byte_view block = from.block(size & ~is_plain);
      if (from.is_bad() || !((size & is_plain) != 0 ? put(block) : read_block(block))) return false;
      if (sums_blocks) from.number<std::uint32_t>();
    }
    if (is_summed) from.number<std::uint32_t>();
    return !from.is_bad();
  }

  // Literals, and then, but for the last time, a match: a piece of what was written already.
  bool read_block(byte_view block) {
    byte_reader b(block);
    while (b.size() > 0) {
      const auto token = b.number<std::uint8_t>();
      if (!put(b.block(length(b, token >> 4))) || b.is_bad()) return false;
      if (b.size() == 0) break;
      const auto back = b.number<std::uint16_t>();
      const std::uint64_t count = length(b, token & 15) + 4;
      if (b.is_bad() || back == 0 || back > done || count > to.size() - done) return false;
      unsigned char* const at = to.data() + done;
      done += static_cast<std::size_t>(count);
      if (back >= count) {
        std::memcpy(at, at - back, static_cast<std::size_t>(count));
      } else {
        for (std::size_t i = 0; i < count; ++i) at[i] = at[static_cast<std::ptrdiff_t>(i) - back];
      }
    }
    return true;
  }
  // Of four bits; all set: further bytes are added, up to one below 255.
  static std::uint64_t length(byte_reader& b, int bits) {
    auto all = static_cast<std::uint64_t>(bits);
    if (bits < 15) return all;
    for (std::uint8_t more = 255; more == 255 && !b.is_bad(); all += more) more = b.number<std::uint8_t>();
    return all;
  }
  bool put(byte_view bytes) {
    if (bytes.size() > to.size() - done) return false;
    if (!bytes.empty()) std::memcpy(to.data() + done, bytes.data(), bytes.size());
    done += bytes.size();
    return true;
  }

  byte_reader from;
  std::vector<unsigned char>& to;
  std::size_t done = 0;
};

inline bool decompress_lz4(byte_view from, std::vector<unsigned char>& to) {
  return lz4_reader(from, to).read();
}

}  // namespace cca::recording::detail
