// A CAN bus by Linux SocketCAN.
//
//   cca::hardware::socket_can bus("can0", {.replies = replies, .ours = requests, .fd = true});
//
// `replies`: the ids to let through, a filter of the kernel each; none: all. `ours`: the ids that only we send; a frame of
// another sender under one of them counts as an intruder. They are let through as well, since own frames come back as
// confirmations (from drivers that echo, when they went over the bus; from the others, when they were taken).
//
// What the kernel calls errors are states here. ENETDOWN, ENODEV: down; it comes back by itself, also when the adapter was pulled
// and put in again. Error frames: warning, passive, bus-off, restarted. ENOBUFS, EAGAIN, or as many frames in flight as
// `most_in_flight`: full. Make that one batch: then no set-point waits behind an older one.
// A controller in one-shot does not tell which frames it gave up. Say `gives_up_after`, most of a beat: what is not confirmed by
// then counts as dropped and no longer as in flight.
// Bus-off: the kernel may hold frames of the last batch, and send them when the controller is restarted. Leave `restart-ms` 0,
// and restart by `ip link set can0 down` and `up`: then it forgets them. `stale()` counts those that went out all the same.
//
// Times are the kernel's of arrival, moved to the monotonic clock. Constructing throws cca::refused; nothing else throws, waits
// or allocates. Remote frames pass only without filters. Cost: one system call a batch of up to 32 frames received or sent, and a
// second one to learn that no more are there. Not to be copied; a controller that is to be copied holds a pointer to it. Laws:
// tests/laws/can_bus_laws.hpp, in tests/runtime/hardware/socket_can.cpp. Source: Linux, Documentation/networking/can.rst;
// lely-core, io2/linux/can_chan.c, for ENOBUFS. docs/can_bus.md.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <linux/sock_diag.h>
#include <sys/socket.h>
#include <sys/uio.h>

#include <cca/hardware/can_bus.hpp>
#include <cca/hardware/can_interface.hpp>
#include <cca/hardware/kernel_frame.hpp>

namespace cca::hardware {

struct socket_can_options {
  std::span<const can_filter> replies{};
  std::span<const can_filter> ours{};
  bool fd = false;
  std::uint64_t most_in_flight = 16;
  std::int64_t gives_up_after = 0;  // ns; 0: the controller tries until it succeeds
};

class socket_can {
public:
  explicit socket_can(std::string_view name, const socket_can_options& o = {})
      : interface(name), socket(detail::open_can(interface, let_through(o), o.fd)), ours(o.ours.begin(), o.ours.end()),
        most_in_flight(o.most_in_flight), gives_up_after(o.gives_up_after), with_fd(o.fd), work(std::make_unique<buffers>()) {
    const detail::link now = interface.state(socket.get());
    carrier_was_lost = now == detail::link::no_carrier;
    seen = now == detail::link::up ? bus_state::active : now == detail::link::no_carrier ? bus_state::bus_off : bus_state::down;
  }

  send_result send(std::span<const can_frame> frames) noexcept {
    send_result result;
    const auto refuse = [&result](send_outcome why, std::uint64_t& counter, std::size_t n) {
      counter += n;
      if (n > 0 && result.outcome == send_outcome::sent) result.outcome = why;
    };
    if (gives_up_after > 0) sent_at = nanoseconds_of(CLOCK_MONOTONIC);
    while (!frames.empty()) {
      if (is_away(seen)) {
        refuse(send_outcome::away, count.dropped_away, frames.size());
        break;
      }
      std::size_t used = 0, n = 0;
      const std::size_t room = static_cast<std::size_t>(std::min<std::uint64_t>(room_in_flight(), batch));
      for (; used < frames.size() && n < room; ++used) {
        if (!frames[used].valid() || (frames[used].fd && !with_fd)) refuse(send_outcome::invalid, count.invalid, 1);
        else work->put(n++, frames[used]);
      }
      if (room == 0) {
        refuse(send_outcome::full, count.dropped_full, frames.size());
        break;
      }
      frames = frames.subspan(used);
      for (std::size_t first = 0; first < n;) {
        const int done = ::sendmmsg(socket.get(), &work->out[first], static_cast<unsigned>(n - first), MSG_DONTWAIT);
        if (done > 0) {
          first += static_cast<std::size_t>(done);
          count.sent += static_cast<std::uint64_t>(done);
          result.sent += static_cast<std::size_t>(done);
          unconfirmed += static_cast<std::uint64_t>(done);
        } else if (errno == EINVAL) {
          refuse(send_outcome::invalid, count.invalid, 1);
          ++first;
        } else if (errno != EINTR) {
          const bool full = errno == ENOBUFS || errno == EAGAIN;
          if (!full) went_down();
          refuse(full ? send_outcome::full : send_outcome::away, full ? count.dropped_full : count.dropped_away,
                 n - first + frames.size());
          return result;
        }
      }
    }
    return result;
  }

