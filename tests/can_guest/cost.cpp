// What a frame costs: socket_can beside a plain program that writes and reads one frame a call, and beside cangen and candump.
//
//   cost [FRAMES]       on vcan0, with cangen and candump in the folder where it runs; prints a table
//
// All send the same: classic frames of 8 bytes under one id. socket_can and the plain program send beats of eight, as to eight
// drives, from one socket, and receive them at another. CPU: that of the thread, the kernel's work in its calls with it; of
// cangen and candump that of their processes, of which the time to begin has been taken off. What cangen does not ask for, and
// socket_can always has: which of its frames went over the bus. `echo` is the plain program which asks for that as well.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cca/hardware/socket_can.hpp>

namespace hw = cca::hardware;

namespace {

constexpr int beat = 8, beats_at_a_time = 20;  // as many as a receive queue holds
constexpr const char* bus_name = "vcan0";

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
double cpu() { return seconds(CLOCK_THREAD_CPUTIME_ID); }

void check(bool good, const char* what) {
  if (good) return;
  std::perror(what);
  std::exit(2);
}

struct cost {
  double send = 0, receive = 0;  // s of CPU a frame
  double rate = 0;               // frames a second, one sent and received after the other
};

// Alternately so many beats sent and received.
template <class Send, class Receive>
cost measured(int frames, Send send, Receive receive) {
  const int rounds = frames / (beat * beats_at_a_time);
  double sending = 0, receiving = 0;
  const double begin = seconds(CLOCK_MONOTONIC);
  for (int r = 0; r < rounds; ++r) {
    const double a = cpu();
    for (int b = 0; b < beats_at_a_time; ++b) send();
    const double c = cpu();
    for (int b = 0; b < beats_at_a_time; ++b) receive();
    sending += c - a;
    receiving += cpu() - c;
  }
  const double all = rounds * beat * beats_at_a_time;
  return {sending / all, receiving / all, all / (seconds(CLOCK_MONOTONIC) - begin)};
}

// What most programs do: one frame a call. `echo`: reads its own frames, too, to know that they went out.
class plain_socket {
public:
  explicit plain_socket(bool echo = false) : fd(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK, CAN_RAW)) {
    check(fd >= 0, "socket");
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex(bus_name));
    const int yes = echo;
    check(setsockopt(fd, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &yes, sizeof yes) == 0, "own messages");
    check(bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, bus_name);
  }
  plain_socket(const plain_socket&) = delete;
  plain_socket& operator=(const plain_socket&) = delete;
  ~plain_socket() { ::close(fd); }

  void send(const ::can_frame& f) { check(::write(fd, &f, sizeof f) == sizeof f, "write"); }
  int receive_all() {
    int n = 0;
    ::can_frame f;
    while (::read(fd, &f, sizeof f) == sizeof f) ++n;
    return n;
  }
  void receive_beat() {
    ::can_frame f;
    for (int i = 0; i < beat; ++i) check(::read(fd, &f, sizeof f) == sizeof f, "read");
  }
  // So that it is no receiver.
  void deaf() { check(setsockopt(fd, SOL_CAN_RAW, CAN_RAW_FILTER, nullptr, 0) == 0, "no filters"); }

private:
  int fd;
};

cost of_plain(int frames, bool echo) {
  plain_socket from(echo), to;
  if (!echo) from.deaf();
  ::can_frame f{};
  f.can_id = 0x123;
  f.can_dlc = 8;
  return measured(
      frames,
      [&] {
        for (int i = 0; i < beat; ++i) from.send(f);
        if (echo) check(from.receive_all() == beat, "echoes");
      },
      [&] { to.receive_beat(); });
}

