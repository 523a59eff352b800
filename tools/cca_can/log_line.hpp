// A line of a log, as `candump -L` writes and `canplayer` reads it.
//
//   (1436509052.249713) vcan0 044#2A366C2BBA        classic; 8 digits are a 29-bit id; `#R`, `#R4`: remote
//   (1436509052.249713) vcan0 12345678##1AABB       FD: a digit of flags (1: BRS; 2: ESI, not kept), then the
//                                                   payload
//
//   (1436509052.249713) vcan0 123#11.22.33          a dot may stand between two bytes
//   (1436509052.249713) vcan0 45123#81:00:12345678#11.22    XL: is marked, and not read further
//
// candump also writes how many frames it lost, which is no frame: "DROPCOUNT: dropped 3 CAN frames ...".
// After the frame there may be R or T (received, sent: candump -x) and _9 to _F (the raw length code of a
// classic frame), which are not kept. Error frames are marked, since they are never sent.
// Source: linux-can/can-utils, lib.h, lib.c and log2asc.c.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include <cca/hardware/bus/can_frame.hpp>

namespace cca_can {

namespace hw = cca::hardware;

struct log_line {
  std::int64_t time = 0;  // ns since 1970; microseconds in the text
  std::string bus;
  hw::can_frame frame{};
  bool error = false;  // an error frame, which is not sent
  bool xl = false;     // a frame of CAN XL, which no bus here sends
  bool has_frame() const { return !error && !xl; }
};

namespace detail {

constexpr int digit_of(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                : -1;
}

inline std::optional<std::uint64_t> number_of(std::string_view text, int base, std::size_t most_digits) {
  if (text.empty() || text.size() > most_digits) return {};
  std::uint64_t n = 0;
  for (const char c : text) {
    const int d = digit_of(c);
    if (d < 0 || d >= base) return {};
    n = n * static_cast<std::uint64_t>(base) + static_cast<std::uint64_t>(d);
  }
  return n;
}

inline std::string_view next_part(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  const std::string_view part = text.substr(0, text.find_first_of(" \t\r"));
  text.remove_prefix(part.size());
  return part;
}

// "45123#81:00:12345678#1122": the virtual network and the priority, or the priority alone; flags, type of
// the payload and acceptance field; then the payload.
inline bool is_xl(std::string_view text) {
  const std::size_t hash = text.find('#');
  if ((hash != 3 && hash != 5) || !number_of(text.substr(0, hash), 16, 5)) return false;
  text.remove_prefix(hash + 1);
  return text.size() > 14 && text[2] == ':' && text[5] == ':' && text[14] == '#' &&
         number_of(text.substr(0, 2), 16, 2) && number_of(text.substr(3, 2), 16, 2) &&
         number_of(text.substr(6, 8), 16, 8);
}

// Reads "2A366C" or "2A.36.6C" into a frame; returns what is wrong with it, or nothing.
inline std::string read_payload(std::string_view text, hw::can_frame& f) {
  const std::size_t most = f.fd ? 64 : 8;
  std::size_t bytes = 0;
  for (; !text.empty(); text.remove_prefix(2)) {
    if (bytes > 0 && text[0] == '.') text.remove_prefix(1);
    if (text.size() < 2) return "a byte has two hexadecimal digits, and one of them is missing";
    const auto byte = number_of(text.substr(0, 2), 16, 2);
    if (!byte) return "`" + std::string(text.substr(0, 2)) + "` is not a byte in hexadecimal digits";
    if (bytes == most) return "a frame of this kind has at most " + std::to_string(most) + " bytes";
    f.data[bytes++] = static_cast<std::uint8_t>(*byte);
  }
  f.length = static_cast<std::uint8_t>(bytes);
  if (!f.valid()) return "an FD frame can't have " + std::to_string(bytes) + " bytes";
  return {};
}

// Reads "044#2A" into a frame; returns what is wrong with it, or nothing.
inline std::string read_frame(std::string_view text, hw::can_frame& f, bool& error) {
  const std::size_t hash = text.find('#');
  if (hash == text.npos) return "a frame is written ID#DATA, and there is no `#` in it";
  const auto id = number_of(text.substr(0, hash), 16, 8);
  if (!id || (hash != 3 && hash != 8)) return "an id has 3 hexadecimal digits, or 8 for 29 bits";
  constexpr std::uint64_t error_flag = 0x20000000;
  error = hash == 8 && (*id & error_flag) != 0;
  if (error) return {};
  f.id = {static_cast<std::uint32_t>(*id), hash == 8};
  if (!f.id.valid())
    return hash == 3 ? "an id of 11 bits is at most 7FF" : "an id of 29 bits is at most 1FFFFFFF";
  std::string_view rest = text.substr(hash + 1);
  if (rest.starts_with('#')) {
    const auto flags = number_of(rest.substr(1, 1), 16, 1);
    if (!flags) return "after `##` of an FD frame comes a digit of flags";
    f.fd = true;
    f.fast = (*flags & 1) != 0;
    rest.remove_prefix(2);
  } else if (rest.starts_with('R') || rest.starts_with('r')) {
    if (rest.size() == 4 && rest[2] == '_' && digit_of(rest[3]) > 8) rest.remove_suffix(2);
    const auto length = rest.size() == 1 ? 0 : number_of(rest.substr(1, 1), 10, 1);
    if (!length || *length > 8 || rest.size() > 2)
      return "a remote frame is `#R`, or `#R` and a length of 0 to 8";
    f.remote = true;
    f.length = static_cast<std::uint8_t>(*length);
    return {};
  } else if (rest.size() > 2 && rest[rest.size() - 2] == '_') {
    rest.remove_suffix(2);
  }
  return read_payload(rest, f);
}

}  // namespace detail

// What is wrong with the line, or nothing.
inline std::string read_line(std::string_view text, log_line& line) {
  line = {};
  const std::string_view time = detail::next_part(text);
  if (time.size() < 3 || time.front() != '(' || time.back() != ')')
    return "a line begins with its time, (SECONDS.MICROSECONDS)";
  const std::string_view inner = time.substr(1, time.size() - 2);
  const std::size_t dot = inner.find('.');
  const auto seconds = detail::number_of(inner.substr(0, dot), 10, 10);
  auto fraction = dot == inner.npos ? std::string_view("0") : inner.substr(dot + 1);
  const auto parts = detail::number_of(fraction, 10, 9);
  if (!seconds || !parts) return "`" + std::string(time) + "` is not a time in seconds";
  constexpr std::uint64_t latest = 9'223'372'035;  // its nanoseconds just fit; in the year 2262
  if (*seconds > latest) return "`" + std::string(time) + "` is too late: times end in the year 2262";
  std::int64_t ns = static_cast<std::int64_t>(*parts);
  for (std::size_t i = fraction.size(); i < 9; ++i) ns *= 10;
  line.time = static_cast<std::int64_t>(*seconds) * 1'000'000'000 + (dot == inner.npos ? 0 : ns);
  line.bus = detail::next_part(text);
  if (line.bus.empty()) return "after the time comes the name of the interface";
  const std::string_view frame = detail::next_part(text);
  if (frame.empty()) return "after the name of the interface comes the frame";
  line.xl = detail::is_xl(frame);
  if (!line.xl)
    if (const std::string wrong = detail::read_frame(frame, line.frame, line.error); !wrong.empty())
      return wrong;
  const std::string_view way = detail::next_part(text);
  if (!(way.empty() || way == "R" || way == "T") || !detail::next_part(text).empty())
    return "there is something after the frame";
  return {};
}

// What candump writes between the frames: `DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 7)`.
inline bool is_drop_count(std::string_view text) {
  return detail::next_part(text) == "DROPCOUNT:" && detail::next_part(text) == "dropped";
}
// The frames that are missing there.
inline std::uint64_t dropped_in(std::string_view text) {
  detail::next_part(text), detail::next_part(text);
  return detail::number_of(detail::next_part(text), 10, 15).value_or(0);
}

inline std::string text_of(const hw::can_frame& f) {
  char text[16];
  std::snprintf(text, sizeof text, f.id.extended ? "%08X#" : "%03X#", static_cast<unsigned>(f.id.number));
  std::string all = text;
  if (f.fd) all += f.fast ? "#1" : "#0";
  if (f.remote) all += f.length == 0 ? "R" : "R" + std::to_string(f.length);
  for (const std::uint8_t byte : f.payload()) {
    std::snprintf(text, sizeof text, "%02X", static_cast<unsigned>(byte));
    all += text;
  }
  return all;
}

inline std::string text_of(const log_line& line) {
  char time[48];
  std::snprintf(time, sizeof time, "(%010lld.%06lld) ", static_cast<long long>(line.time / 1'000'000'000),
                static_cast<long long>(line.time % 1'000'000'000 / 1000));
  return time + line.bus + ' ' + text_of(line.frame);
}

}  // namespace cca_can
