// A door without its network: a greeting is refused, unfinished or right. A client without the token changes
// nothing. With the token, the values that reach the controller are within their ranges. The answers are
// whole frames, and JSON.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <cca/door/network/hub_functions.hpp>

#include "../runtime/door/fake_controls.hpp"
#include "must.hpp"

namespace {

namespace net = cca::detail::door_network;
using about = cca::detail::door_request::what;
const std::string token = "0123456789abcdef";

// What the client gets: unmasked frames.
void read_answers(net::door_client& c) {
  std::string bytes;
  while (c.out.take(bytes))
    for (std::size_t at = 0; at < bytes.size();) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes.at(i)); };
      std::size_t size = byte(at + 1), head = 2;
      fuzz::must(size < 128);
      if (size >= 126) {
        head = size == 126 ? 4 : 10;
        size = 0;
        for (std::size_t i = 2; i < head; ++i) size = size << 8 | byte(at + i);
      }
      const std::string payload = bytes.substr(at + head, size);
      fuzz::must(payload.size() == size);
      if (byte(at) == 0x81) fuzz::must(net::json::accept(payload));
      if (byte(at) == 0x82 && payload[0] == net::op_of_batch)
        for (std::size_t i = 1; i < payload.size();) {
          fuzz::must(payload.size() - i >= 16);
          std::uint32_t length;
          std::memcpy(&length, payload.data() + i + 12, 4);
          fuzz::must(payload.size() - i - 16 >= length);
          i += 16 + length;
        }
      if (byte(at) == 0x82 && payload[0] == 3) fuzz::must(net::json::accept(payload.substr(17)));
      at += head + size;
    }
}

void check(const std::vector<cca::detail::door_request>& asked, bool has_token, bool commands) {
  for (const auto& one : asked) {
    fuzz::must(has_token && (commands || one.about == about::end_run));
    fuzz::must(one.about != about::step || (one.number >= 1 && one.number <= 1e6));
    fuzz::must(one.about != about::speed || (one.number >= 0 && one.number <= 1000));
    if (one.about == about::save || one.about == about::record || one.about == about::load)
      fuzz::must(!one.text.starts_with("/") && ("/" + one.text + "/").find("/../") == std::string::npos);
    for (const auto& [name, value] : one.values) {
      if (one.about == about::call && name == "force") fuzz::must(value.number >= -50 && value.number <= 50);
      if (one.about == about::set && name == "gait.frequency")
        fuzz::must(value.number >= 0.1 && value.number <= 5);
      if (one.about == about::set && name == "gait.gains") fuzz::must(value.numbers.size() == 3);
    }
  }
}

void greet(std::string_view bytes) {
  const cca::door_settings settings{.origins = {"https://lab.example"}};
  const auto g = net::read_greeting(bytes, {"127.0.0.1", 8765}, settings, {}, 100);
  using is = net::greeting::is;
  fuzz::must(g.what == is::more ? g.answer.empty()
                                : g.answer.starts_with("HTTP/1.1 ") &&
                                      g.answer.ends_with(g.what == is::refused ? "\n" : "\r\n\r\n"));
  fuzz::must(g.used <= bytes.size());
  if (g.what == is::connection)
    fuzz::must(g.answer.starts_with("HTTP/1.1 101 ") && g.answer.find(token) == std::string::npos);
}

// With something to ask for.
const net::kept_for_twins& kept_twins() {
  static net::kept_for_twins twins(1 << 12, "\0asm");
  const std::string message(4 + 24, '\1');
  twins.channel(
      {.id = 1, .topic = "/a", .type = "a", .schema = "", .role = cca::recording::replay_role::computed});
  for (int i = 0; i < 2000; ++i) twins.message(1, cca::recording::detail::bytes_of(message));
  return twins;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const unsigned how = data[0];
  std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (how & 1) return greet(bytes), 0;

  door_test::fake_controls controls;
  const cca::door_settings settings;
  const cca::detail::door_limits limits;
  net::one_time_keys keys;
  const auto wanted = std::make_unique<net::wanted_channels>();
  static const net::kept_for_twins& twins = kept_twins();
  net::hub hub(settings, limits, controls, token, keys, (how & 2) != 0, *wanted, twins);
  hub.channel({.id = 1, .topic = "/a", .type = "a", .is_kept = true});
  net::time_point now{std::chrono::hours(1)};
  net::greeting hello;
  const bool greets_with_token = (how & 4) != 0, commands = greets_with_token && (how & 8) != 0;
  const bool has_token = greets_with_token || bytes.find(token) != bytes.npos;  // it may show it later
  hello.has_token = greets_with_token;
  hello.takes_batches = (how & 64) != 0;
  hello.token_offered = token;
  if (commands) hello.once = keys.make();
  net::door_client& c = hub.enter("127.0.0.1:1", hello, now);
  hub.enter("127.0.0.1:2", {}, now);
  if (how & 16) controls.answers(door_test::fake_controls::how::begun);
  bool shows_token = false;  // it may guess it: the corpus has it
  const auto hear = [&](net::frame_kind kind, std::string_view payload) {
    if (const auto m = net::json::parse(payload, nullptr, false); m.is_object() && m.contains("token"))
      shows_token = shows_token || m["token"] == token;
    hub.message(c, kind, payload, now);
    hub.sample(1, 7, payload);
    now += std::chrono::milliseconds(1);
    hub.tick(now);
    hub.regularly(now);
    read_answers(c);
    return true;
  };
  if (how & 32) {
    net::frame_reader frames(limits.message);
    while (!bytes.empty()) {  // in pieces
      const std::string_view piece = bytes.substr(0, 1 + bytes.size() % 7);
      if (frames.read(piece, hear) != net::no_fault) break;
      bytes.remove_prefix(piece.size());
    }
  } else {
    while (!bytes.empty()) {
      const std::string_view line = bytes.substr(0, bytes.find('\n'));
      hear(line.starts_with('\2') ? net::frame_kind::binary : net::frame_kind::text, line);
      bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
    }
  }
  const auto noted = controls.noted();
  const bool took = commands || std::any_of(noted.begin(), noted.end(), [](const auto& one) {
                      return one.ends_with("takes the command");
                    });
  check(controls.asked(), has_token || shows_token, took);
  hub.leave(c, now);
  controls.answers(door_test::fake_controls::how::done);
  hub.tick(now);
  fuzz::must(hub.everyone().size() == 1);
  return 0;
}
