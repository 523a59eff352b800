// A client of a door on sockets alone, so a test can send what no library would: half of a greeting, a frame
// without a mask, a message that is too large.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace door_test {

using json = nlohmann::json;
using namespace std::chrono_literals;

// Looks again until it holds, or for that long.
template <class Function>
bool soon(Function&& holds, std::chrono::milliseconds most = 3000ms) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

class raw_connection {
public:
  explicit raw_connection(std::uint16_t port,
                          int receive_buffer = 0,
                          const std::string& address = "127.0.0.1")
      : file(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (receive_buffer > 0) ::setsockopt(file, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    ::inet_pton(AF_INET, address.c_str(), &to.sin_addr);
    is_connected = ::connect(file, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
    const int yes = 1;
    ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  }
  raw_connection(const raw_connection&) = delete;
  raw_connection& operator=(const raw_connection&) = delete;
  ~raw_connection() { end(); }

  bool is_connected = false, is_closed = false;
  std::string received{};

  void end() {
    if (file >= 0) ::close(std::exchange(file, -1));
  }
  // Ends as a killed process on another machine does: with a reset.
  void reset() {
    const linger none{1, 0};
    ::setsockopt(file, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    end();
  }
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t size = ::send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (size <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(size));
    }
    return true;
  }
  bool receive(std::chrono::milliseconds most) {  // whether something came, or the end
    pollfd one{file, POLLIN, 0};
    if (is_closed || ::poll(&one, 1, static_cast<int>(most.count())) <= 0) return false;
    char bytes[65536];
    const ssize_t size = ::recv(file, bytes, sizeof bytes, 0);
    if (size <= 0) is_closed = true;
    else received.append(bytes, static_cast<std::size_t>(size));
    return true;
  }
  bool closes(std::chrono::milliseconds most = 3000ms) {
    return soon([&] { return receive(1ms), is_closed; }, most);
  }
  bool comes(std::string_view text, std::chrono::milliseconds most = 3000ms) {
    return soon([&] { return receive(1ms), received.find(text) != std::string::npos; }, most);
  }

private:
  int file;
};

struct greeting_words {
  std::string protocols = "foxglove.websocket.v1", target = "/", host = "", origin = "", more = "",
              method = "GET", version = "13";
};
inline std::string greeting_of(std::uint16_t port, const greeting_words& with) {
  return with.method + " " + with.target +
         " HTTP/1.1\r\nHost: " + (with.host.empty() ? "127.0.0.1:" + std::to_string(port) : with.host) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: "
         "dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: " +
         with.version + (with.protocols.empty() ? "" : "\r\nSec-WebSocket-Protocol: " + with.protocols) +
         (with.origin.empty() ? "" : "\r\nOrigin: " + with.origin) + with.more + "\r\n\r\n";
}

// A whole frame of a door at the begin of `in`: its kind, its payload, and all its bytes.
struct frame_in {
  int kind;
  std::string_view payload;
  std::size_t size;
};
inline std::optional<frame_in> first_frame(std::string_view in) {
  if (in.size() < 2) return {};
  std::size_t size = in[1] & 127, head = 2;
  if (size >= 126) {
    head = size == 126 ? 4 : 10;
    if (in.size() < head) return {};
    size = 0;
    for (std::size_t i = 2; i < head; ++i) size = size << 8 | static_cast<unsigned char>(in[i]);
  }
  if (in.size() - head < size) return {};
  return frame_in{in[0] & 15, in.substr(head, size), head + size};
}
// take(kind, payload) of each whole frame. Returns how many bytes they were.
template <class Take>
std::size_t each_frame(std::string_view in, Take take) {
  std::size_t at = 0;
  while (const auto one = first_frame(in.substr(at))) {
    take(one->kind, one->payload);
    at += one->size;
  }
  return at;
}
// A masked frame. `first`: its first byte.
inline std::string frame_of(unsigned first, std::string_view payload) {
  std::string bytes(1, static_cast<char>(first));
  const std::size_t size = payload.size();
  if (size < 126) bytes += static_cast<char>(0x80 | size);
  else if (size < 65536) ((bytes += '\xfe') += static_cast<char>(size >> 8)) += static_cast<char>(size & 255);
  else {
    bytes += '\xff';
    for (int i = 7; i >= 0; --i)
      bytes += static_cast<char>(static_cast<std::uint64_t>(size) >> (8 * i) & 255);
  }
  const char mask[4] = {'\x12', '\x7f', '\x00', '\x9a'};
  bytes.append(mask, 4);
  for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(payload[i] ^ mask[i % 4]);
  return bytes;
}

class client {
public:
  struct sample {
    std::uint32_t subscription;
    std::uint64_t time;
    std::string data;
  };

