// A socket of a door, from its greeting to its end; and the page that it may be served.
#pragma once

#include <fcntl.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <utility>

#include <boost/asio/ip/tcp.hpp>

#include <array>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/door/network/client.hpp>
#include <cca/door/network/frames_functions.hpp>
#include <cca/door/settings.hpp>

namespace cca::detail::door_network {

// A program that this one starts must not keep the port, or a client, when this one has ended.
inline void keep_from_children(int file) { static_cast<void>(::fcntl(file, F_SETFD, FD_CLOEXEC)); }

namespace asio = boost::asio;
using tcp = asio::ip::tcp;
using error = boost::system::error_code;

// `what`: the setting that names it, `page` or `twin`.
inline std::string file_of(const std::string& name, const std::string& what) {
  if (name.empty()) return {};
  std::ifstream file(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file || text.empty())
    throw refused((what == "twin" ? "--twin, or " : "") + ("door_settings::" + what) + ": the file " + name +
                  " can't be read, or is empty");
  return text;
}

inline std::string text_of(const tcp::endpoint& end) {
  const std::string address = end.address().to_string();
  return (end.address().is_v6() ? "[" + address + "]" : address) + ":" + std::to_string(end.port());
}

// Where a door that listens everywhere is for others: the addresses of this machine, but those that only it
// knows, or only one link. Without a network, the address that only it knows.
inline std::vector<tcp::endpoint> seen_at(const tcp::endpoint& end) {
  if (!end.address().is_unspecified()) return {end};
  const bool is_v6 = end.address().is_v6();
  std::vector<tcp::endpoint> all;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) first = nullptr;
  for (const ifaddrs* one = first; one; one = one->ifa_next) {
    if (!one->ifa_addr || (one->ifa_flags & IFF_UP) == 0) continue;
    asio::ip::address address;
    if (!is_v6 && one->ifa_addr->sa_family == AF_INET) {
      sockaddr_in is{};
      std::memcpy(&is, one->ifa_addr, sizeof is);
      address = asio::ip::address_v4(ntohl(is.sin_addr.s_addr));
    } else if (is_v6 && one->ifa_addr->sa_family == AF_INET6) {
      sockaddr_in6 is{};
      std::memcpy(&is, one->ifa_addr, sizeof is);
      asio::ip::address_v6::bytes_type bytes;
      std::memcpy(bytes.data(), &is.sin6_addr, bytes.size());
      const asio::ip::address_v6 found(bytes);
      if (!found.is_link_local()) address = found;
    }
    if (!address.is_unspecified() && !address.is_loopback()) all.emplace_back(address, end.port());
  }
  if (first) ::freeifaddrs(first);
  if (all.empty() && is_v6) all.emplace_back(asio::ip::address_v6::loopback(), end.port());
  if (all.empty()) all.emplace_back(asio::ip::address_v4::loopback(), end.port());
  return all;
}

inline void listen(tcp::acceptor& acceptor, const door_settings& settings) {
  error wrong;
  const auto address = asio::ip::make_address(settings.address, wrong);
  if (wrong)
    throw refused("a door can't listen at " + settings.address +
                  ": it is no address; 127.0.0.1 is this machine only");
  const tcp::endpoint end(address, settings.port);
  const auto check = [&] {
    if (wrong)
      throw refused("a door can't listen at " + text_of(end) + ": " + wrong.message() +
                    ". Is another program there? Port 0 takes any that is free");
  };
  acceptor.open(end.protocol(), wrong), check();
  keep_from_children(acceptor.native_handle());
  acceptor.set_option(asio::socket_base::reuse_address(true), wrong), check();
  acceptor.bind(end, wrong), check();
  acceptor.listen(1024, wrong), check();
  acceptor.non_blocking(true, wrong), check();
}

// A socket, from its greeting to its end. It lives while a read or a write of it is under way.
struct connection {
  explicit connection(tcp::socket s, std::size_t most, time_point until)
      : socket(std::move(s)), frames(most), deadline(until) {}
  tcp::socket socket;
  door_network::frame_reader frames;
  door_network::door_client* client = nullptr;
  std::string greeting{}, sending{};
  std::string_view sending_then{};  // the page: one copy for all
  std::array<char, 16384> piece;
  time_point deadline;
  bool is_writing = false, ends_after_write = false, is_open = true;
  bool has_deadline = true;  // of its greeting, or of its end
};

}  // namespace cca::detail::door_network