  std::size_t receive(std::span<received_frame> into) noexcept {
    if (is_away(seen)) look_whether_back();
    std::size_t n = 0;
    bool told = false;
    while (n < into.size()) {
      const std::size_t asked = std::min(batch, into.size() - n);
      work->ask(asked);
      const int got = ::recvmmsg(socket.get(), work->in.data(), static_cast<unsigned>(asked), MSG_DONTWAIT, nullptr);
      if (got < 0) {
        if (errno == EINTR) continue;
        if (told || (errno != ENETDOWN && errno != ENODEV && errno != ENXIO)) break;
        told = true;  // the kernel says so once; what had come before is still to be had
        went_down();
        look_whether_back();
        continue;
      }
      if (got == 0) break;
      const std::int64_t to_monotonic = nanoseconds_of(CLOCK_MONOTONIC) - nanoseconds_of(CLOCK_REALTIME);
      for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) n += take(i, to_monotonic, into[n]);
    }
    if (gives_up_after > 0 && unconfirmed > 0 && nanoseconds_of(CLOCK_MONOTONIC) - sent_at > gives_up_after) forget_in_flight();
    return n;
  }

  bus_state state() const noexcept { return seen; }
  const bus_counters& counters() const noexcept { return count; }
  std::uint64_t in_flight() const noexcept { return unconfirmed; }
  std::uint64_t stale() const noexcept { return confirmed_stale; }
  int file() const noexcept { return socket.get(); }  // to wait for with poll, outside of a beat

private:
  static constexpr std::size_t batch = 32;

