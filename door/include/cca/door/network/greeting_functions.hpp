// The greeting: the HTTP request that opens a connection, and what it must not be. A page of elsewhere can't
// reach a robot by `ws://localhost` (Origin), nor by a name that it points to this machine (Host).
#pragma once

#include <utility>

#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/rfc7230.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/door/network/frames_functions.hpp>
#include <cca/door/network/limits.hpp>
#include <cca/door/settings.hpp>

namespace cca::detail::door_network {

// Where a connection has arrived.
struct arrival {
  std::string address;  // of this machine, as the client has connected to it: `127.0.0.1`, `[::1]`
  std::uint16_t port = 0;
};

struct greeting {
  enum class is { more, refused, page, connection } what = is::more;
  std::string answer{};         // bytes to send; of a page: the head
  std::string token_offered{};  // of a connection: of the sub-protocol `cca.token.<token>`
  bool has_token = false, knows_cca = false, takes_batches = false;
  std::string once{};
  std::size_t used = 0;    // the bytes after those are already frames
  bool head_only = false;  // HEAD
};

inline std::string status_line(int status) {
  switch (status) {
    case 101:
      return "HTTP/1.1 101 Switching Protocols\r\n";
    case 200:
      return "HTTP/1.1 200 OK\r\n";
    case 400:
      return "HTTP/1.1 400 Bad Request\r\n";
    case 403:
      return "HTTP/1.1 403 Forbidden\r\n";
    case 404:
      return "HTTP/1.1 404 Not Found\r\n";
    case 405:
      return "HTTP/1.1 405 Method Not Allowed\r\n";
    case 426:
      return "HTTP/1.1 426 Upgrade Required\r\nSec-WebSocket-Version: 13\r\n";
    case 431:
      return "HTTP/1.1 431 Request Header Fields Too Large\r\n";
    default:
      return "HTTP/1.1 503 Service Unavailable\r\n";
  }
}

// Nobody shows the page within another, and it loads nothing from elsewhere.
inline std::string head_of_page(const std::string& host, std::size_t size) {
  return status_line(200) +
         "Content-Type: text/html; charset=utf-8\r\nContent-Length: " + std::to_string(size) +
         "\r\nContent-Security-Policy: default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' "
         "blob:; "
         "style-src 'unsafe-inline'; img-src data: blob:; font-src data:; worker-src blob:; connect-src "
         "'self' ws://" +
         host +
         " data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
         "X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\n"
         "Cross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Resource-Policy: same-origin\r\n"
         "Cache-Control: no-store\r\nConnection: close\r\n\r\n";
}

inline greeting refused_greeting(int status, const std::string& why) {
  greeting g{.what = greeting::is::refused};
  g.answer = status_line(status) +
             "Content-Type: text/plain; charset=utf-8\r\nContent-Length: " + std::to_string(why.size() + 1) +
             "\r\nX-Content-Type-Options: nosniff\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n" +
             why + "\n";
  return g;
}

inline std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return all;
}

// Only the names that this machine has for itself, and the address to which the client has connected. A name
// that a page of elsewhere could choose is none of them.
inline bool is_own_host(const std::string& host, const arrival& at, const door_settings& settings) {
  const std::string port = ":" + std::to_string(at.port);
  const std::string given =
      settings.address.find(':') != std::string::npos ? "[" + settings.address + "]" : settings.address;
  for (const std::string& name : {std::string("127.0.0.1"), std::string("localhost"), std::string("[::1]"),
                                  lower(given), lower(at.address)})
    if (host == name + port || (at.port == 80 && host == name)) return true;
  return false;
}

inline bool is_own_origin(const std::string& origin,
                          const std::string& host,
                          const arrival& at,
                          const door_settings& settings) {
  const std::string port = ":" + std::to_string(at.port);
  for (const std::string& one :
       {"http://127.0.0.1" + port, "http://localhost" + port, "http://[::1]" + port, "http://" + host})
    if (origin == one) return true;
  return std::any_of(settings.origins.begin(), settings.origins.end(),
                     [&](const std::string& one) { return origin == lower(one); });
}

// What a browser sends as Origin: no path, and no slash at its end; `null` of a page that is a file.
inline void check_origin(const std::string& one) {
  if (one == "null") return;
  const auto host = one.find("://");
  if (host == one.npos || host == 0 || host + 3 == one.size() ||
      one.find_first_of("/?#* ", host + 3) != one.npos)
    throw refused("door_settings::origins: \"" + one +
                  "\" is no address of a page: expected the scheme, the host and perhaps a port, as in "
                  "https://app.foxglove.dev or http://localhost:8080");
}

