// A claim that only one process of the machine can have at a time, beside the lock of a file: it stays when
// the file's name is removed. It is the name of a socket in the kernel's table (abstract, so in no folder);
// others connect to it only to ask who has it. The system takes it away when the process ends.
//
// Between containers that share /dev/shm but no network it does not count, nor where a process may make no
// sockets: then only the locks of the file do.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <utility>

namespace cca::detail {

class machine_claim {
public:
  machine_claim() = default;
  ~machine_claim() { release(); }
  machine_claim(machine_claim&& from) noexcept : socket(std::exchange(from.socket, -1)) {}
  machine_claim& operator=(machine_claim&& from) noexcept {
    std::swap(socket, from.socket);
    return *this;
  }

  // At most 100 letters. False: another process has it.
  bool take(const std::string& name) {
    release();
    socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return true;
    const address at(name);
    if (::bind(socket, at.get(), at.size) == 0) {
      ::listen(socket, 8);
      return true;
    }
    const bool is_taken = errno == EADDRINUSE;
    release();
    return !is_taken;
  }
  void release() {
    if (socket >= 0) ::close(socket);
    socket = -1;
  }

  // The process that has it; 0: not known.
  static int holder(const std::string& name) {
    const int asks = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (asks < 0) return 0;
    const address at(name);
    ucred who{};
    socklen_t size = sizeof who;
    const bool is_known = ::connect(asks, at.get(), at.size) == 0 &&
                          ::getsockopt(asks, SOL_SOCKET, SO_PEERCRED, &who, &size) == 0;
    ::close(asks);
    return is_known ? who.pid : 0;
  }

private:
  struct address {
    sockaddr_un of{};
    socklen_t size;

    explicit address(const std::string& name) {
      of.sun_family = AF_UNIX;
      const std::size_t length = std::min(name.size(), sizeof of.sun_path - 1);
      std::copy_n(name.begin(), length, of.sun_path + 1);  // it begins with a zero: abstract
      size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
    }
    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&of); }
  };

  int socket = -1;
};

}  // namespace cca::detail