  struct buffers {
    std::array<mmsghdr, batch> in{}, out{};
    std::array<iovec, batch> in_parts{}, out_parts{};
    std::array<canfd_frame, batch> in_frames{}, out_frames{};
    struct alignas(cmsghdr) control {
      std::array<std::byte, CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))> bytes;
    };
    std::array<control, batch> in_control{};

    void put(std::size_t i, const can_frame& f) noexcept {
      out_frames[i] = detail::to_kernel(f);
      out_parts[i] = {&out_frames[i], detail::kernel_size(f)};
      out[i].msg_hdr = {};
      out[i].msg_hdr.msg_iov = &out_parts[i];
      out[i].msg_hdr.msg_iovlen = 1;
    }
    void ask(std::size_t n) noexcept {
      for (std::size_t i = 0; i < n; ++i) {
        in_parts[i] = {&in_frames[i], sizeof in_frames[i]};
        in[i].msg_hdr = {};
        in[i].msg_hdr.msg_iov = &in_parts[i];
        in[i].msg_hdr.msg_iovlen = 1;
        in[i].msg_hdr.msg_control = in_control[i].bytes.data();
        in[i].msg_hdr.msg_controllen = in_control[i].bytes.size();
      }
    }
  };

  static std::vector<can_filter> let_through(const socket_can_options& o) {
    std::vector<can_filter> all(o.replies.begin(), o.replies.end());
    if (!all.empty()) all.insert(all.end(), o.ours.begin(), o.ours.end());
    return all;
  }
  static std::int64_t nanoseconds_of(clockid_t clock) noexcept {
    timespec t{};
    ::clock_gettime(clock, &t);
    return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
  }

  // One of the messages of a batch: 1 if it is for the caller.
  std::size_t take(std::size_t i, std::int64_t to_monotonic, received_frame& into) noexcept {
    msghdr& head = work->in[i].msg_hdr;
    std::int64_t time = 0;
    for (cmsghdr* c = CMSG_FIRSTHDR(&head); c; c = CMSG_NXTHDR(&head, c)) {
      if (c->cmsg_level != SOL_SOCKET) continue;
      if (c->cmsg_type == SO_TIMESTAMPNS) {
        timespec t;
        std::memcpy(&t, CMSG_DATA(c), sizeof t);
        time = t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec + to_monotonic;
      } else if (c->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t lost;
        std::memcpy(&lost, CMSG_DATA(c), sizeof lost);
        count.lost += lost - lost_before;  // wraps
        lost_before = lost;
      }
    }
    const canfd_frame& k = work->in_frames[i];
    const std::size_t size = work->in[i].msg_len;
    if (size != detail::classic_size && size != detail::fd_size) return 0;
    if (detail::is_error(k)) {
      if (seen != bus_state::down) seen = detail::after_error(seen, k, count);
      if (seen == bus_state::bus_off) stale_to_come = unconfirmed, carrier_was_lost = false;
      return 0;
    }
    const can_frame frame = detail::from_kernel(k, size);
    if ((head.msg_flags & MSG_CONFIRM) != 0) {
      ++count.confirmed;
      if (unconfirmed > 0) --unconfirmed;
      if (stale_to_come > 0) --stale_to_come, ++confirmed_stale;
      return 0;
    }
    for (const can_filter& f : ours)
      if (f.matches(frame.id) && !frame.remote) return ++count.intruders, 0;
    ++count.received;
    last_time = std::max(last_time, time);  // the real-time clock may be set back
    into = {frame, last_time};
    return 1;
  }

  void went_down() noexcept {
    if (seen == bus_state::down) return;
    seen = bus_state::down;
    ++count.downs;
    forget_in_flight();  // the kernel does as well
  }

  void look_whether_back() noexcept {
    const detail::link now = interface.state(socket.get());
    if (seen == bus_state::bus_off) {  // the error frame that tells of the restart may have been lost
      if (now == detail::link::no_carrier) carrier_was_lost = true;
      if (now != detail::link::up || !carrier_was_lost) return;
      ++count.restarts;
    } else {
      if (now == detail::link::gone) was_gone = true;
      if (now != detail::link::up) return;
      if (was_gone && !interface.bind(socket.get())) return;
      was_gone = false;
      ++count.ups;
    }
    seen = bus_state::active;
  }

  void forget_in_flight() noexcept {
    count.dropped_away += unconfirmed;
    unconfirmed = stale_to_come = 0;
  }

  // A confirmation may be lost with the receive queue: then the kernel knows better what it still holds.
  std::uint64_t room_in_flight() noexcept {
    if (unconfirmed >= most_in_flight) {
      std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
      socklen_t size = sizeof memory;
      if (::getsockopt(socket.get(), SOL_SOCKET, SO_MEMINFO, memory.data(), &size) == 0 && memory[SK_MEMINFO_WMEM_ALLOC] == 0)
        unconfirmed = 0;
    }
    return most_in_flight - std::min(unconfirmed, most_in_flight);
  }

  detail::can_interface interface;
  detail::file_descriptor socket;
  std::vector<can_filter> ours;
  std::uint64_t most_in_flight;
  std::int64_t gives_up_after, sent_at = 0;
  bool with_fd;
  std::unique_ptr<buffers> work;
  bus_state seen = bus_state::down;
  bus_counters count{};
  std::uint64_t unconfirmed = 0, stale_to_come = 0, confirmed_stale = 0;
  std::uint32_t lost_before = 0;
  std::int64_t last_time = 0;
  bool carrier_was_lost = false, was_gone = false;
};

static_assert(CanBus<socket_can>);

}  // namespace cca::hardware
