// The CAN interfaces of this machine with their states, bit rates and counters, from the kernel by rtnetlink.
// Source: Linux, include/uapi/linux/if_link.h and can/netlink.h.
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/socket.h>

#include <cca/hardware/bus/can_interface.hpp>

namespace cca_can {

namespace hw = cca::hardware;

struct bus_info {
  std::string name, kind;  // "vcan", "can", ...; empty: the kernel does not say
  bool up = false, fd = false;
  std::string state;  // the controller's; empty: there is none
  std::uint32_t bit_rate = 0, data_rate = 0;
  std::uint64_t received = 0, sent = 0, receive_errors = 0, send_errors = 0, dropped = 0;
  std::uint32_t bus_offs = 0, restarts = 0;
  std::uint16_t transmit_count = 0, receive_count = 0;  // the controller's error counters
};

namespace detail {

// Reads nothing past `bytes`, whatever they are.
template <class F>
void each_attribute(std::span<const std::byte> bytes, F&& f) {
  while (bytes.size() >= sizeof(rtattr)) {
    rtattr head;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.rta_len < sizeof head || head.rta_len > bytes.size()) return;
    f(head.rta_type & NLA_TYPE_MASK, bytes.subspan(sizeof head, head.rta_len - sizeof head));
    bytes = bytes.subspan(std::min<std::size_t>(RTA_ALIGN(head.rta_len), bytes.size()));
  }
}

template <class Value>
bool copy_to(Value& value, std::span<const std::byte> bytes) {
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  return true;
}

inline std::string text_in(std::span<const std::byte> bytes) {
  const char* const text = reinterpret_cast<const char*>(bytes.data());
  return {text, strnlen(text, bytes.size())};
}

inline void read_controller(std::span<const std::byte> bytes, bus_info& b) {
  each_attribute(bytes, [&b](int type, std::span<const std::byte> value) {
    can_bittiming timing{};
    can_berr_counter errors{};
    std::uint32_t state = 0;
    if (type == IFLA_CAN_BITTIMING && copy_to(timing, value)) b.bit_rate = timing.bitrate;
    if (type == IFLA_CAN_DATA_BITTIMING && copy_to(timing, value)) b.data_rate = timing.bitrate;
    if (type == IFLA_CAN_BERR_COUNTER && copy_to(errors, value))
      b.transmit_count = errors.txerr, b.receive_count = errors.rxerr;
    if (type == IFLA_CAN_STATE && copy_to(state, value)) {
      constexpr std::array names{"active", "warning", "passive", "bus-off", "stopped", "sleeping"};
      if (state < names.size()) b.state = names[state];
    }
  });
}

inline void read_kind(std::span<const std::byte> bytes, bus_info& b) {
  each_attribute(bytes, [&b](int type, std::span<const std::byte> value) {
    can_device_stats counted{};
    if (type == IFLA_INFO_KIND) b.kind = text_in(value);
    if (type == IFLA_INFO_DATA) read_controller(value, b);
    if (type == IFLA_INFO_XSTATS && copy_to(counted, value))
      b.bus_offs = counted.bus_off, b.restarts = counted.restarts;
  });
}

// One message of the kernel's answer; false: it is about no CAN interface.
inline bool read_interface(std::span<const std::byte> message, bus_info& b) {
  ifinfomsg head;
  if (!copy_to(head, message) || head.ifi_type != ARPHRD_CAN) return false;
  b.up = (head.ifi_flags & IFF_UP) != 0;
  each_attribute(message.subspan(std::min<std::size_t>(NLMSG_ALIGN(sizeof head), message.size())),
                 [&b](int type, std::span<const std::byte> value) {
                   rtnl_link_stats64 counted{};
                   std::uint32_t mtu = 0;
                   if (type == IFLA_IFNAME) b.name = text_in(value);
                   if (type == IFLA_MTU && copy_to(mtu, value)) b.fd = mtu == hw::detail::fd_size;
                   if (type == IFLA_LINKINFO) read_kind(value, b);
                   if (type == IFLA_STATS64 && copy_to(counted, value)) {
                     b.received = counted.rx_packets, b.sent = counted.tx_packets;
                     b.receive_errors = counted.rx_errors, b.send_errors = counted.tx_errors;
                     b.dropped = counted.rx_dropped + counted.tx_dropped + counted.rx_over_errors;
                   }
                 });
  return true;
}

}  // namespace detail

// Throws cca::refused if the kernel does not answer.
inline std::vector<bus_info> can_interfaces() {
  const hw::detail::file_descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  struct {
    nlmsghdr head;
    ifinfomsg what;
  } request{};
  request.head.nlmsg_len = sizeof request;
  request.head.nlmsg_type = RTM_GETLINK;
  request.head.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
  const auto fails = [] {
    return cca::refused(std::string("the kernel does not list its interfaces: ") + std::strerror(errno));
  };
  if (socket.get() < 0 || ::send(socket.get(), &request, sizeof request, 0) < 0) throw fails();
  std::vector<bus_info> all;
  std::vector<std::byte> buffer(65536);
  for (;;) {
    const auto got = ::recv(socket.get(), buffer.data(), buffer.size(), 0);
    if (got <= 0) throw fails();
    auto left = std::span<const std::byte>(buffer).first(static_cast<std::size_t>(got));
    while (left.size() >= sizeof(nlmsghdr)) {
      nlmsghdr head;
      std::memcpy(&head, left.data(), sizeof head);
      if (head.nlmsg_type == NLMSG_DONE || head.nlmsg_type == NLMSG_ERROR) return all;
      if (head.nlmsg_len < sizeof head || head.nlmsg_len > left.size()) return all;
      bus_info b;
      if (detail::read_interface(left.subspan(NLMSG_HDRLEN, head.nlmsg_len - NLMSG_HDRLEN), b))
        all.push_back(b);
      left = left.subspan(std::min<std::size_t>(NLMSG_ALIGN(head.nlmsg_len), left.size()));
    }
  }
}

inline std::string text_of(const bus_info& b) {
  std::string all = b.name + "  " + (!b.up ? "down" : b.state.empty() ? "up" : b.state);
  if (!b.kind.empty() && b.kind != "can") all += "  " + b.kind;
  if (b.bit_rate) all += "  " + std::to_string(b.bit_rate) + " bit/s";
  if (b.data_rate) all += ", data " + std::to_string(b.data_rate) + " bit/s";
  if (b.fd) all += "  FD";
  all += "  received " + std::to_string(b.received) + ", sent " + std::to_string(b.sent) + ", errors " +
         std::to_string(b.receive_errors + b.send_errors) + ", dropped " + std::to_string(b.dropped);
  if (b.bus_offs || b.restarts) all += ", bus-off " + std::to_string(b.bus_offs) + " times";
  if (b.transmit_count || b.receive_count)
    all += ", error counters " + std::to_string(b.transmit_count) + " and " + std::to_string(b.receive_count);
  return all;
}

}  // namespace cca_can
