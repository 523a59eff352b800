// The greeting of a door: who is let in, and what the page is served with.
#include <doctest/doctest.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include <cca/base/refused.hpp>
#include <cca/door/network/connection.hpp>

#include "opened.hpp"

using namespace door_test;

namespace {

// The first line of the answer.
std::string answer_to(std::uint16_t port, const greeting_words& with) {
  const client one(port, "", with);
  return one.head.substr(0, one.head.find('\r'));
}
std::string answer_to_text(std::uint16_t port, const std::string& text) {
  raw_connection wire(port);
  wire.send(text);
  wire.comes("\r\n");
  return wire.received.substr(0, wire.received.find('\r'));
}
// What is printed meanwhile.
template <class Function>
std::string printed(Function&& function) {
  const std::string name = "door_printed.txt";
  std::fflush(stdout);
  const int before = ::dup(1), file = ::open(name.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  ::dup2(file, 1);
  function();
  std::fflush(stdout);
  ::dup2(before, 1);
  ::close(before), ::close(file);
  std::ifstream in(name);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::remove(name.c_str());
  return text;
}
const std::string let_in = "HTTP/1.1 101 Switching Protocols", forbidden = "HTTP/1.1 403 Forbidden";

}  // namespace

TEST_CASE("A viewer is let in with either sub-protocol, and told which") {
  opened one;
  for (const std::string name : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    client c(one.port(), "", {.protocols = name});
    CHECK(c.is_open);
    CHECK(c.head.find("Sec-WebSocket-Protocol: " + name + "\r\n") != std::string::npos);
    CHECK(c.head.find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n") !=
          std::string::npos);  // of RFC 6455
    CHECK(c.head.find("xtensions") == std::string::npos);
    CHECK(c.next("serverInfo")["capabilities"].size() == 6);
  }
  client both(one.port(), token, {.protocols = "chat, foxglove.sdk.v1"});
  CHECK(both.head.find("Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n") != std::string::npos);
  CHECK(both.head.find(token) == std::string::npos);
}

TEST_CASE("A compressing client is let in, and nothing is compressed") {
  opened one;
  client c(one.port(), "", {.more = "\r\nSec-WebSocket-Extensions: permessage-deflate"});
  CHECK(c.is_open);
  CHECK(c.head.find("deflate") == std::string::npos);
}

TEST_CASE("What is no greeting of this protocol is refused with the reason") {
  opened one;
  const auto port = one.port();
  CHECK(answer_to(port, {.protocols = ""}) == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to(port, {.protocols = "chat"}) == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to(port, {.version = "8"}) == "HTTP/1.1 426 Upgrade Required");
  CHECK(answer_to(port, {.method = "POST"}) == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to(port, {.target = "/other"}) == "HTTP/1.1 404 Not Found");
  CHECK(answer_to(port, {.target = "/../etc/passwd"}) == "HTTP/1.1 404 Not Found");
  CHECK(answer_to(port, {.more = "\r\nHost: 127.0.0.1:" + std::to_string(port)}) ==
        "HTTP/1.1 400 Bad Request");
  const std::string host = "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
  CHECK(answer_to_text(port, "hello\r\n\r\n") == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to_text(port, "GET / HTTP/1.0\r\n" + host + "\r\n") == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to(port, {.more = "\r\nTransfer-Encoding: chunked"}) == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to(port, {.more = "\r\nContent-Length: 1000000000"}) == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to_text(port, "GET / HTTP/1.1\r\n\r\n") == "HTTP/1.1 400 Bad Request");
  CHECK(answer_to_text(
            port, "GET / HTTP/1.1\r\n" + host +
                      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\r\n") ==
        "HTTP/1.1 400 Bad Request");
  CHECK(answer_to_text(port, "GET / HTTP/1.1\r\n" + host + "X: " + std::string(9000, 'x') + "\r\n\r\n") ==
        "HTTP/1.1 431 Request Header Fields Too Large");
  CHECK(answer_to_text(port, std::string(9000, '\x16')) == "HTTP/1.1 400 Bad Request");
}

TEST_CASE("A name that a page could point to this machine is no Host of it") {
  opened one;
  const std::string port = ":" + std::to_string(one.port());
  for (const std::string host : {"127.0.0.1", "localhost", "LocalHost", "[::1]"})
    CHECK(answer_to(one.port(), {.host = host + port}) == let_in);
  for (const std::string& host : {"evil.example" + port, std::string("127.0.0.1"), std::string("127.0.0.1:1"),
                                  "127.0.0.1.evil.example" + port, "localhost" + port + ".evil.example",
                                  "10.0.0.1" + port, "0.0.0.0" + port})
    CHECK(answer_to(one.port(), {.host = host}) == forbidden);
}

TEST_CASE("A page of elsewhere is no Origin, unless the program names it") {
  opened one({.origins = {"https://lab.example", "null"}});
  const std::string port = ":" + std::to_string(one.port());
  for (const std::string& origin :
       {"http://127.0.0.1" + port, "http://localhost" + port, std::string("https://lab.example")})
    CHECK(answer_to(one.port(), {.origin = origin}) == let_in);
  for (const std::string origin :
       {"https://evil.example", "http://lab.example", "https://lab.example.evil.example", "http://localhost",
        "http://127.0.0.1:1", "file://"})
    CHECK(answer_to(one.port(), {.origin = origin}) == forbidden);
  CHECK(answer_to(one.port(), {.origin = "null"}) == let_in);
  CHECK(answer_to(one.port(), {.more = "\r\nOrigin: "}) == forbidden);
  opened other;
  CHECK(answer_to(other.port(), {.origin = "null"}) == forbidden);
  CHECK(answer_to(other.port(), {.origin = "https://lab.example"}) == forbidden);
}

TEST_CASE("What no browser sends as Origin is refused when the door is opened") {
  for (const std::string wrong : {"https://lab.example/", "https://lab.example/viewer", "lab.example",
                                  "https://", "*", "https://*.example", "://lab.example", ""}) {
    CAPTURE(wrong);
    std::string why;
    try {
      opened one({.origins = {"https://lab.example", wrong}});
    } catch (const cca::refused& e) { why = e.what(); }
    CHECK(why.find("\"" + wrong + "\" is no address of a page") != std::string::npos);
    CHECK(why.find("https://app.foxglove.dev") != std::string::npos);
  }
}

TEST_CASE("The page is served at / alone, with what keeps others out") {
  const std::string name = "door_page.html";
  std::ofstream(name) << "<!doctype html><p>" << std::string(300000, 'x');
  opened one({.page = name});
  std::remove(name.c_str());
  const std::string host = "Host: localhost:" + std::to_string(one.port()) + "\r\n";
  raw_connection wire(one.port());
  wire.send("GET /?once=abc HTTP/1.1\r\n" + host + "\r\n");
  CHECK(wire.closes());
  CHECK(wire.received.starts_with("HTTP/1.1 200 OK\r\n"));
  for (const char* head : {"Content-Length: 300018\r\n", "default-src 'none'", "frame-ancestors 'none'",
                           "nosniff", "no-referrer", "no-store", "X-Frame-Options: DENY"})
    CHECK(wire.received.find(head) != std::string::npos);
  CHECK(wire.received.find("connect-src 'self' ws://localhost:" + std::to_string(one.port())) !=
        std::string::npos);
  CHECK(wire.received.size() - wire.received.find("\r\n\r\n") - 4 == 300018);
  raw_connection head(one.port());
  head.send("HEAD / HTTP/1.1\r\n" + host + "\r\n");
  CHECK(head.closes());
  CHECK(head.received.ends_with("\r\n\r\n"));
  CHECK(answer_to_text(one.port(), "GET /index.html HTTP/1.1\r\n" + host + "\r\n") ==
        "HTTP/1.1 404 Not Found");
  CHECK(answer_to_text(one.port(), "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n") == forbidden);
  CHECK(answer_to_text(one.port(), "POST / HTTP/1.1\r\n" + host + "\r\n") ==
        "HTTP/1.1 405 Method Not Allowed");
}

TEST_CASE("The page of cca is served where nothing else is said") {
  opened one;
  raw_connection wire(one.port());
  wire.send("GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(one.port()) + "\r\n\r\n");
  CHECK(wire.closes());
  CHECK(wire.received.starts_with("HTTP/1.1 200 OK\r\n"));
  CHECK(wire.received.find("<!-- the recording -->") != std::string::npos);
}

TEST_CASE("A door without a page says so") {
  opened one({.page = ""});
  CHECK(answer_to_text(one.port(), "GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(one.port()) +
                                       "\r\n\r\n") == "HTTP/1.1 426 Upgrade Required");
}

TEST_CASE("A door that can't be opened is refused with the reason") {
  fake_controls controls;
  const auto why = [&](cca::door_settings with) -> std::string {
    with.tells_where = false;
    try {
      const cca::detail::door_server door(with, controls);
    } catch (const cca::refused& e) { return e.what(); }
    return {};
  };
  opened one;
  CHECK(why({.port = one.port()})
            .find("127.0.0.1:" + std::to_string(one.port()) + ": Address already in use") !=
        std::string::npos);
  CHECK(why({.port = 0, .address = "robot"}).find("robot: it is no address") != std::string::npos);
  CHECK(why({.port = 0, .address = "192.0.2.1"}).find("192.0.2.1:0") != std::string::npos);
  CHECK(why({.port = 0, .page = "not_there.html"}).find("not_there.html can't be read") != std::string::npos);
}

TEST_CASE("A door that listens everywhere prints an address at which it is reached") {
  const std::string name = "door_page.html";
  std::ofstream(name) << "<!doctype html>";
  fake_controls controls;
  for (const std::string address : {"0.0.0.0", "127.0.0.1"}) {
    CAPTURE(address);
    std::string once;
    std::uint16_t port = 0;
    bool is_let_in = false;
    std::string host;
    const std::string text = printed([&] {
      const cca::detail::door_server door(
          {.port = 0, .address = address, .token = token, .tells_where = true, .page = name}, controls);
      std::fflush(stdout);
      std::ifstream in("door_printed.txt");
      const std::string told{std::istreambuf_iterator<char>(in), {}};
      port = door.port();
      once = door.one_time_url();
      const std::string before = "door: http://";
      const auto at = told.find(before);
      if (at == told.npos) return;
      host = told.substr(at + before.size());
      host = host.substr(0, host.find('/'));
      raw_connection wire(port, 0, host.substr(0, host.find(':')));
      wire.send(greeting_of(port, {.host = host}));
      is_let_in = wire.comes(let_in);
    });
    CAPTURE(text);
    CHECK(is_let_in);
    CHECK(text.find("0.0.0.0") == std::string::npos);
    CHECK(host.ends_with(":" + std::to_string(port)));
    CHECK(text.starts_with("door: ws://" + host + ", token " + token + "\n"));
    CHECK(text.find("door: http://" + host + "/#token=" + token + "\n") != std::string::npos);
    CHECK(once.starts_with("ws://" + host + "/?once="));
    if (address == "127.0.0.1") CHECK(host.starts_with("127.0.0.1:"));
  }
  std::remove(name.c_str());
}

TEST_CASE("An address that is stated is told as it is, one of everywhere as those of the machine") {
  using cca::detail::door_network::seen_at;
  using cca::detail::door_network::tcp;
  const auto at = [](const char* address) {
    return seen_at(tcp::endpoint(boost::asio::ip::make_address(address), 8765));
  };
  CHECK(at("10.1.2.3") == std::vector{tcp::endpoint(boost::asio::ip::make_address("10.1.2.3"), 8765)});
  for (const char* everywhere : {"0.0.0.0", "::"}) {
    const auto all = at(everywhere);
    REQUIRE_FALSE(all.empty());
    for (const auto& one : all) {
      CHECK(one.port() == 8765);
      CHECK_FALSE(one.address().is_unspecified());
      CHECK(one.address().is_v6() == (std::string(everywhere) == "::"));
      if (all.size() > 1) CHECK_FALSE(one.address().is_loopback());
    }
  }
}
