// The sockets of a door, in a thread of their own. server.hpp includes this, unless it is compiled once for
// the program (cca/base/separate/compiled.hpp).
#pragma once

#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include <cca/base/refused.hpp>
#include <cca/door/network/connection.hpp>
#include <cca/door/network/hub_functions.hpp>
#include <cca/door/network/inbox_functions.hpp>
#include <cca/door/server.hpp>

namespace cca::detail {

struct door_server::inside {
  using error = door_network::error;
  using tcp = door_network::tcp;
  using time_point = door_network::time_point;
  using connection = door_network::connection;
  using shared = std::shared_ptr<connection>;

  inside(const door_settings& given, door_controls& of, const door_limits& most)
      : settings(given),
        limits(most),
        controls(of),
        token(door_network::token_of(given)),
        page(door_network::file_of(given.page, "page")),
        twins(given.kept_for_twins(), door_network::file_of(given.twin, "twin")) {
    for (const std::string& one : given.origins) door_network::check_origin(one);
    door_network::listen(acceptor, settings);
    is_for_others = !acceptor.local_endpoint().address().is_loopback();
    port = acceptor.local_endpoint().port();
    thread = std::thread([this] { run(); });
  }
  ~inside() {
    boost::asio::post(io, [this] { hub->tick(now()); });  // whose request the last beat has taken is told so
    boost::asio::post(io, [this] { end_all(); });
    thread.join();
  }

  const door_settings settings;
  const door_limits limits;
  door_controls& controls;
  const std::string token, page;
  door_network::kept_for_twins twins;
  door_network::one_time_keys keys{};
  door_network::wanted_channels wanted{};
  bool is_for_others = false;
  std::uint16_t port = 0;
  boost::asio::io_context io{1};
  tcp::acceptor acceptor{io};
  boost::asio::steady_timer regular{io}, soon{io}, later{io};
  door_network::inbox box{limits, wanted, twins,
                          [this] { boost::asio::post(io, [this] { take_samples(); }); }};
  door_network::inbox::batch batch{};
  std::unique_ptr<door_network::hub> hub{};
  std::list<shared> all{};
  std::size_t greeted = 0;  // of them, those that are clients
  bool is_waiting_soon = false, is_ending = false;
  unsigned rounds = 0;
  std::uint64_t told_time = 0;
  std::thread thread{};

  static time_point now() { return std::chrono::steady_clock::now(); }

  void run() {
    hub = std::make_unique<door_network::hub>(settings, limits, controls, token, keys, is_for_others, wanted,
                                              twins);
    accept();
    wait_regularly();
    for (bool runs = true; runs;) {
      try {
        io.run();
        runs = false;
      } catch (
          const std::exception& e) {  // no memory, or a fault of the door: it must not end a robot's program
        std::fprintf(stderr, "door: %s\n", e.what());
      }
    }
  }

  void accept() {
    acceptor.async_accept([this](error wrong, tcp::socket socket) {
      if (is_ending) return;
      if (wrong) {  // such as: no more files may be open
        later.expires_after(std::chrono::milliseconds(50));
        return later.async_wait([this](error) {
          if (!is_ending) accept();
        });
      }
      accept();  // first: whatever happens below, the next one is let in
      // The oldest goes: so many that never finish keep nobody out who does.
      if (all.size() - greeted >= limits.half_open)
        end(shared(*std::find_if(all.begin(), all.end(), [](const shared& c) { return !c->client; })));
      begin(std::move(socket));
    });
  }

  void begin(tcp::socket socket) {
    error ignored;
    door_network::keep_from_children(socket.native_handle());
    ignored = socket.non_blocking(true, ignored);
    ignored = socket.set_option(tcp::no_delay(true), ignored);
    const auto c = all.emplace_back(
        std::make_shared<connection>(std::move(socket), limits.message, now() + limits.greeting_time));
    read(c);
  }

  void read(const shared& c) {
    c->socket.async_read_some(boost::asio::buffer(c->piece), [this, c](error wrong, std::size_t size) {
      if (!c->is_open) return;
      if (wrong) return end(c);
      const std::string_view bytes(c->piece.data(), size);
      if (c->client) hear(c, bytes);
      else if (!c->ends_after_write) greet(c, bytes);
      send_all();
      if (c->is_open) read(c);
    });
  }