  explicit client(std::uint16_t port,
                  const std::string& token = "",
                  greeting_words with = {},
                  int receive_buffer = 0)
      : wire(port, receive_buffer) {
    if (!token.empty()) with.protocols += ", cca.token." + token;
    wire.send(greeting_of(port, with));
    if (!wire.comes("\r\n\r\n")) return;
    const auto end = wire.received.find("\r\n\r\n") + 4;
    head = wire.received.substr(0, end);
    wire.received.erase(0, end);
    is_open = head.starts_with("HTTP/1.1 101 ");
  }

  raw_connection wire;
  bool is_open = false;
  std::string head{};
  std::vector<json> texts{};
  std::vector<sample> samples{};
  std::size_t batches = 0;  // messages with many samples
  bool whole_batches = true;
  std::vector<std::uint64_t> times{};
  std::vector<std::pair<std::uint32_t, json>> answers{};  // by their calls
  struct asset {
    std::uint32_t request;
    std::string why, data;  // empty: it came; what it is
  };
  std::vector<asset> assets{};
  std::uint16_t closed_with = 0;
  std::string why_closed{};
  bool answers_pings = true;

  void text(const json& message) { wire.send(frame_of(0x81, message.dump())); }
  void read(std::chrono::milliseconds most) {
    wire.receive(most);
    while (take()) {}
  }
  bool waits(const std::function<bool()>& holds, std::chrono::milliseconds most = 3000ms) {
    return soon([&] { return holds() || (read(1ms), holds()); }, most);
  }
  // The first text with that `op` that was not asked for before; null if none comes.
  json next(const std::string& op, std::chrono::milliseconds most = 3000ms) {
    json found;
    waits(
        [&] {
          for (auto one = texts.begin(); one != texts.end(); ++one)
            if ((*one)["op"] == op) {
              found = *one;
              texts.erase(one);
              return true;
            }
          return false;
        },
        most);
    return found;
  }
  // The next status message that contains these words.
  bool is_told(const std::string& words, std::chrono::milliseconds most = 3000ms) {
    return waits(
        [&] {
          for (auto one = texts.begin(); one != texts.end(); ++one)
            if ((*one)["op"] == "status" &&
                (*one)["message"].get<std::string>().find(words) != std::string::npos)
              return texts.erase(one), true;
          return false;
        },
        most);
  }
  std::uint32_t channel(const std::string& topic) {
    if (channels.is_null()) channels = next("advertise")["channels"];
    for (const auto& one : channels)
      if (one["topic"] == topic) return one["id"];
    return 0;
  }
  void subscribe(std::uint32_t subscription, std::uint32_t to) {
    text({{"op", "subscribe"}, {"subscriptions", json::array({{{"id", subscription}, {"channelId", to}}})}});
  }
  void set(const std::string& name, const json& value, const std::string& id = "") {
    json message{{"op", "setParameters"}, {"parameters", json::array({{{"name", name}, {"value", value}}})}};
    if (!id.empty()) message["id"] = id;
    text(message);
  }
  std::uint32_t service(const std::string& name) {
    if (services.is_null()) services = next("advertiseServices")["services"];
    for (const auto& one : services)
      if (one["name"] == name) return one["id"];
    return 0;
  }
  static std::string bytes_of_call(std::uint32_t service,
                                   std::uint32_t call,
                                   std::string_view payload,
                                   std::string_view encoding = "json") {
    std::string bytes = "\2";
    for (const std::uint32_t number : {service, call, static_cast<std::uint32_t>(encoding.size())})
      bytes.append(reinterpret_cast<const char*>(&number), 4);
    return bytes.append(encoding).append(payload);
  }
  std::uint32_t send_call(const std::string& name, const json& arguments = json::object()) {
    const std::uint32_t of = service(name);
    wire.send(frame_of(0x82, bytes_of_call(of, ++last_call, arguments.dump())));
    return last_call;
  }
  // What the answer says: empty, or why not.
  std::string answer_of(std::uint32_t call, std::chrono::milliseconds most = 3000ms) {
    std::string why = "no answer";
    waits(
        [&] {
          for (const auto& [of, answer] : answers)
            if (of == call)
              return why = answer["success"] == true ? "" : answer["message"].get<std::string>(), true;
          return false;
        },
        most);
    return why;
  }
  asset fetch(const std::string& uri) {
    text({{"op", "fetchAsset"}, {"uri", uri}, {"requestId", ++last_call}});
    asset found{0, "no answer", ""};
    waits([&] {
      for (const auto& one : assets)
        if (one.request == last_call) return found = one, true;
      return false;
    });
    assets.clear();
    return found;
  }
  std::string call(const std::string& name, const json& arguments = json::object()) {
    return answer_of(send_call(name, arguments));
  }

private:
  json channels{}, services{};
  std::uint32_t last_call = 0;

