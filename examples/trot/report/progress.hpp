#pragma once
// A progress bar: on a terminal one line that fills up, elsewhere a new line at each quarter.
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

#include <unistd.h>

namespace trot {

class progress_bar {
public:
  explicit progress_bar(std::string label, bool shown = true)
      : label_(std::move(label)), shown_(shown), terminal_(isatty(STDERR_FILENO) != 0) {}

  void show(double part, const std::string& note = "") {
    if (!shown_) return;
    if (terminal_) {
      const auto now = std::chrono::steady_clock::now();
      if (part < 1 && now - drawn_ < std::chrono::milliseconds(50)) return;
      drawn_ = now;
      const int filled = static_cast<int>(part * width);
      std::string bar(static_cast<std::size_t>(filled), '#');
      bar.resize(width, '.');
      std::fprintf(stderr, "\r%s [%s] %3.0f %%  %s\033[K", label_.c_str(), bar.c_str(), 100 * part,
                   note.c_str());
    } else if (const int quarter = static_cast<int>(part * 4); quarter > quarter_) {
      quarter_ = quarter;
      std::fprintf(stderr, "%s %3.0f %%  %s\n", label_.c_str(), 100 * part, note.c_str());
    }
    std::fflush(stderr);
  }

  void done() {
    if (shown_ && terminal_) std::fputc('\n', stderr);
  }

private:
  static constexpr std::size_t width = 40;
  std::string label_;
  bool shown_, terminal_;
  int quarter_ = 0;
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace trot
