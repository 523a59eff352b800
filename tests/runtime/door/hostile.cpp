// What must not hurt a door: half of a greeting, floods, frames that are wrong, too many clients.
#include <doctest/doctest.h>

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <list>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "opened.hpp"

using namespace door_test;
using about = fake_controls::about;

namespace {

// The code with which that is answered.
int closed_after(opened& one, std::string_view bytes) {
  client c(one.port());
  c.wire.send(bytes);
  c.waits([&] { return c.closed_with != 0; });
  CHECK(c.wire.closes());
  return c.closed_with;
}
bool works(opened& one) {
  client c(one.port(), token);
  c.text({{"op", "getParameters"}});
  return c.is_open && c.next("parameterValues")["parameters"].size() == 5;
}

}  // namespace

TEST_CASE("A wrong frame closes the connection") {
  opened one;
  const std::string text = "{\"op\":\"getParameters\"}";
  CHECK(closed_after(one, std::string("\x81\x02{}", 4)) == 1002);                 // no mask
  CHECK(closed_after(one, frame_of(0xc1, text)) == 1002);                         // compressed
  CHECK(closed_after(one, frame_of(0x83, text)) == 1002);                         // a kind that is none
  CHECK(closed_after(one, frame_of(0x8b, text)) == 1002);                         // likewise
  CHECK(closed_after(one, frame_of(0x80, text)) == 1002);                         // the rest of nothing
  CHECK(closed_after(one, frame_of(0x01, text) + frame_of(0x81, text)) == 1002);  // a message in another
  CHECK(closed_after(one, frame_of(0x09, "")) == 1002);                           // a ping in parts
  CHECK(closed_after(one, frame_of(0x89, std::string(126, 'x'))) == 1002);        // a ping that is too long
  CHECK(closed_after(one, frame_of(0x88, "\x03\xe8")) == 1000);                   // goodbye
  CHECK(works(one));
}

TEST_CASE("A message that is too large closes the connection before it is kept") {
  opened one;
  CHECK(closed_after(one, frame_of(0x81, std::string(65537, ' '))) == 1009);
  CHECK(closed_after(one, std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff", 10)) ==
        1009);  // only its head
  CHECK(closed_after(one, std::string("\x82\xff\xff\xff\xff\xff\xff\xff\xff\xff", 10)) == 1009);
  CHECK(closed_after(one, frame_of(0x01, std::string(40000, ' ')) +
                              frame_of(0x00, std::string(40000, ' '))) == 1009);  // in parts
  client c(one.port());
  c.wire.send(frame_of(0x81, "{\"op\":\"getParameters\"}" + std::string(65536 - 22, ' ')));
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
}

TEST_CASE("A message may come in any pieces, and a ping between them") {
  opened one;
  client c(one.port());
  const std::string bytes = frame_of(0x01, "{\"op\":\"get") + frame_of(0x89, "hello") +
                            frame_of(0x00, "Para") + frame_of(0x80, "meters\"}");
  for (const char byte : bytes) {
    c.wire.send(std::string(1, byte));
    std::this_thread::sleep_for(1ms);
  }
  CHECK(c.next("parameterValues")["parameters"].size() == 5);
}

TEST_CASE("Frames right after the greeting are heard") {
  opened one;
  raw_connection wire(one.port());
  wire.send(greeting_of(one.port(), {}) + frame_of(0x81, "{\"op\":\"getParameters\"}"));
  CHECK(wire.comes("parameterValues"));
}

TEST_CASE("Parts of a message count as bytes, though no message comes") {
  opened one;
  client c(one.port());
  c.wire.send(frame_of(0x01, ""));
  std::string parts;
  for (int i = 0; i < 10000; ++i) parts += frame_of(0x00, "");
  for (int i = 0; i < 100 && c.wire.send(parts); ++i) {}  // 6 MB of heads
  CHECK(c.waits([&] { return c.closed_with != 0 || c.wire.is_closed; }));
  CHECK(c.closed_with == 1008);
  CHECK(works(one));
}

TEST_CASE("A greeting that does not end is closed, and keeps nobody out") {
  cca::detail::door_limits limits;
  limits.greeting_time = 500ms;
  limits.half_open = 20;
  opened one({}, limits);
  std::list<raw_connection> half;
  for (int i = 0; i < 20; ++i) {
    half.emplace_back(one.port());
    if (i % 2) half.back().send("GET / HTTP/1.1\r\nHo");
  }
  std::this_thread::sleep_for(50ms);
  CHECK_FALSE(half.front().closes(20ms));
  CHECK(works(one));  // the oldest has gone
  CHECK(half.front().closes(100ms));
  CHECK_FALSE(half.back().closes(20ms));
  for (auto& c : half) CHECK(c.closes(1500ms));
  CHECK(works(one));
}

TEST_CASE("A greeting that comes by single bytes has no more time") {
  opened one({}, {.greeting_time = 400ms});
  raw_connection slow(one.port());
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 400 && !slow.is_closed; ++i) {
    slow.send("G");
    slow.receive(10ms);
  }
  CHECK(slow.closes());
  CHECK(std::chrono::steady_clock::now() - begin < 1500ms);
}

