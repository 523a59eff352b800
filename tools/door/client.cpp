#include "client.hpp"

#include <unistd.h>

#include <cstring>
#include <deque>
#include <string_view>
#include <utility>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

namespace cca_door {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using tcp = asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t most_events = 4096;
constexpr std::size_t most_bytes = 16 << 20;          // of one message: a description of a large architecture
constexpr std::size_t most_waiting_bytes = 32 << 20;  // of samples that nobody has taken

template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
  Number one;
  std::memcpy(&one, bytes.data() + at, sizeof one);
  return one;
}
template <class Number>
void add_number(std::string& to, Number one) {
  to.append(reinterpret_cast<const char*>(&one), sizeof one);
}

}  // namespace

struct client::inside {
  enum class phase { connecting, open, closing, closed };

  inside(const door_address& a, const std::string& t, patience p) : to(a), token(t), how_long(p) { begin(); }

  void begin() {
    overall.expires_after(how_long.connecting);
    overall.async_wait([this](error_code e) {
      if (!e && at == phase::connecting)
        end("no answer within " + std::to_string(how_long.connecting.count()) + " ms");
    });
    error_code no_number;
    const auto address = asio::ip::make_address(to.host, no_number);
    if (!no_number) {
      const tcp::endpoint there(address, static_cast<std::uint16_t>(std::stoi(to.port)));
      stream.next_layer().async_connect(there, [this](error_code e) { connected(e); });
      return;
    }
    resolver.async_resolve(to.host, to.port, [this](error_code e, const tcp::resolver::results_type& all) {
      if (e) return end("the address is not known: " + e.message());
      stream.next_layer().async_connect(all,
                                        [this](error_code wrong, const tcp::endpoint&) { connected(wrong); });
    });
  }
  void connected(error_code e) {
    if (at != phase::connecting) return;
    if (e) return end(e == asio::error::connection_refused ? "nobody listens there" : e.message());
    error_code no_matter;
    stream.next_layer().socket().set_option(tcp::no_delay(true), no_matter);
    // The number, not the name: a door takes only the addresses that are its own, against pages that rename
    // themselves.
    const auto there = stream.next_layer().socket().remote_endpoint(e);
    if (e) return end(e.message());
    std::string host = there.address().to_string();
    host = host.substr(0, host.find('%'));
    const door_address named{host, std::to_string(there.port())};
    websocket::stream_base::timeout limits{};
    limits.handshake_timeout = how_long.connecting;
    limits.idle_timeout = how_long.silence;
    limits.keep_alive_pings = true;
    stream.set_option(limits);
    stream.read_message_max(most_bytes);
    stream.set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol,
                  "foxglove.websocket.v1, cca.v1" + (token.empty() ? "" : ", cca.token." + token));
      request.set(beast::http::field::user_agent, "cca");
    }));
    stream.async_handshake(response, named.text(), "/", [this](error_code wrong) { greeted(wrong); });
  }
  void greeted(error_code e) {
    if (at != phase::connecting) return;
    if (e == websocket::error::upgrade_declined)
      return end("this is no door, or it sent the client away: HTTP " +
                 std::to_string(response.result_int()));
    if (e) return end("this is no door: " + e.message());
    if (response[beast::http::field::sec_websocket_protocol] != "foxglove.websocket.v1")
      return end("this is no door: it does not speak foxglove.websocket.v1");
    overall.cancel();
    at = phase::open;
    events.push_back({.what = event::kind::opened});
    read();
    write();
  }

  bool has_room() const { return events.size() < most_events && waiting_bytes < most_waiting_bytes; }
  void read() {
    is_reading = true;
    stream.async_read(buffer, [this](error_code e, std::size_t) {
      is_reading = false;
      if (at == phase::closed) return;
      if (e) return end(why(e));
      const auto bytes = buffer.data();
      take({static_cast<const char*>(bytes.data()), bytes.size()}, stream.got_text());
      buffer.consume(buffer.size());
      if (has_room()) read();
    });
  }
  std::string why(error_code e) const {
    if (e == websocket::error::closed) {
      const auto& reason = stream.reason().reason;
      return reason.empty() ? "the program closed the connection" : std::string(reason.data(), reason.size());
    }
    if (e == beast::error::timeout) return "no sign of life";
    if (e == asio::error::eof || e == asio::error::connection_reset) return "the connection is lost";
    return "the connection is lost: " + e.message();
  }
  void take(std::string_view bytes, bool is_text) {
    event one;
    if (is_text) {
      one.what = event::kind::text;
      one.message = json::parse(bytes.begin(), bytes.end(), nullptr, false);
      if (one.message.is_object()) events.push_back(std::move(one));
      return;
    }
    if (bytes.size() >= 13 && bytes[0] == 1) {
      one.what = event::kind::sample;
      one.id = number_at<std::uint32_t>(bytes, 1);
      one.time = number_at<std::uint64_t>(bytes, 5);
      one.bytes = bytes.substr(13);
      waiting_bytes += one.bytes.size();
    } else if (bytes.size() == 9 && bytes[0] == 2) {
      one.what = event::kind::time;
      one.time = number_at<std::uint64_t>(bytes, 1);
    } else if (bytes.size() >= 13 && bytes[0] == 3) {
      one.what = event::kind::answer;
      one.id = number_at<std::uint32_t>(bytes, 5);
      const std::size_t head = 13 + std::size_t{number_at<std::uint32_t>(bytes, 9)};
      if (head > bytes.size()) return;
      const std::string_view payload = bytes.substr(head);
      one.message = json::parse(payload.begin(), payload.end(), nullptr, false);
    } else {
      return;  // of a later version of the protocol
    }
    events.push_back(std::move(one));
  }

  void write() {
    if (is_writing || at != phase::open || outgoing.empty()) return;
    is_writing = true;
    stream.text(outgoing.front().first);
    stream.async_write(asio::buffer(outgoing.front().second), [this](error_code e, std::size_t) {
      is_writing = false;
      outgoing.pop_front();
      if (e && at == phase::open) return end(why(e));
      write();
    });
  }

  void end(std::string reason) {
    if (at == phase::closed) return;
    at = phase::closed;
    overall.cancel();
    resolver.cancel();
    error_code no_matter;
    stream.next_layer().socket().close(no_matter);
    events.push_back({.what = event::kind::closed, .bytes = std::move(reason)});
  }

  void wait(std::chrono::milliseconds most, int file) {
    if (at == phase::open && !is_reading && has_room()) read();
    if (!events.empty()) most = std::chrono::milliseconds(0);
    bool is_readable = false;
    // A descriptor of its own: this one must not close the program's.
    asio::posix::stream_descriptor keys(context);
    if (const int copy = file >= 0 ? ::dup(file) : -1; copy >= 0) {
      error_code wrong;
      keys.assign(copy, wrong);
      if (wrong) ::close(copy);
      else
        keys.async_wait(asio::posix::stream_descriptor::wait_read, [&](error_code) { is_readable = true; });
    }
    context.restart();
    const auto until = std::chrono::steady_clock::now() + most;
    const std::size_t before = events.size();
    do
      if (context.run_one_until(until) == 0) break;
    while (events.size() == before && !is_readable);
    // What else has arrived already.
    while (at != phase::closed && has_room() && context.poll_one() > 0) {}
    error_code no_matter;
    keys.cancel(no_matter);
    context.restart();
    context.poll();  // then the handler that refers to `is_readable` has run
  }

  door_address to;
  std::string token;
  patience how_long;
  asio::io_context context{1};
  tcp::resolver resolver{context};
  asio::steady_timer overall{context};
  websocket::stream<beast::tcp_stream> stream{context};
  websocket::response_type response{};
  beast::flat_buffer buffer{};
  std::deque<event> events{};
  std::deque<std::pair<bool, std::string>> outgoing{};
  phase at = phase::connecting;
  bool is_reading = false, is_writing = false;
  std::uint32_t last_call = 0;
  std::size_t waiting_bytes = 0;
};

