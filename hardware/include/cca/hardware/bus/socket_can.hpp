// A CAN bus by Linux SocketCAN.
//
//   cca::hardware::socket_can bus("can0", {.replies = replies, .ours = requests, .fd = true});
//
// Options
//   replies         the ids to let through, by the kernel's filters; empty: all
//   ours            the ids that only we send. A frame of another sender under one of them counts as an
//                   intruder. They are let through too, since own frames come back as confirmations: from
//                   drivers that echo, when the frame went over the bus; from others, when the driver took it
//   most_in_flight  more unconfirmed frames than this are `full`. Make it one batch: then no set point waits
//                   after an older one
//   gives_up_after  for controllers in one-shot mode, which do not say which frames they gave up: most of a
//                   beat. A frame that is not confirmed by then counts as dropped and is no longer in flight
//   confirmations   false: own frames don't come back. Then `in_flight` is what the kernel still holds, and
//                   it is unknown what waits in the controller: only for buses on which nothing moves
//   times           false: a frame's time is that of `receive`
// docs/can_bus.md says what confirmations and times cost.
//
// Errors of the kernel become states. ENETDOWN, ENODEV: down; the bus comes back by itself, also after the
// adapter was unplugged and plugged in again. Error frames: warning, passive, bus-off, restarted. ENOBUFS,
// EAGAIN: full. After bus-off the kernel may hold frames of the last batch and send them when the controller
// is restarted. Leave `restart-ms` at 0 and restart by `ip link set can0 down` and `up`: then the kernel
// drops them. `stale()` counts those that went out all the same.
//
// Times of arrival are the kernel's, moved to the monotonic clock, and never in its future. The constructor
// throws cca::refused; nothing else throws, waits or allocates. Remote frames pass only without filters.
// Cost: one system call per batch of up to 32 frames, sent or received. A socket can't be copied; a
// controller that shall be copied holds a pointer to it. Laws: tests/laws/can_bus_laws.hpp, run in
// tests/runtime/hardware/socket_can.cpp. Source: Linux, Documentation/networking/can.rst; lely-core,
// io2/linux/can_chan.c, for ENOBUFS. docs/can_bus.md.
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

#include <cca/hardware/bus/arrival_clock.hpp>
#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/bus/can_interface.hpp>
#include <cca/hardware/bus/kernel_frame.hpp>
#include <cca/hardware/bus/socket_batch.hpp>

namespace cca::hardware {

struct socket_can_options {
  std::span<const can_filter> replies{};
  std::span<const can_filter> ours{};
  bool fd = false;
  std::uint64_t most_in_flight = 16;
  std::int64_t gives_up_after = 0;  // ns; 0: the controller tries until it succeeds
  bool confirmations = true;
  bool times = true;
};

class socket_can {
public:
  explicit socket_can(std::string_view name, const socket_can_options& o = {})
      : interface(name),
        socket(detail::open_can(
            interface, let_through(o), {.fd = o.fd, .own_frames = o.confirmations, .times = o.times})),
        ours(o.ours.begin(), o.ours.end()),
        most_in_flight(o.most_in_flight),
        gives_up_after(o.gives_up_after),
        with_fd(o.fd),
        with_own(o.confirmations),
        with_times(o.times),
        work(std::make_unique<detail::socket_batch>(o.times)) {
    const detail::link now = interface.state(socket.get());
    carrier_was_lost = now == detail::link::no_carrier;
    seen = now == detail::link::up           ? bus_state::active
           : now == detail::link::no_carrier ? bus_state::bus_off
                                             : bus_state::down;
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
        if (!frames[used].valid() || (frames[used].fd && !with_fd))
          refuse(send_outcome::invalid, count.invalid, 1);
        else work->put(n++, frames[used]);
      }
      if (room == 0) {
        refuse(send_outcome::full, count.dropped_full, frames.size());
        break;
      }
      frames = frames.subspan(used);
      for (std::size_t first = 0; first < n;) {
        const int done = work->send(socket.get(), first, n);
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
          refuse(full ? send_outcome::full : send_outcome::away,
                 full ? count.dropped_full : count.dropped_away, n - first + frames.size());
          return result;
        }
      }
    }
    return result;
  }

  std::size_t receive(std::span<received_frame> into) noexcept {
    if (is_away(seen)) look_for_return();
    std::size_t n = 0;
    bool told = false, many = false;
    while (n < into.size()) {
      const std::size_t asked = std::min(batch, into.size() - n);
      const int got = work->receive(socket.get(), asked);
      if (got < 0) {
        if (errno == EINTR) continue;
        if (told || (errno != ENETDOWN && errno != ENODEV && errno != ENXIO)) break;
        told = true;  // the kernel says so once; earlier frames can still be read
        went_down();
        look_for_return();
        continue;
      }
      const std::int64_t real = with_times ? nanoseconds_of(CLOCK_REALTIME) : 0;
      const std::int64_t now = nanoseconds_of(CLOCK_MONOTONIC);
      for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i)
        if (take(i, into[n].frame)) into[n++].time = arrivals(with_times ? work->time(i) : 0, real, now);
      if (static_cast<std::size_t>(got) < asked) break;  // the queue is empty
      many = true;
    }
    if (many) count_lost();
    if (!with_own) confirm_what_has_left();
    if (gives_up_after > 0 && unconfirmed > 0 && nanoseconds_of(CLOCK_MONOTONIC) - sent_at > gives_up_after)
      forget_in_flight();
    return n;
  }

  bus_state state() const noexcept { return seen; }
  const bus_counters& counters() const noexcept { return count; }
  std::uint64_t in_flight() const noexcept { return unconfirmed; }
  std::uint64_t stale() const noexcept { return confirmed_stale; }
  int file() const noexcept { return socket.get(); }  // for poll, outside of a beat