TEST_CASE("A reader of the page that does not read has no more time") {
  const std::string name = "door_large_page.html";
  std::ofstream(name) << std::string(20 << 20, 'x');
  opened one({.page = name}, {.page_time = 500ms});
  std::remove(name.c_str());
  raw_connection slow(one.port(), 4096);
  slow.send("GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(one.port()) + "\r\n\r\n");
  std::this_thread::sleep_for(1000ms);
  CHECK(slow.closes());
  CHECK(slow.received.size() < (20u << 20));
}

TEST_CASE("No more clients than the program allows, and a place is free again") {
  opened one({.most_clients = 2});
  auto a = std::make_unique<client>(one.port());
  const client b(one.port());
  CHECK(b.is_open);
  const client c(one.port());
  CHECK(c.head.starts_with("HTTP/1.1 503"));
  a.reset();
  CHECK(soon([&] { return client(one.port()).is_open; }));
}

TEST_CASE("A full door has a place for a client with the token, if one without it is there") {
  opened one({.most_clients = 2});
  client first(one.port()), second(one.port(), token);
  CHECK(client(one.port(), std::string(32, 'f')).head.starts_with("HTTP/1.1 503"));
  CHECK(
      client(one.port(), "", {.target = "/?once=" + std::string(32, 'f')}).head.starts_with("HTTP/1.1 503"));
  client third(one.port(), token);
  CHECK(third.is_open);
  CHECK(first.waits([&] { return first.closed_with != 0; }));
  CHECK(first.closed_with == 1008);
  CHECK(first.why_closed == "this door is full: a client with the token takes the place");
  CHECK(client(one.port(), token).head.starts_with("HTTP/1.1 503"));  // both have it
  CHECK(second.call("/cca/take_command").empty());
  CHECK(third.call("/cca/stop").empty());
  third.wire.end();
  CHECK(soon([&] { return client(one.port()).is_open; }));
  client watches(one.port());
  const std::string url = one.door.one_time_url();
  CHECK(client(one.port(), "", {.target = url.substr(url.find("/?once"))}).is_open);
}

TEST_CASE("A client that floods is dropped, by messages or by bytes") {
  opened one({}, {.messages_per_second = 100});  // however slow this machine is
  const auto flood = [&](client& c, unsigned kind, const std::string& what) {
    for (int i = 0; i < 2500 && c.wire.send(frame_of(kind, what)); ++i) {}
    CHECK(c.waits([&] { return c.closed_with != 0; }));
    CHECK(c.closed_with == 1008);
  };
  client many(one.port());
  flood(many, 0x81, "{\"op\":\"x\"}");
  CHECK(many.why_closed == "this client sends too much: at most 100 messages a second");
  client large(one.port());
  for (int i = 0; i < 1000 && large.wire.send(frame_of(0x81, std::string(60000, ' '))); ++i) {}
  CHECK(large.waits([&] { return large.closed_with != 0; }));
  CHECK(large.closed_with == 1008);
  client pings(one.port()), ponged(one.port());
  flood(pings, 0x89, "x");
  flood(ponged, 0x8a, "x");
  CHECK(works(one));
}

TEST_CASE("A client that does not read its answers is dropped") {
  opened one({}, {.answers = 100000, .messages_per_second = 1e9, .bytes_per_second = 1e12});
  client c(one.port(), "", {}, 4096);
  for (int i = 0; i < 20000 && c.wire.send(frame_of(0x81, "{\"op\":\"cca.describe\"}")); ++i) {}
  CHECK(c.wire.closes(5000ms));
  CHECK(works(one));
}

TEST_CASE("A thousand connects a second are no harm to a client that reads") {
  opened one;
  one.channel(1, "/a");
  client c(one.port(), token);
  CHECK(c.waits([&] { return c.channel("/a") == 1; }));
  c.subscribe(1, 1);
  std::atomic<bool> ends{false};
  std::atomic<int> made{0};
  std::thread others([&] {
    auto due = std::chrono::steady_clock::now();
    for (int i = 0; !ends; ++i) {
      raw_connection wire(one.port());
      made += wire.is_connected;
      if (i % 3 == 1) wire.send("GET / HT");
      if (i % 3 == 2) wire.send(greeting_of(one.port(), {.host = "evil.example"}));
      std::this_thread::sleep_until(due += 1ms);
    }
  });
  std::uint64_t sent = 0;
  for (const auto end = std::chrono::steady_clock::now() + 1s; std::chrono::steady_clock::now() < end;) {
    one.message(1, ++sent, "x");
    c.read(1ms);
  }
  ends = true;
  others.join();
  CHECK(c.waits([&] { return !c.samples.empty() && c.samples.back().time == sent; }));
  CHECK(c.samples.size() > sent * 9 / 10);  // not those before the subscription
  CHECK(made.load() > 500);
  CHECK(works(one));
}

TEST_CASE("Random bytes after the greeting, and instead of it, change nothing") {
  opened one({.most_clients = 8});
  std::mt19937 random(7);
  const auto noise = [&](std::size_t size) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
  };
  for (int i = 0; i < 200; ++i) {
    raw_connection wire(one.port());
    if (i % 2) wire.send(greeting_of(one.port(), {.protocols = "foxglove.websocket.v1, cca.token." + token}));
    wire.send(i % 4 == 1 ? frame_of(0x82, noise(random() % 300)) : noise(random() % 3000));
    wire.receive(1ms);
  }
  CHECK(soon([&] { return works(one); }, 20000ms));  // after those two hundred
  CHECK(one.controls.asked().empty());
}

