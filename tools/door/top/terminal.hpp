// The terminal: every key by itself, a screen of its own, and however the program ends, all as it was.
//
// A signal that kills (an abort, a wrong access) restores it, too; only SIGKILL can't be answered.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/refused.hpp>

#include "screen.hpp"

namespace cca_door {

namespace detail {

// The second screen, no cursor, marks around what is pasted; and back.
inline constexpr char enter_codes[] = "\x1b[?1049h\x1b[?25l\x1b[?2004h";
inline constexpr char leave_codes[] = "\x1b[0m\x1b[?2004l\x1b[?25h\x1b[?1049l";

struct terminal_before {
  termios settings{};
  std::atomic<bool> is_ours{false};
};
inline terminal_before before_us;
inline volatile std::sig_atomic_t was_suspended = 0, was_continued = 0;

// Only what a handler may call.
inline void give_terminal_back() {
  if (!before_us.is_ours.exchange(false)) return;
  [[maybe_unused]] const ssize_t no_matter = ::write(STDOUT_FILENO, leave_codes, sizeof leave_codes - 1);
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_us.settings);
}
extern "C" inline void cca_top_killed(int number) {
  give_terminal_back();
  ::signal(number, SIG_DFL);
  ::raise(number);
}
extern "C" inline void cca_top_suspended(int) { was_suspended = 1; }
extern "C" inline void cca_top_continued(int) { was_continued = 1; }

}  // namespace detail

class terminal {
public:
  // Error: cca::refused where there is none.
  terminal() {
    const char* const kind = std::getenv("TERM");
    if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0)
      throw cca::refused("this needs a terminal; in scripts use cca-call");
    if (!kind || std::string_view(kind).empty() || std::string_view(kind) == "dumb")
      throw cca::refused("this terminal has no screen (TERM is not set, or dumb); use cca-call");
    enter();
    for (const int number : killing) ::signal(number, detail::cca_top_killed);
    ::signal(SIGTSTP, detail::cca_top_suspended);
    ::signal(SIGCONT, detail::cca_top_continued);
  }
  ~terminal() {
    detail::give_terminal_back();
    for (const int number : killing) ::signal(number, SIG_DFL);
    ::signal(SIGTSTP, SIG_DFL);
    ::signal(SIGCONT, SIG_DFL);
  }
  terminal(const terminal&) = delete;
  terminal& operator=(const terminal&) = delete;

  terminal_size size() const {
    winsize is{};
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &is) != 0 || is.ws_col == 0 || is.ws_row == 0) return {};
    return {is.ws_col, is.ws_row};
  }
  // What has been typed; false: the terminal is gone.
  bool read(std::string& to) const {
    pollfd one{STDIN_FILENO, POLLIN, 0};
    if (::poll(&one, 1, 0) <= 0) return true;
    char some[4096];
    const ssize_t size = ::read(STDIN_FILENO, some, sizeof some);
    if (size > 0) to.append(some, static_cast<std::size_t>(size));
    return size > 0 || (size < 0 && (errno == EINTR || errno == EAGAIN));
  }
  bool write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t size = ::write(STDOUT_FILENO, text.data(), text.size());
      if (size >= 0) text.remove_prefix(static_cast<std::size_t>(size));
      else if (errno == EAGAIN) {
        pollfd one{STDOUT_FILENO, POLLOUT, 0};
        ::poll(&one, 1, 1000);
      } else if (errno != EINTR) {
        return false;
      }
    }
    return true;
  }

  // Ctrl-z: the shell's terminal until it is continued.
  void suspend() {
    detail::give_terminal_back();
    ::signal(SIGTSTP, SIG_DFL);
    ::raise(SIGTSTP);
    ::signal(SIGTSTP, detail::cca_top_suspended);
    detail::was_suspended = 0;
    detail::was_continued = 1;
  }
  bool is_suspended() const { return detail::was_suspended != 0; }
  // Whether it must be drawn anew, because others had the terminal.
  bool is_continued() {
    if (detail::was_continued == 0) return false;
    detail::was_continued = 0;
    detail::give_terminal_back();
    enter();
    return true;
  }

private:
  static constexpr std::array killing{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT};

  void enter() {
    ::tcgetattr(STDIN_FILENO, &detail::before_us.settings);
    termios raw = detail::before_us.settings;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG | IEXTEN);
    raw.c_iflag &= ~static_cast<tcflag_t>(IXON | ICRNL | INLCR);
    raw.c_cc[VMIN] = 0, raw.c_cc[VTIME] = 0;
    detail::before_us.is_ours = true;
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &raw);
    write(detail::enter_codes);
  }
};

}  // namespace cca_door
