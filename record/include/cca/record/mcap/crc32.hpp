// The checksum of MCAP: CRC-32 of IEEE 802.3, as in zlib, eight bytes at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cca::recording::detail {

inline constexpr auto crc_tables = [] {
  std::array<std::array<std::uint32_t, 256>, 8> all{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320u ^ crc >> 1 : crc >> 1;
    all[0][byte] = crc;
  }
  for (std::size_t t = 1; t < 8; ++t)
    for (std::size_t byte = 0; byte < 256; ++byte)
      all[t][byte] = all[t - 1][byte] >> 8 ^ all[0][all[t - 1][byte] & 0xff];
  return all;
}();

// Of one piece after the other.
class crc32 {
public:
  constexpr void add(std::span<const unsigned char> bytes) {
    const auto& t = crc_tables;
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
      const auto word = [&](std::size_t from) {
        return std::uint32_t{bytes[from]} | std::uint32_t{bytes[from + 1]} << 8 |
               std::uint32_t{bytes[from + 2]} << 16 | std::uint32_t{bytes[from + 3]} << 24;
      };
      const std::uint32_t low = state ^ word(i), high = word(i + 4);
      state = t[7][low & 0xff] ^ t[6][low >> 8 & 0xff] ^ t[5][low >> 16 & 0xff] ^ t[4][low >> 24] ^
              t[3][high & 0xff] ^ t[2][high >> 8 & 0xff] ^ t[1][high >> 16 & 0xff] ^ t[0][high >> 24];
    }
    for (; i < bytes.size(); ++i) state = state >> 8 ^ t[0][(state ^ bytes[i]) & 0xff];
  }
  constexpr std::uint32_t value() const { return ~state; }

private:
  std::uint32_t state = 0xffffffffu;
};

constexpr std::uint32_t crc_of(std::span<const unsigned char> bytes) {
  crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace cca::recording::detail