TEST_CASE("A fault behind the door ends neither the program nor the door") {
  opened one;
  client c(one.port(), token);
  c.subscribe(1, 60001);
  CHECK(c.waits([&] { return !c.samples.empty(); }));
  one.controls.throws = true;
  std::this_thread::sleep_for(300ms);
  CHECK(works(one));
  one.controls.throws = false;
  c.read(1ms);
  c.samples.clear();
  CHECK(c.waits([&] { return !c.samples.empty(); }));
}

TEST_CASE("A door closes while clients are connected, with a word") {
  auto one = std::make_unique<opened>();
  client c(one->port(), token);
  CHECK(c.call("/cca/take_command").empty());
  CHECK(c.call("/cca/command/push", {{"force", 1}}).empty());
  raw_connection half(one->port());
  one.reset();
  CHECK(c.wire.closes());
  c.read(1ms);
  CHECK(c.closed_with == 1001);
  CHECK(half.closes());
}

TEST_CASE("A door that has no more files to open takes clients again later") {
  opened one;
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  std::list<raw_connection> waiting;
  for (int i = 0; i < 3; ++i) waiting.emplace_back(one.port());
  std::this_thread::sleep_for(50ms);
  rlimit few = before;
  few.rlim_cur = 3;  // all below are in use
  raw_connection late(one.port());
  ::setrlimit(RLIMIT_NOFILE, &few);
  std::this_thread::sleep_for(120ms);
  ::setrlimit(RLIMIT_NOFILE, &before);
  CHECK(soon([&] { return works(one); }));
}
