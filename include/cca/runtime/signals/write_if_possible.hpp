// Writes to a terminal, a pipe or a file if that has room now, else nothing: a robot never waits for a
// terminal. It calls the system, so it belongs between two beats. It may be called in a signal handler.
#pragma once

#include <poll.h>
#include <unistd.h>

#include <string_view>

namespace cca {

// False: it had no room, or is closed. At most 4 KiB, so that a pipe takes all of it at once.
inline bool write_if_possible(int file, std::string_view text) noexcept {
  pollfd ready{file, POLLOUT, 0};
  return ::poll(&ready, 1, 0) == 1 && (ready.revents & POLLOUT) != 0 &&
         ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

}  // namespace cca
