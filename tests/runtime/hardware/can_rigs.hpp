// Real CAN for the tests: interfaces of this machine, or of the guest that the preset test-can-guest boots
// (tests/can_guest). In a guest (CCA_CAN_GUEST is set) a missing interface fails the test; elsewhere the test
// says that it was left out.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include <doctest/doctest.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <cca/hardware/socket_can.hpp>

namespace can_rigs {

using namespace cca::hardware;

inline bool in_guest() { return std::getenv("CCA_CAN_GUEST") != nullptr; }

inline void wait_ms(long ms) {
  const timespec t{ms / 1000, ms % 1000 * 1'000'000};
  nanosleep(&t, nullptr);
}

// Like `ip link set NAME up`; false: we may not. The kernel lets frames through some time later, after
// bus-off up to a second.
inline bool set_link(const std::string& name, bool up) {
  const int fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ifreq request{};
  name.copy(request.ifr_name, IFNAMSIZ - 1);
  bool done = ioctl(fd, SIOCGIFFLAGS, &request) == 0;
  request.ifr_flags = static_cast<short>(up ? request.ifr_flags | IFF_UP : request.ifr_flags & ~IFF_UP);
  done = done && ioctl(fd, SIOCSIFFLAGS, &request) == 0;
  for (int i = 0; done && up && i < 3000 && (request.ifr_flags & IFF_RUNNING) == 0; ++i) {
    wait_ms(1);
    ioctl(fd, SIOCGIFFLAGS, &request);
  }
  const int why = errno;
  close(fd);
  if (!done) MESSAGE("setting " << name << (up ? " up: " : " down: ") << std::string(std::strerror(why)));
  return done;
}

// Whether the test can run. Where it must run and can't, it fails.
inline bool present(const char* name) {
  std::string why;
  try {
    const socket_can bus(name);
    if (set_link(name, true)) return true;
    why = std::string("no right to set ") + name + " up and down";
  } catch (const cca::refused& r) { why = r.what(); }
  if (in_guest()) FAIL("the guest lacks: " << why);
  MESSAGE("left out: " << why);
  return false;
}

// Two sockets on one virtual interface.
struct vcan {
  static constexpr bool has_fd = true;
  static constexpr std::size_t most_waiting = 16;
  static constexpr const char* names[] = {"vcan0", "vcan0"};
  explicit vcan(const socket_can_options& o = {.fd = true}) : a("vcan0", o), b("vcan0", o) {}
  socket_can a, b;

  socket_can& end(std::size_t i) { return i == 0 ? a : b; }
  void settle() { wait_ms(2); }
  void away(std::size_t) { REQUIRE(set_link("vcan0", false)); }
  void back(std::size_t) { REQUIRE(set_link("vcan0", true)); }
  ~vcan() { set_link("vcan0", true); }
};

// The same without confirmations and times.
struct frugal_vcan : vcan {
  frugal_vcan() : vcan({.fd = true, .confirmations = false, .times = false}) {}
};

// Two controllers on one bus, as QEMU emulates them (SJA1000).
struct controllers {
  static constexpr bool has_fd = false, asks_for_bytes = false;
  static constexpr std::size_t most_waiting = 16;
  socket_can a{"can0"}, b{"can1"};

  socket_can& end(std::size_t i) { return i == 0 ? a : b; }
  void settle() { wait_ms(40); }  // an emulated card on a busy machine is slow
  void away(std::size_t) { REQUIRE(set_link("can0", false)); }
  void back(std::size_t) { REQUIRE(set_link("can0", true)); }
  ~controllers() { set_link("can0", true); }
};

}  // namespace can_rigs