  void greet(const shared& c, std::string_view bytes) {
    c->greeting.append(bytes);
    error wrong;
    const auto here = c->socket.local_endpoint(wrong), there = c->socket.remote_endpoint(wrong);
    if (wrong) return end(c);
    const std::string address = here.address().to_string();
    const door_network::arrival at{here.address().is_v6() ? "[" + address + "]" : address, port};
    const auto hello = door_network::read_greeting(c->greeting, at, settings, limits, page.size());
    using is = door_network::greeting::is;
    if (hello.what == is::more) return;
    c->sending = hello.answer;
    if (hello.what == is::connection &&
        greeted >= static_cast<std::size_t>(std::max(settings.most_clients, 0)) && !hub->makes_room(hello))
      c->sending = door_network::refused_greeting(
                       503, "this door has " + std::to_string(greeted) + " clients, and takes no more")
                       .answer;
    else if (hello.what == is::connection) return enter(c, hello, there);
    c->ends_after_write = true;
    if (hello.what == is::page) {
      c->deadline = now() + limits.page_time;
      if (!hello.head_only) c->sending_then = page;
    }
    write(c);
  }
  void enter(const shared& c, const door_network::greeting& hello, const tcp::endpoint& there) {
    error ignored;
    ignored = c->socket.set_option(boost::asio::socket_base::send_buffer_size(1 << 18), ignored);
    ++greeted;
    c->has_deadline = false;
    c->client = &hub->enter(door_network::text_of(there), hello, now());
    const std::string rest = c->greeting.substr(hello.used);
    c->greeting = {};
    write(c);
    if (!rest.empty()) hear(c, rest);
  }

  void hear(const shared& c, std::string_view bytes) {
    using frame = door_network::frame_kind;
    if (!hub->hears(*c->client, bytes.size(), now())) return;
    const auto wrong = c->frames.read(bytes, [&](frame what, std::string_view payload) {
      if (what == frame::close) return c->client->close(door_network::normal, "goodbye"), true;
      hub->message(*c->client, what, payload, now());
      return true;
    });
    if (wrong != door_network::no_fault)
      c->client->close(wrong, wrong == door_network::too_large
                                  ? "a message has at most " + std::to_string(limits.message) + " bytes"
                                  : "a wrong frame");
    if (hub->is_busy()) tick_soon();
  }

  // What waits for each client. Its last words are why it is closed.
  void send_all() {
    for (auto one = all.begin(); one != all.end();) {
      const shared c = *one++;
      if (!c->client) continue;
      const bool closes = c->client->closing != door_network::no_fault;
      if (closes && !std::exchange(c->has_deadline, true))  // also if it does not read what is under way
        c->deadline = now() + std::chrono::seconds(1);
      if (c->is_writing) continue;
      if (!c->ends_after_write && (!closes || is_ending) && c->client->out.take(c->sending)) {
        write(c);
      } else if (closes && !c->ends_after_write) {
        c->ends_after_write = true;
        c->client->out.take_answers(c->sending);
        std::string last{static_cast<char>(c->client->closing >> 8),
                         static_cast<char>(c->client->closing & 255)};
        door_network::add_frame(c->sending, door_network::frame_kind::close,
                                last + c->client->why_closing.substr(0, 120));
        write(c);
      }
    }
  }
  void write(const shared& c) {
    c->is_writing = true;
    const std::array<boost::asio::const_buffer, 2> bytes{boost::asio::buffer(c->sending),
                                                         boost::asio::buffer(c->sending_then)};
    boost::asio::async_write(c->socket, bytes, [this, c](error wrong, std::size_t) {
      c->is_writing = false;
      if (!c->is_open) return;
      if (wrong) return end(c);
      if (c->ends_after_write) {
        // It reads until the other side has closed, or a moment: else the last words could be lost.
        error ignored;
        ignored = c->socket.shutdown(tcp::socket::shutdown_send, ignored);
        c->deadline = std::min(c->deadline, now() + std::chrono::seconds(1));
        return;
      }
      send_all();
    });
  }
  void end(const shared& c) {
    if (!c->is_open) return;
    c->is_open = false;
    error ignored;
    ignored = c->socket.close(ignored);
    all.remove(c);
    if (!c->client || is_ending) return;
    --greeted;
    hub->leave(*std::exchange(c->client, nullptr), now());
    if (hub->is_busy()) tick_soon();
  }