cost of_socket_can(int frames) {
  const std::array set_points{hw::can_filter{hw::standard(0x123)}}, answers{hw::can_filter{hw::standard(0x124)}};
  hw::socket_can from(bus_name, {.replies = answers, .ours = set_points}), to(bus_name, {.replies = set_points});
  std::array<hw::can_frame, beat> frames_of_beat;
  frames_of_beat.fill({.id = hw::standard(0x123), .length = 8});
  std::array<hw::received_frame, beat> into;
  return measured(
      frames,
      [&] {
        check(from.send(frames_of_beat).sent == beat, "send");
        check(from.receive(into) == 0 && from.in_flight() == 0, "confirmations");
      },
      [&] { check(to.receive(into) == beat, "receive"); });
}

// CPU of a program, from its beginning to its end.
double cpu_of(const std::vector<std::string>& words, const std::function<void()>& meanwhile = {}) {
  std::vector<char*> line;
  for (const std::string& w : words) line.push_back(const_cast<char*>(w.c_str()));
  line.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stdout);
    alarm(60);  // one that waits for a frame that was lost
    execv(line[0], line.data());
    _exit(127);
  }
  if (meanwhile) meanwhile();
  int how = 0;
  rusage used{};
  check(wait4(child, &how, 0, &used) == child && WIFEXITED(how) && WEXITSTATUS(how) == 0, line[0]);
  const auto s = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return s(used.ru_utime) + s(used.ru_stime);
}

cost of_can_utils(int frames) {
  const auto cangen = [](int n) {
    return cpu_of({"./cangen", bus_name, "-g", "0", "-n", std::to_string(n), "-I", "123", "-L", "8", "-D", "1122334455667788"});
  };
  const auto candump = [](int n) {
    return cpu_of({"./candump", "-s", "2", "-n", std::to_string(n), bus_name}, [n] {
      plain_socket from;
      from.deaf();
      ::can_frame f{};
      f.can_id = 0x123;
      f.can_dlc = 8;
      const auto pause = [](long ms) {
        const timespec t{0, ms * 1'000'000};
        nanosleep(&t, nullptr);
      };
      pause(300);  // until it listens
      for (int i = 0; i < n; ++i) {
        from.send(f);
        if (i % (beat * beats_at_a_time) == 0) pause(10);  // it falls behind otherwise, and loses some
      }
    });
  };
  const int few = 160;
  cost c{(cangen(frames) - cangen(few)) / (frames - few), (candump(frames) - candump(few)) / (frames - few)};
  c.rate = 1 / (c.send + c.receive);
  return c;
}

}  // namespace

int main(int count, char** arguments) {
  const int frames = count > 1 ? std::atoi(arguments[1]) : 48'000;
  // In turns, and of each the best: other programs of the machine below only add.
  cost plain{1, 1, 0}, echo = plain, ours = plain, utils = plain;
  const auto best = [](cost& a, const cost& b) {
    a = {std::min(a.send, b.send), std::min(a.receive, b.receive), std::max(a.rate, b.rate)};
  };
  for (int i = 0; i < 5; ++i) {
    best(plain, of_plain(frames, false));
    best(echo, of_plain(frames, true));
    best(ours, of_socket_can(frames));
  }
  best(utils, of_can_utils(frames / 4));
  std::puts("| | sending, us a frame | receiving, us a frame | both | frames a second |\n|---|---|---|---|---|");
  const auto row = [](const char* what, const cost& c) {
    std::printf("| %s | %.2f | %.2f | %.2f | %.0f |\n", what, 1e6 * c.send, 1e6 * c.receive, 1e6 * (c.send + c.receive), c.rate);
  };
  row("plain program, write and read", plain);
  row("the same, reading its own frames as confirmation", echo);
  row("socket_can, confirmations, filters, times and errors", ours);
  row("cangen and candump -s 2", utils);
  const double ratio = (ours.send + ours.receive) / (plain.send + plain.receive);
  std::printf("socket_can takes %.2f times the CPU of the plain program, %.2f of that with confirmations\n", ratio,
              (ours.send + ours.receive) / (echo.send + echo.receive));
  return 0;
}