client::client(const door_address& to, const std::string& token, patience how_long)
    : in(std::make_unique<inside>(to, token, how_long)) {}
client::~client() = default;

void client::wait(std::chrono::milliseconds most, int file) { in->wait(most, file); }

std::optional<event> client::next() {
  if (in->events.empty()) return {};
  event one = std::move(in->events.front());
  in->events.pop_front();
  if (one.what == event::kind::sample) in->waiting_bytes -= one.bytes.size();
  return one;
}

bool client::is_open() const { return in->at == inside::phase::open; }

bool client::is_closed() const { return in->at == inside::phase::closed; }

void client::send(const json& message) {
  if (in->at == inside::phase::closed) return;
  in->outgoing.emplace_back(true, written(message));
  in->write();
}

std::uint32_t client::call(std::uint32_t service, const json& arguments) {
  std::string bytes = "\2";
  add_number(bytes, service);
  add_number(bytes, ++in->last_call);
  add_number(bytes, std::uint32_t{4});
  bytes += "json" + written(arguments);
  in->outgoing.emplace_back(false, std::move(bytes));
  in->write();
  return in->last_call;
}

void client::close() {
  if (in->at != inside::phase::open) return;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  in->context.restart();
  while (!in->outgoing.empty() && in->at == inside::phase::open && in->context.run_one_until(until) > 0) {}
  if (in->at != inside::phase::open) return;
  in->at = inside::phase::closing;
  bool is_done = false;
  in->stream.async_close(websocket::close_code::normal, [&](error_code) { is_done = true; });
  while (!is_done && in->context.run_one_until(until) > 0) {}
  in->end("closed");
  // The handler above refers to `is_done`.
  in->context.restart();
  while (!is_done && in->context.run_one() > 0) {}
}

}  // namespace cca_door
