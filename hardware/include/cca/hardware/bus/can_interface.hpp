// Opens a raw CAN socket on an interface, and asks for the interface's state. Opening happens outside of the
// loop: it throws cca::refused and says what to do. Asking does not throw.
//
// Filters are the kernel's; it finds exact ones in a table. Binding to a name that does not exist would mean
// all interfaces, so the name is checked first, and whether it is a CAN interface.
#pragma once

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cca/base/refused.hpp>
#include <cca/hardware/bus/kernel_frame.hpp>

namespace cca::hardware::detail {

class file_descriptor {
public:
  explicit file_descriptor(int number = -1) noexcept : fd(number) {}
  file_descriptor(file_descriptor&& other) noexcept : fd(std::exchange(other.fd, -1)) {}
  file_descriptor& operator=(file_descriptor&& other) noexcept {
    std::swap(fd, other.fd);
    return *this;
  }
  ~file_descriptor() {
    if (fd >= 0) ::close(fd);
  }
  int get() const noexcept { return fd; }

private:
  int fd;
};

using interface_name = std::array<char, IFNAMSIZ>;

enum class link : std::uint8_t { gone, down, no_carrier, up };

class can_interface {
public:
  can_interface() = default;
  explicit can_interface(std::string_view which) {
    if (which.empty() || which.size() >= IFNAMSIZ)
      throw refused("socket_can: `" + std::string(which) + "` is no name of an interface");
    std::memcpy(name.data(), which.data(), which.size());
  }

  // Through a socket of any kind.
  link state(int fd) const noexcept {
    ifreq request = named_request();
    if (::ioctl(fd, SIOCGIFFLAGS, &request) != 0) return link::gone;
    const unsigned flags = static_cast<unsigned short>(request.ifr_flags);
    return (flags & IFF_UP) == 0 ? link::down : (flags & IFF_RUNNING) == 0 ? link::no_carrier : link::up;
  }
  int index(int fd) const noexcept {
    ifreq request = named_request();
    return ::ioctl(fd, SIOCGIFINDEX, &request) == 0 ? request.ifr_ifindex : 0;
  }
  int mtu(int fd) const noexcept {
    ifreq request = named_request();
    return ::ioctl(fd, SIOCGIFMTU, &request) == 0 ? request.ifr_mtu : 0;
  }
  bool is_can(int fd) const noexcept {
    ifreq request = named_request();
    return ::ioctl(fd, SIOCGIFHWADDR, &request) == 0 && request.ifr_hwaddr.sa_family == ARPHRD_CAN;
  }
  bool bind(int fd) const noexcept {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = index(fd);
    return address.can_ifindex != 0 &&
           ::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  std::string text() const { return name.data(); }

private:
  ifreq named_request() const noexcept {
    ifreq request{};
    std::memcpy(request.ifr_name, name.data(), name.size());
    return request;
  }
  interface_name name{};
};

// "can0, vcan0", or "none".
inline std::string names_of_can_interfaces(int fd) {
  std::string names;
  if (auto* const all = if_nameindex()) {
    for (auto* each = all; each->if_index != 0; ++each)
      if (can_interface(each->if_name).is_can(fd))
        names += (names.empty() ? "" : ", ") + std::string(each->if_name);
    if_freenameindex(all);
  }
  return names.empty() ? "none" : names;
}

template <class Value>
void set_option(int fd, int level, int option, const Value& value, const char* what) {
  if (::setsockopt(fd, level, option, &value, sizeof value) != 0)
    throw refused(std::string("socket_can: the kernel refuses ") + what + ": " + std::strerror(errno));
}

struct socket_wishes {
  bool fd = false, own_frames = true, times = true;
};

// An empty `let_through` means all frames.
inline file_descriptor open_can(const can_interface& which,
                                std::span<const can_filter> let_through,
                                socket_wishes wanted) {
  file_descriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  const int fd = socket.get();
  if (fd < 0) {
    throw refused(errno == EAFNOSUPPORT ? "socket_can: this kernel has no CAN: load the modules can and "
                                          "can-raw, or use a kernel that has them"
                                        : std::string("socket_can: no socket: ") + std::strerror(errno));
  }
  if (which.index(fd) == 0)
    throw refused("socket_can: there is no interface `" + which.text() +
                  "`; those with CAN: " + names_of_can_interfaces(fd));
  if (!which.is_can(fd))
    throw refused("socket_can: `" + which.text() +
                  "` is no CAN interface; those with CAN: " + names_of_can_interfaces(fd));
  if (wanted.fd && which.mtu(fd) != fd_size) {
    throw refused("socket_can: `" + which.text() + "` takes no FD frames: with the link down, `ip link set " +
                  which.text() + " type can fd on` with a `dbitrate` (vcan: `mtu 72`)");
  }
  if (let_through.size() > CAN_RAW_FILTER_MAX) throw refused("socket_can: more than 512 filters; use masks");
  if (!let_through.empty()) {
    std::vector<::can_filter> filters;
    for (const can_filter& f : let_through) filters.push_back(to_kernel(f));
    if (::setsockopt(fd, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                     static_cast<socklen_t>(filters.size() * sizeof(::can_filter))) != 0)
      throw refused(std::string("socket_can: the kernel refuses the filters: ") + std::strerror(errno));
  }
  const int yes = 1;
  // Without BUSERROR: a bus in trouble would flood the socket with it.
  set_option(fd, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, can_err_mask_t{CAN_ERR_MASK & ~CAN_ERR_BUSERROR},
             "error frames");
  if (wanted.own_frames) set_option(fd, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, yes, "confirmations");
  if (wanted.fd) set_option(fd, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, yes, "FD frames");
  if (wanted.times) set_option(fd, SOL_SOCKET, SO_TIMESTAMPNS, yes, "timestamps");
  if (!which.bind(fd))
    throw refused("socket_can: cannot bind to `" + which.text() + "`: " + std::strerror(errno));
  return socket;
}

}  // namespace cca::hardware::detail