// The value of `once` of `/?once=KEY`; another target than `/` is none.
inline bool read_target(std::string_view target, std::string& once) {
  const auto question = target.find('?');
  if (target.substr(0, question) != "/") return false;
  if (question == target.npos) return true;
  std::string_view query = target.substr(question + 1);
  while (!query.empty()) {
    const std::string_view one = query.substr(0, query.find('&'));
    if (one.starts_with("once=")) once = one.substr(5);
    query.remove_prefix(std::min(query.size(), one.size() + 1));
  }
  return true;
}

// `bytes`: all that has come so far. `page_size` 0: there is no page.
inline greeting read_greeting(std::string_view bytes,
                              const arrival& at,
                              const door_settings& settings,
                              const door_limits& limits,
                              std::size_t page_size) {
  namespace http = boost::beast::http;
  using field = http::field;
  http::request_parser<http::empty_body> parser;
  parser.header_limit(static_cast<std::uint32_t>(limits.greeting));
  parser.body_limit(std::uint64_t{0});
  parser.eager(false);
  boost::beast::error_code wrong;
  const std::size_t used = parser.put(boost::asio::buffer(bytes.data(), bytes.size()), wrong);
  if (wrong == http::error::need_more && bytes.size() <= limits.greeting) return {};
  if (wrong == http::error::need_more || wrong == http::error::header_limit)
    return refused_greeting(431, "the head of this request is too long");
  if (wrong || !parser.is_header_done()) return refused_greeting(400, "this is no request of HTTP");
  const auto& request = parser.get();
  const auto text = [&](field name) {
    const auto value = request[name];
    return std::string(value.data(), value.size());
  };
  if (request.count(field::host) != 1 || request.count(field::origin) > 1 || request.version() != 11 ||
      request.chunked())
    return refused_greeting(400, "a request of HTTP 1.1 with one Host, please");
  const std::string host = lower(text(field::host)), origin = lower(text(field::origin));
  if (!is_own_host(host, at, settings))
    return refused_greeting(403, "Host is none of this door: use 127.0.0.1:" + std::to_string(at.port) +
                                     " or localhost:" + std::to_string(at.port) + "; a proxy must set it");
  if (request.count(field::origin) > 0 && !is_own_origin(origin, host, at, settings))
    return refused_greeting(
        403,
        "Origin may not connect: name the page of another address by --door-origin, or in "
        "door_settings::origins");

  greeting g;
  g.used = used;
  if (!read_target({request.target().data(), request.target().size()}, g.once))
    return refused_greeting(404, "there is only /");
  const bool upgrades = http::token_list{request[field::connection]}.exists("upgrade") &&
                        http::token_list{request[field::upgrade]}.exists("websocket");
  if (!upgrades) {
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return refused_greeting(405, "GET, or a WebSocket");
    if (page_size == 0)
      return refused_greeting(426,
                              "this door has no page, only a WebSocket: connect a viewer to ws://" + host +
                                  ", or put share/cca/recording.html of an installed cca beside the program, "
                                  "as cca_page.html");
    g.what = greeting::is::page;
    g.head_only = request.method() == http::verb::head;
    g.answer = head_of_page(host, page_size);
    return g;
  }
  const std::string key = text(field::sec_websocket_key);
  if (request.method() != http::verb::get || key.size() != 24 || !key.ends_with("=="))
    return refused_greeting(400, "this is no greeting of a WebSocket");
  if (text(field::sec_websocket_version) != "13")
    return refused_greeting(426, "only version 13 of WebSocket");
  std::string chosen;
  for (const auto& one : http::token_list{request[field::sec_websocket_protocol]}) {
    const std::string_view name(one.data(), one.size());
    if (chosen.empty() && (name == "foxglove.websocket.v1" || name == "foxglove.sdk.v1")) chosen = name;
    if (name.starts_with("cca.")) g.knows_cca = true;
    if (name == "cca.batches.v1") g.takes_batches = true;
    if (name.starts_with("cca.token.") && !g.has_token) g.has_token = true, g.token_offered = name.substr(10);
  }
  if (chosen.empty())
    return refused_greeting(400, "offer the sub-protocol foxglove.websocket.v1 or foxglove.sdk.v1");
  g.what = greeting::is::connection;
  g.answer = status_line(101) +
             "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: " + accept_key(key) +
             "\r\nSec-WebSocket-Protocol: " + chosen + "\r\n\r\n";
  return g;
}

}  // namespace cca::detail::door_network
