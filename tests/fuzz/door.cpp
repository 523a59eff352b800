// A door without its network: a greeting is refused, unfinished or right. A client without the token changes
// nothing. With the token, the values that reach the controller are within their ranges. The answers are
// whole frames, and JSON.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <cca/door/network/hub_functions.hpp>

#include "../runtime/door/fake_controls.hpp"
#include "door_frames.hpp"
#include "must.hpp"

namespace {

namespace net = cca::detail::door_network;
using about = cca::detail::door_request::what;
const std::string token = "0123456789abcdef";

void check(const std::vector<cca::detail::door_request>& asked, bool has_token, bool commands) {
  for (const auto& one : asked) {
    fuzz::must(has_token && (commands || one.about == about::end_run));
    fuzz::must_be_within(one);
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
    fuzz::read_frames(c, [](int, std::string_view) {});
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
