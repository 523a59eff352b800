// What a client of a door is sent, in unmasked frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <cca/door/network/hub_functions.hpp>

#include "must.hpp"

namespace fuzz {

template <class>
inline bool has_read_long = false;

// take(kind, payload) of each frame that waits: they are whole, and of samples and JSON.
template <class Take>
void read_frames(cca::detail::door_network::door_client& c, Take take) {
  namespace net = cca::detail::door_network;
  std::string bytes;
  while (c.out.take(bytes))
    for (std::size_t at = 0; at < bytes.size();) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes.at(i)); };
      std::size_t size = byte(at + 1), head = 2;
      must(size < 128);
      if (size >= 126) {
        head = size == 126 ? 4 : 10;
        size = 0;
        for (std::size_t i = 2; i < head; ++i) size = size << 8 | byte(at + i);
      }
      const std::string_view payload = std::string_view(bytes).substr(at + head, size);
      must(payload.size() == size);
      // What is long is said to each who comes: once is enough.
      if (byte(at) == 0x81 && (size < 4096 || !has_read_long<Take>)) {
        must(net::json::accept(payload));
        has_read_long<Take> = has_read_long<Take> || size >= 4096;
      }
      if (byte(at) == 0x82 && payload[0] == net::op_of_batch)
        for (std::size_t i = 1; i < payload.size();) {
          must(payload.size() - i >= 16);
          std::uint32_t length;
          std::memcpy(&length, payload.data() + i + 12, 4);
          must(payload.size() - i - 16 >= length);
          i += 16 + length;
        }
      if (byte(at) == 0x82 && payload[0] == 3) must(net::json::accept(payload.substr(17)));
      take(byte(at) & 15, payload);
      at += head + size;
    }
}

// What reached the controller is within the ranges that its door knows.
inline void must_be_within(const cca::detail::door_request& one) {
  using about = cca::detail::door_request::what;
  must(one.about != about::step || (one.number >= 1 && one.number <= 1e6));
  must(one.about != about::speed || (one.number >= 0 && one.number <= 1000));
  if (one.about == about::save || one.about == about::record || one.about == about::load)
    must(!one.text.starts_with("/") && ("/" + one.text + "/").find("/../") == std::string::npos);
  for (const auto& [name, value] : one.values) {
    if (one.about == about::call && name == "force") must(value.number >= -50 && value.number <= 50);
    if (one.about != about::set) continue;
    if (name == "gait.frequency") must(value.number >= 0.1 && value.number <= 5);
    if (name == "gait.gains") must(value.numbers.size() == 3);
    if (name.ends_with(".amplitude")) must(value.number >= -0.5 && value.number <= 0.5);
    if (name.ends_with(".duration")) must(value.number >= 1e-3 && value.number <= 600);
  }
}

}  // namespace fuzz
