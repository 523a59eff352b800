// Raw: TCP on this machine, a connection for each reflector, without delay.
#pragma once

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <memory>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "processes.hpp"

namespace bench {

class connection {
public:
  explicit connection(int of) : file(of) {
    const int on = 1;
    if (file < 0 || ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on) != 0)
      throw std::runtime_error("no connection over TCP");
  }
  ~connection() { ::close(file); }
  connection(connection&& other) noexcept : file(std::exchange(other.file, -1)) {}

  void send(const unsigned char* from, std::size_t bytes) const {
    while (bytes > 0) {
      const auto sent = ::send(file, from, bytes, MSG_NOSIGNAL);
      if (sent <= 0) throw std::runtime_error("TCP: nothing can be sent");
      from += sent, bytes -= static_cast<std::size_t>(sent);
    }
  }
  bool receive(unsigned char* to, std::size_t bytes) const {
    return ::recv(file, to, bytes, MSG_WAITALL) == static_cast<ssize_t>(bytes);
  }

private:
  int file;
};

inline round_of_times tcp(int fan_out, std::size_t bytes, const amount& of) {
  const std::int64_t since = nanoseconds();
  const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const at = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (::bind(listening, at, size) != 0 || ::listen(listening, fan_out) != 0 ||
      ::getsockname(listening, at, &size) != 0)
    throw std::runtime_error("TCP: can't listen");
  const auto round = in_processes(
      fan_out, of.round_trips,
      [&](int reflector) {
        stay_on(core_of(reflector + 1, fan_out));
        const int file = ::socket(AF_INET, SOCK_STREAM, 0);
        if (::connect(file, at, size) != 0) throw std::runtime_error("TCP: can't connect");
        const connection to(file);
        const auto message = std::make_unique<unsigned char[]>(bytes);
        while (to.receive(message.get(), bytes)) to.send(message.get(), bytes);
      },
      [&](round_of_times& found) {
        stay_on(core_of(0, fan_out));
        std::vector<connection> all;
        for (int r = 0; r < fan_out; ++r) all.emplace_back(::accept(listening, nullptr, nullptr));
        const auto message = std::make_unique<unsigned char[]>(bytes);
        drive(found, of, since, [&](std::size_t n) {
          std::memcpy(message.get(), &n, sizeof n);
          for (const auto& one : all) one.send(message.get(), bytes);
          bool is_right = true;
          for (const auto& one : all) {
            is_right = one.receive(message.get(), bytes) && is_right;
            is_right = is_right && std::memcmp(message.get(), &n, sizeof n) == 0;
          }
          return is_right;
        });
      });
  ::close(listening);
  return round;
}

}  // namespace bench
