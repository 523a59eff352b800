// The messages of one system call on a raw CAN socket: the structures of sendmmsg and recvmmsg, set up once.
//
// Before the next call only the entries that the last one used are reset. The structures point into the
// batch, so it can't be copied or moved. Cost: 11 kB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ctime>

#include <sys/socket.h>
#include <sys/uio.h>

#include <cca/hardware/bus/kernel_frame.hpp>

namespace cca::hardware::detail {

class socket_batch {
public:
  static constexpr std::size_t most = 32;

  // With room for times of arrival, or without.
  explicit socket_batch(bool with_times) noexcept : with_control(with_times) {
    const auto one_part = [](mmsghdr& head, iovec& part, canfd_frame& frame) {
      part = {&frame, sizeof frame};
      head.msg_hdr.msg_iov = &part;
      head.msg_hdr.msg_iovlen = 1;
    };
    for (std::size_t i = 0; i < most; ++i) {
      one_part(in[i], in_parts[i], in_frames[i]);
      one_part(out[i], out_parts[i], out_frames[i]);
      if (!with_control) continue;
      in[i].msg_hdr.msg_control = in_control[i].bytes.data();
      in[i].msg_hdr.msg_controllen = sizeof in_control[i].bytes;
    }
  }
  socket_batch(const socket_batch&) = delete;
  socket_batch& operator=(const socket_batch&) = delete;

  void put(std::size_t i, const can_frame& f) noexcept {
    to_kernel(f, out_frames[i]);
    out_parts[i].iov_len = kernel_size(f);
  }
  // Like sendmmsg: how many were taken, or -1.
  int send(int fd, std::size_t first, std::size_t end) noexcept {
    return ::sendmmsg(fd, &out[first], static_cast<unsigned>(end - first), MSG_DONTWAIT);
  }

  // Like recvmmsg: how many came, or -1.
  int receive(int fd, std::size_t asked) noexcept {
    for (std::size_t i = 0; i < used; ++i) in[i].msg_hdr.msg_controllen = sizeof in_control[i].bytes;
    const int got = ::recvmmsg(fd, in.data(), static_cast<unsigned>(asked), MSG_DONTWAIT, nullptr);
    used = with_control && got > 0 ? static_cast<std::size_t>(got) : 0;
    return got;
  }
  const canfd_frame& frame(std::size_t i) const noexcept { return in_frames[i]; }
  std::size_t size(std::size_t i) const noexcept { return in[i].msg_len; }
  bool is_own(std::size_t i) const noexcept { return (in[i].msg_hdr.msg_flags & MSG_CONFIRM) != 0; }

  // Time of arrival on the real-time clock, in ns; 0: the kernel was not asked for it.
  std::int64_t time(std::size_t i) noexcept {
    msghdr& head = in[i].msg_hdr;
    for (cmsghdr* c = CMSG_FIRSTHDR(&head); c; c = CMSG_NXTHDR(&head, c)) {
      if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SO_TIMESTAMPNS) continue;
      timespec t;
      std::memcpy(&t, CMSG_DATA(c), sizeof t);
      return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
    }
    return 0;
  }

private:
  struct alignas(cmsghdr) control {
    std::array<std::byte, CMSG_SPACE(sizeof(timespec))> bytes;
  };

  std::array<mmsghdr, most> in{}, out{};
  std::array<iovec, most> in_parts{}, out_parts{};
  std::array<canfd_frame, most> in_frames{}, out_frames{};
  std::array<control, most> in_control{};
  bool with_control;
  std::size_t used = 0;  // entries of `in` that the last call used
};

}  // namespace cca::hardware::detail
