// Frames of WebSocket, RFC 6455, for a server without extensions: read from any pieces of bytes, and written.
//
// Why not Beast's stream: docs/decisions/0043-door.md.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace cca::detail::door_network {

enum class frame_kind : unsigned char { more = 0, text = 1, binary = 2, close = 8, ping = 9, pong = 10 };

// With which a connection is closed: RFC 6455, 7.4.1.
enum close_code : std::uint16_t {
  no_fault = 0,
  normal = 1000,
  going_away = 1001,
  wrong_frame = 1002,
  unwelcome = 1008,
  too_large = 1009
};

// Pieces of bytes in, messages out. After a wrong frame it reads nothing more.
class frame_reader {
public:
  explicit frame_reader(std::size_t most_bytes) : most(most_bytes) {}

  // Calls `message(kind, payload)` for each whole message, and for each ping, pong and close; it returns
  // false to read no more. Returns the code with which the connection must be closed, or no_fault.
  template <class Message>
  close_code read(std::string_view piece, Message&& message) {
    if (fault != no_fault) return fault;
    waiting.append(piece);
    std::size_t at = 0;
    while (fault == no_fault) {
      const std::size_t used = frame(at, message);
      if (used == 0) break;
      at += used;
    }
    waiting.erase(0, at);
    return fault;
  }

private:
  std::size_t most;
  std::string waiting{}, parts{};  // bytes of a frame; the first frames of a message
  frame_kind kind_of_parts = frame_kind::more;
  close_code fault = no_fault;

  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(waiting[at]); }
  std::size_t wrong(close_code code) { return fault = code, 0; }

  // The bytes of the frame that begins there; 0: not all are here, or it is wrong.
  template <class Message>
  std::size_t frame(std::size_t at, Message&& message) {
    const std::size_t have = waiting.size() - at;
    if (have < 2) return 0;
    const unsigned first = byte(at), second = byte(at + 1);
    const auto kind = static_cast<frame_kind>(first & 15);
    const bool is_last = (first & 0x80) != 0, is_control = (first & 8) != 0;
    if ((first & 0x70) != 0 || (second & 0x80) == 0) return wrong(wrong_frame);  // an extension; no mask
    if (is_control ? kind > frame_kind::pong || !is_last : kind > frame_kind::binary)
      return wrong(wrong_frame);
    std::uint64_t size = second & 127;
    if (is_control && size > 125) return wrong(wrong_frame);
    const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (have < 2 + more) return 0;
    if (more > 0) size = 0;
    for (std::size_t i = 0; i < more; ++i) size = size << 8 | byte(at + 2 + i);
    if (size > most || (!is_control && parts.size() + size > most))
      return wrong(too_large);  // before it is kept
    const std::size_t head = 2 + more + 4, whole = head + static_cast<std::size_t>(size);
    if (have < whole) return 0;
    for (std::size_t i = head; i < whole; ++i)
      waiting[at + i] = static_cast<char>(byte(at + i) ^ byte(at + head - 4 + (i - head) % 4));
    take(kind, is_last, is_control, std::string_view(waiting).substr(at + head, whole - head), message);
    return whole;
  }

  template <class Message>
  void take(frame_kind kind, bool is_last, bool is_control, std::string_view payload, Message&& message) {
    const bool is_open = kind_of_parts != frame_kind::more;
    if (is_control) return tell(kind, payload, message);
    if ((kind == frame_kind::more) != is_open)
      return void(wrong(wrong_frame));  // a part of nothing, or a message in one
    if (is_last && !is_open) return tell(kind, payload, message);
    if (!is_open) kind_of_parts = kind;
    parts.append(payload);
    if (!is_last) return;
    const std::string all = std::exchange(parts, {});
    tell(std::exchange(kind_of_parts, frame_kind::more), all, message);
  }
  template <class Message>
  void tell(frame_kind kind, std::string_view payload, Message&& message) {
    if (!message(kind, payload)) fault = unwelcome;
  }
};

// The head of an unmasked, whole frame.
inline void add_frame_head(std::string& to, frame_kind kind, std::size_t size) {
  to += static_cast<char>(0x80 | static_cast<unsigned>(kind));
  if (size < 126) {
    to += static_cast<char>(size);
    return;
  }
  const int bytes = size <= 0xffff ? 2 : 8;
  to += static_cast<char>(bytes == 2 ? 126 : 127);
  for (int i = bytes - 1; i >= 0; --i)
    to += static_cast<char>(static_cast<std::uint64_t>(size) >> (8 * i) & 255);
}

inline void add_frame(std::string& to, frame_kind kind, std::string_view payload) {
  add_frame_head(to, kind, payload.size());
  to.append(payload);
}

// SHA-1 of FIPS 180-4: the greeting of WebSocket needs it, and nothing else does.
inline std::array<std::uint32_t, 5> sha1(std::string text) {
  std::array<std::uint32_t, 5> h{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476, 0xc3d2e1f0};
  const std::uint64_t bits = std::uint64_t{text.size()} * 8;
  text += static_cast<char>(0x80);
  while (text.size() % 64 != 56) text += '\0';
  for (int i = 7; i >= 0; --i) text += static_cast<char>(bits >> (8 * i) & 255);
  for (std::size_t block = 0; block < text.size(); block += 64) {
    std::array<std::uint32_t, 80> w{};
    for (std::size_t i = 0; i < 64; ++i)
      w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(text[block + i]);
    for (std::size_t i = 16; i < 80; ++i) w[i] = std::rotl(w[i - 3] ^ w[i - 8] ^ w[i - 14] ^ w[i - 16], 1);
    auto [a, b, c, d, e] = h;
    for (std::size_t i = 0; i < 80; ++i) {
      const std::uint32_t f = i < 20              ? (b & c) | (~b & d)
                              : i < 40 || i >= 60 ? b ^ c ^ d
                                                  : (b & c) | (b & d) | (c & d);
      const std::uint32_t k = i < 20 ? 0x5a827999 : i < 40 ? 0x6ed9eba1 : i < 60 ? 0x8f1bbcdc : 0xca62c1d6;
      const std::uint32_t next = std::rotl(a, 5) + f + e + k + w[i];
      e = d, d = c, c = std::rotl(b, 30), b = a, a = next;
    }
    h[0] += a, h[1] += b, h[2] += c, h[3] += d, h[4] += e;
  }
  return h;
}

// What a server answers to Sec-WebSocket-Key: RFC 6455, 4.2.2.
inline std::string accept_key(std::string_view key) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes, text;
  for (const std::uint32_t word : sha1(std::string(key) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"))
    for (int i = 3; i >= 0; --i) bytes += static_cast<char>(word >> (8 * i) & 255);
  bytes += '\0';  // 20 bytes are six threes and two
  for (std::size_t i = 0; i < 21; i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | static_cast<unsigned char>(bytes[i + k]);
    for (int k = 3; k >= 0; --k) text += letters[three >> (6 * k) & 63];
  }
  text.back() = '=';
  return text;
}

}  // namespace cca::detail::door_network
