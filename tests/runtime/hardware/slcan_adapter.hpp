// A CAN adapter on a serial line, played by the test: the kernel's slcan driver is at one end of a
// pseudo-terminal, this class at the other. It can go bus-off and stop listening, which no emulated
// controller does. For the laws it is an end of a bus like any other. Source: Linux, drivers/net/can/slcan;
// Lawicel's CAN232 commands (t, T, r, R; s and e for states, as the driver of Linux 6 reads them).
#pragma once

#include <array>
#include <atomic>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cca/hardware/socket_can.hpp>

#include "can_rigs.hpp"

namespace can_rigs {

class slcan_adapter {
public:
  slcan_adapter() {
    master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    REQUIRE(master >= 0);
    REQUIRE(grantpt(master) == 0);
    REQUIRE(unlockpt(master) == 0);
    line = open(ptsname(master), O_RDWR | O_NOCTTY);
    REQUIRE(line >= 0);
    for (const int fd : {master, line}) {
      termios t{};
      tcgetattr(fd, &t);
      cfmakeraw(&t);
      tcsetattr(fd, TCSANOW, &t);
    }
    reader = std::thread([this] { read_on(); });  // the driver waits until its commands are read
    const int discipline = 17;                    // N_SLCAN
    REQUIRE(ioctl(line, TIOCSETD, &discipline) == 0);
    ifreq r{};
    REQUIRE(ioctl(line, SIOCGIFNAME, &r) == 0);
    interface = r.ifr_name;
    REQUIRE(std::system(("/bin/ip link set " + interface + " type can bitrate 500000").c_str()) == 0);
    REQUIRE(set_link(interface, true));
  }
  ~slcan_adapter() {
    set_link(interface, false);
    ends = true;
    reader.join();
    close(line);
    close(master);
  }
  slcan_adapter(const slcan_adapter&) = delete;
  slcan_adapter& operator=(const slcan_adapter&) = delete;

  std::size_t letters() {
    const std::lock_guard hold(mutex);
    return all_letters;
  }
  const std::string& name() const { return interface; }
  void say(const std::string& text) {
    const std::string with_end = text + "\r";
    REQUIRE(write(master, with_end.data(), with_end.size()) == static_cast<ssize_t>(with_end.size()));
  }
  void listen(bool to) { listens = to; }

  send_result send(std::span<const cca::hardware::can_frame> frames) noexcept {
    send_result result;
    for (const auto& f : frames) {
      if (!f.valid() || f.fd) {
        ++count.invalid;
        result.outcome = send_outcome::invalid;
        continue;
      }
      char text[32];
      int n = std::snprintf(text, sizeof text, f.id.extended ? "%c%08X%u" : "%c%03X%u",
                            f.remote ? (f.id.extended ? 'R' : 'r') : (f.id.extended ? 'T' : 't'), f.id.number,
                            unsigned{f.length});
      for (const auto byte : f.payload())
        n += std::snprintf(text + n, sizeof text - static_cast<std::size_t>(n), "%02X", unsigned{byte});
      say(text);
      ++result.sent;
    }
    count.sent += result.sent;
    count.confirmed += result.sent;
    return result;
  }
  std::size_t receive(std::span<received_frame> into) noexcept {
    const std::lock_guard hold(mutex);
    std::size_t n = 0;
    for (std::size_t end; n < into.size() && (end = heard.find('\r')) != std::string::npos;
         heard.erase(0, end + 1))
      n += parse(heard.substr(0, end), into[n]);
    return n;
  }
  bus_state state() const noexcept { return bus_state::active; }
  const bus_counters& counters() const noexcept { return count; }
  std::uint64_t in_flight() const noexcept { return 0; }

private:
  void read_on() {
    while (!ends) {
      pollfd p{master, POLLIN, 0};
      if (!listens) wait_ms(1);
      if (!listens || poll(&p, 1, 10) <= 0) continue;
      char some[512];
      const ssize_t n = read(master, some, sizeof some);
      const std::lock_guard hold(mutex);
      if (n <= 0) continue;
      heard.append(some, static_cast<std::size_t>(n));
      all_letters += static_cast<std::size_t>(n);
    }
  }

  // Only frames; the commands that set up the adapter (C, O, S6) are skipped.
  std::size_t parse(const std::string& text, received_frame& into) {
    if (text.empty() || std::string("tTrR").find(text[0]) == std::string::npos) return 0;
    const bool extended = std::isupper(static_cast<unsigned char>(text[0])) != 0;
    const std::size_t digits = extended ? 8 : 3;
    into = {};
    into.frame.id = {static_cast<std::uint32_t>(std::stoul(text.substr(1, digits), nullptr, 16)), extended};
    into.frame.remote = std::tolower(text[0]) == 'r';
    into.frame.length = static_cast<std::uint8_t>(text[1 + digits] - '0');
    for (std::size_t i = 0; i < into.frame.payload().size(); ++i)
      into.frame.data[i] =
          static_cast<std::uint8_t>(std::stoul(text.substr(2 + digits + 2 * i, 2), nullptr, 16));
    ++count.received;
    return 1;
  }

  int master = -1, line = -1;
  std::string interface, heard;
  std::size_t all_letters = 0;
  bus_counters count{};
  std::atomic<bool> listens = true, ends = false;
  std::mutex mutex;
  std::thread reader;
};
static_assert(CanBus<slcan_adapter>);

// The kernel's end and the adapter's. It goes away by bus-off, like a controller that only heard errors.
struct slcan {
  static constexpr bool has_fd = false;
  static constexpr int rounds = 8;
  slcan_adapter adapter;
  socket_can bus{adapter.name()};

  struct either {
    slcan* rig;
    std::size_t i;
    send_result send(std::span<const cca::hardware::can_frame> f) noexcept {
      return i == 0 ? rig->bus.send(f) : rig->adapter.send(f);
    }
    std::size_t receive(std::span<received_frame> f) noexcept {
      return i == 0 ? rig->bus.receive(f) : rig->adapter.receive(f);
    }
    bus_state state() const noexcept { return i == 0 ? rig->bus.state() : rig->adapter.state(); }
    const bus_counters& counters() const noexcept {
      return i == 0 ? rig->bus.counters() : rig->adapter.counters();
    }
    std::uint64_t in_flight() const noexcept { return i == 0 ? rig->bus.in_flight() : 0; }
  };
  either end(std::size_t i) { return {this, i}; }
  // A frame takes up to 30 ms here, so wait until nothing has come for 100 ms.
  void settle() {
    std::size_t before = 0;
    do {
      before = adapter.letters();
      wait_ms(100);
    } while (adapter.letters() != before);
  }
  void away(std::size_t) {
    adapter.say("sb000255");
    settle();
  }
  void back(std::size_t) {
    REQUIRE(set_link(adapter.name(), false));
    REQUIRE(set_link(adapter.name(), true));
    settle();
  }
};

}  // namespace can_rigs