  bool take() {
    const auto frame = first_frame(wire.received);
    if (!frame) return false;
    const int kind = frame->kind;
    const std::string payload(frame->payload);
    wire.received.erase(0, frame->size);
    if (kind == 1) texts.push_back(json::parse(payload));
    if (kind == 9 && answers_pings) wire.send(frame_of(0x8a, payload));
    if (kind == 8 && payload.size() >= 2) {
      closed_with = static_cast<std::uint16_t>(static_cast<unsigned char>(payload[0]) << 8 |
                                               static_cast<unsigned char>(payload[1]));
      why_closed = payload.substr(2);
    }
    if (kind == 2 && payload[0] == 1) {
      sample one;
      std::memcpy(&one.subscription, payload.data() + 1, 4);
      std::memcpy(&one.time, payload.data() + 5, 8);
      one.data = payload.substr(13);
      samples.push_back(std::move(one));
    }
    if (kind == 2 && payload[0] == '\xca') {
      ++batches;
      for (std::size_t begin = 1; begin + 16 <= payload.size();) {
        sample one;
        std::uint32_t bytes;
        std::memcpy(&one.subscription, payload.data() + begin, 4);
        std::memcpy(&one.time, payload.data() + begin + 4, 8);
        std::memcpy(&bytes, payload.data() + begin + 12, 4);
        one.data = payload.substr(begin + 16, bytes);
        whole_batches = whole_batches && one.data.size() == bytes;
        samples.push_back(std::move(one));
        begin += 16 + bytes;
        whole_batches = whole_batches && begin <= payload.size();
      }
    }
    if (kind == 2 && payload[0] == 2) {
      std::uint64_t time;
      std::memcpy(&time, payload.data() + 1, 8);
      times.push_back(time);
    }
    if (kind == 2 && payload[0] == 3) {
      std::uint32_t call;
      std::memcpy(&call, payload.data() + 5, 4);
      answers.emplace_back(call, json::parse(payload.substr(17)));
    }
    if (kind == 2 && payload[0] == 4) {
      asset one;
      std::uint32_t words;
      std::memcpy(&one.request, payload.data() + 1, 4);
      std::memcpy(&words, payload.data() + 6, 4);
      (payload[5] == 0 ? one.data : one.why) =
          payload[5] == 0 ? payload.substr(10) : payload.substr(10, words);
      assets.push_back(std::move(one));
    }
    return true;
  }
};

}  // namespace door_test