  void take_samples() {
    box.take(batch);
    for (const auto& one : batch.channels) hub->channel(one);
    for (const auto& [name, entries] : batch.notes) hub->metadata(name, entries);
    batch.each([&](std::uint16_t channel, std::uint64_t time, std::string_view data) {
      hub->sample(channel, time, data);
    });
    hub->lost(batch.lost);
    send_all();
  }
  void tick_soon() {
    if (std::exchange(is_waiting_soon, true)) return;
    soon.expires_after(std::chrono::milliseconds(1));
    soon.async_wait([this](error) {
      is_waiting_soon = false;
      if (is_ending) return;
      hub->tick(now());
      send_all();
      if (hub->is_busy()) tick_soon();
    });
  }
  // Fifty times a second the time, ten times the rest.
  void wait_regularly() {
    regular.expires_after(std::chrono::milliseconds(20));
    regular.async_wait([this](error) {
      if (is_ending) return;
      wait_regularly();
      if (const std::uint64_t time = box.time(); time != told_time) hub->time(told_time = time);
      if (++rounds % 5 == 0) {
        const auto moment = now();
        hub->regularly(moment);
        for (auto one = all.begin(); one != all.end();) {
          const shared c = *one++;
          if (c->has_deadline && moment > c->deadline) end(c);
        }
      }
      send_all();
    });
  }

  // The program ends: nothing that a client held is the door's to release. Each client gets what has been
  // said until now, how it has ended, and a last word, if it reads them within a moment.
  void end_all() {
    take_samples();
    hub->regularly(now());
    send_all();
    is_ending = true;
    error ignored;
    ignored = acceptor.close(ignored);
    regular.cancel(), soon.cancel();
    for (const shared& c : all)
      if (c->client) c->client->close(door_network::going_away, "the program ends");
    send_all();
    wait_for_last_words(60);
  }
  void wait_for_last_words(int left) {
    if (left > 0 &&
        std::any_of(all.begin(), all.end(), [](const shared& c) { return c->client && c->is_writing; })) {
      later.expires_after(std::chrono::milliseconds(5));
      return later.async_wait([this, left](error) { wait_for_last_words(left - 1); });
    }
    for (const shared& c : all) {
      error ignored;
      c->is_open = false;
      ignored = c->socket.close(ignored);
    }
    all.clear();
  }
};

CCA_DOOR_INLINE door_server::door_server(const door_settings& settings,
                                         door_controls& controls,
                                         const door_limits& limits)
    : in(std::make_unique<inside>(settings, controls, limits)) {
  if (!settings.tells_where) return;
  const auto seen = door_network::seen_at(in->acceptor.local_endpoint());
  const std::string where = door_network::text_of(seen[0]);
  const bool is_in_file = !settings.token_file.empty();
  std::printf("door: ws://%s, token %s\n", where.c_str(),
              is_in_file ? ("in " + settings.token_file).c_str() : in->token.c_str());
  if (!in->page.empty())  // what stands behind # stays in the browser
    std::printf("door: http://%s/%s\n", where.c_str(), is_in_file ? "" : ("#token=" + in->token).c_str());
  for (std::size_t i = 1; i < seen.size(); ++i)
    std::printf("door: also at %s\n", door_network::text_of(seen[i]).c_str());
  if (!settings.origins.empty())  // a viewer of others, which knows only a URL
    std::printf("door: for one viewer, once: %s\n", one_time_url().c_str());
  std::fflush(stdout);
}
CCA_DOOR_INLINE door_server::~door_server() = default;
CCA_DOOR_INLINE recording::message_sink& door_server::sink() { return in->box; }
CCA_DOOR_INLINE std::uint16_t door_server::port() const { return in->port; }
CCA_DOOR_INLINE std::string door_server::token() const { return in->token; }
CCA_DOOR_INLINE std::string door_server::one_time_url() const {
  const auto seen = door_network::seen_at(in->acceptor.local_endpoint());
  return "ws://" + door_network::text_of(seen[0]) + "/?once=" + in->keys.make();
}

}  // namespace cca::detail