private:
  static constexpr std::size_t batch = detail::socket_batch::most;

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

  // Reads message i of the batch; true: it is for the caller.
  bool take(std::size_t i, can_frame& into) noexcept {
    const canfd_frame& k = work->frame(i);
    const std::size_t size = work->size(i);
    if (size != detail::classic_size && size != detail::fd_size) return false;
    if (detail::is_error(k)) return note_error(k), false;
    if (work->is_own(i)) {
      ++count.confirmed;
      if (unconfirmed > 0) --unconfirmed;
      if (stale_to_come > 0) --stale_to_come, ++confirmed_stale;
      return false;
    }
    detail::from_kernel(k, size, into);
    for (const can_filter& f : ours)
      if (f.matches(into.id) && !into.remote) return ++count.intruders, false;
    ++count.received;
    return true;
  }
  void note_error(const canfd_frame& error) noexcept {
    if (seen != bus_state::down) seen = detail::after_error(seen, error, count);
    if (seen == bus_state::bus_off) stale_to_come = unconfirmed, carrier_was_lost = false;
  }

  void went_down() noexcept {
    if (seen == bus_state::down) return;
    seen = bus_state::down;
    ++count.downs;
    forget_in_flight();  // so does the kernel
  }

  void look_for_return() noexcept {
    const detail::link now = interface.state(socket.get());
    if (seen == bus_state::bus_off) {  // the error frame about the restart may have been lost
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

  // A confirmation may be lost with the receive queue: then the kernel knows what it still holds.
  std::uint64_t room_in_flight() noexcept {
    if (unconfirmed >= most_in_flight && kernel_holds_none()) unconfirmed = 0;
    return most_in_flight - std::min(unconfirmed, most_in_flight);
  }
  void confirm_what_has_left() noexcept {
    if (unconfirmed == 0 || !kernel_holds_none()) return;
    count.confirmed += unconfirmed;
    unconfirmed = stale_to_come = 0;
  }
  // Asked only after a full batch: frames are lost only when the queue is longer than that.
  void count_lost() noexcept {
    const std::uint32_t lost = memory(SK_MEMINFO_DROPS, lost_before);
    count.lost += lost - lost_before;  // wraps
    lost_before = lost;
  }
  bool kernel_holds_none() const noexcept { return memory(SK_MEMINFO_WMEM_ALLOC, 1) == 0; }
  std::uint32_t memory(int what, std::uint32_t untold) const noexcept {
    std::array<std::uint32_t, SK_MEMINFO_VARS> all{};
    socklen_t size = sizeof all;
    return ::getsockopt(socket.get(), SOL_SOCKET, SO_MEMINFO, all.data(), &size) == 0
               ? all[static_cast<std::size_t>(what)]
               : untold;
  }

  detail::can_interface interface;
  detail::file_descriptor socket;
  std::vector<can_filter> ours;
  std::uint64_t most_in_flight;
  std::int64_t gives_up_after, sent_at = 0;
  bool with_fd, with_own, with_times;
  std::unique_ptr<detail::socket_batch> work;
  bus_state seen = bus_state::down;
  bus_counters count{};
  std::uint64_t unconfirmed = 0, stale_to_come = 0, confirmed_stale = 0;
  std::uint32_t lost_before = 0;
  detail::arrival_clock arrivals{};
  bool carrier_was_lost = false, was_gone = false;
};

static_assert(CanBus<socket_can>);

}  // namespace cca::hardware
