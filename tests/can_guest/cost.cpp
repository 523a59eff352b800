// What a frame costs: socket_can compared with a plain program that does the same with one call a frame, and
// with cangen and candump.
//
//   cost [FRAMES [MOST]]   on vcan0, with cangen and candump in its folder; prints a table. Exit code 1:
//                          socket_can costs more than MOST times the plain program in one of the rows
//
// All send the same: classic frames of 8 bytes under one id, in beats of eight as to eight drives, from one
// socket; another socket receives in each beat all that has come. The plain program does what socket_can is
// asked for: `times`, when a frame arrived (recvmsg with SO_TIMESTAMPNS); `confirmations`, which of its
// frames went over the bus (it receives its own). socket_can also has exact filters, error frames and the
// count of lost frames; the plain program has none of these. CPU time is that of the thread, with the
// kernel's work in its calls; for cangen and candump it is that of their processes, less the time that they
// need to start. If the clock counts instructions (QEMU's -icount), these are instructions.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
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

constexpr int beat = 8;
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
  double rate = 0;               // frames a second, when sending and receiving follow one another
};

// What a call of cpu() adds to an interval.
double of_clock() {
  constexpr int calls = 1000;
  const double begin = cpu();
  for (int i = 1; i < calls; ++i) cpu();
  return (cpu() - begin) / calls;
}

// Beat by beat: sent and received.
template <class Send, class Receive>
cost measured(int frames, Send send, Receive receive) {
  const int beats = frames / beat;
  const double clock = of_clock(), begin = seconds(CLOCK_MONOTONIC);
  double sending = 0, receiving = 0;
  for (int b = 0; b < beats; ++b) {
    const double before = cpu();
    send();
    const double between = cpu();
    receive();
    receiving += cpu() - between - clock;
    sending += between - before - clock;
  }
  const double all = beats * beat;
  return {sending / all, receiving / all, all / (seconds(CLOCK_MONOTONIC) - begin)};
}

struct duty {
  const char* what;
  bool times, confirmations;
};

// As most programs do it: one frame a call.
class plain_socket {
public:
  explicit plain_socket(duty d = {}) : fd(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK, CAN_RAW)), asked(d) {
    check(fd >= 0, "socket");
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex(bus_name));
    const int own = d.confirmations, stamp = d.times;
    check(setsockopt(fd, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &own, sizeof own) == 0, "own messages");
    check(setsockopt(fd, SOL_SOCKET, SO_TIMESTAMPNS, &stamp, sizeof stamp) == 0, "times");
    check(bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, bus_name);
  }
  plain_socket(const plain_socket&) = delete;
  plain_socket& operator=(const plain_socket&) = delete;
  ~plain_socket() { ::close(fd); }

  void send(const ::can_frame& f) { check(::write(fd, &f, sizeof f) == sizeof f, "write"); }
  // How many frames came: its own, and those of others.
  struct heard {
    int own = 0, others = 0;
  };
  heard receive_all() {
    heard all;
    ::can_frame f;
    if (!asked.times && !asked.confirmations) {
      while (::read(fd, &f, sizeof f) == sizeof f) ++all.others;
      return all;
    }
    iovec part{&f, sizeof f};
    alignas(cmsghdr) char beside[CMSG_SPACE(sizeof(timespec))];
    for (;;) {
      msghdr head{};
      head.msg_iov = &part;
      head.msg_iovlen = 1;
      if (asked.times) head.msg_control = beside, head.msg_controllen = sizeof beside;
      if (::recvmsg(fd, &head, 0) != sizeof f) return all;
      const bool own = (head.msg_flags & MSG_CONFIRM) != 0;
      all.own += own, all.others += !own;
      for (cmsghdr* c = CMSG_FIRSTHDR(&head); c; c = CMSG_NXTHDR(&head, c))
        if (c->cmsg_level == SOL_SOCKET && c->cmsg_type == SO_TIMESTAMPNS)
          std::memcpy(&last, CMSG_DATA(c), sizeof last);
    }
  }

private:
  int fd;
  duty asked;
  timespec last{};
};

cost of_plain(int frames, const duty& d) {
  plain_socket from(d), to(d);
  ::can_frame f{};
  f.can_id = 0x123;
  f.can_dlc = 8;
  return measured(
      frames,
      [&] {
        for (int i = 0; i < beat; ++i) from.send(f);
        if (d.confirmations) check(from.receive_all().own == beat, "confirmations");
      },
      [&] { check(to.receive_all().others == beat, "receive"); });
}

cost of_socket_can(int frames, const duty& d) {
  const std::array set_points{hw::can_filter{hw::standard(0x123)}},
      answers{hw::can_filter{hw::standard(0x124)}};
  const auto options = [&d](const auto& replies, const auto& ours) {
    return hw::socket_can_options{.replies = replies,
                                  .ours = ours,
                                  .most_in_flight = 64,
                                  .confirmations = d.confirmations,
                                  .times = d.times};
  };
  hw::socket_can from(bus_name, options(answers, set_points)), to(bus_name, options(set_points, answers));
  std::array<hw::can_frame, beat> frames_of_beat;
  frames_of_beat.fill({.id = hw::standard(0x123), .length = 8});
  std::array<hw::received_frame, 64> into;  // as in a synchronizer
  return measured(
      frames,
      [&] {
        check(from.send(frames_of_beat).sent == beat, "send");
        if (d.confirmations) check(from.receive(into) == 0 && from.in_flight() == 0, "confirmations");
      },
      [&] { check(to.receive(into) == beat, "receive"); });
}

// CPU time of a program, from its start to its end.
double cpu_of(const std::vector<std::string>& words, const std::function<void()>& meanwhile = {}) {
  std::vector<char*> line;
  for (const std::string& w : words) line.push_back(const_cast<char*>(w.c_str()));
  line.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stdout);
    alarm(60);  // for a program that waits for a lost frame
    execv(line[0], line.data());
    _exit(127);
  }
  if (meanwhile) meanwhile();
  int how = 0;
  rusage used{};
  check(wait4(child, &how, 0, &used) == child && WIFEXITED(how) && WEXITSTATUS(how) == 0, line[0]);
  const auto s = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return s(used.ru_utime) + s(used.ru_stime);
}

cost of_can_utils(int frames) {
  const auto cangen = [](int n) {
    return cpu_of({"./cangen", bus_name, "-g", "0", "-n", std::to_string(n), "-I", "123", "-L", "8", "-D",
                   "1122334455667788"});
  };
  const auto candump = [](int n) {
    return cpu_of({"./candump", "-s", "2", "-n", std::to_string(n), bus_name}, [n] {
      plain_socket from;
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
        if (i % 160 == 0) from.receive_all(), pause(10);  // otherwise it falls behind and loses frames
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
  const double most = count > 2 ? std::atof(arguments[2]) : 0;
  constexpr std::array duties{duty{"frames alone", false, false}, duty{"and times of arrival", true, false},
                              duty{"and confirmations", false, true}, duty{"and both", true, true}};
  // In turns, and the best of each: other programs on the host only add time.
  std::array<cost, duties.size()> plain, ours;
  plain.fill({1, 1, 0}), ours.fill({1, 1, 0});
  const auto best = [](cost& a, const cost& b) {
    a = {std::min(a.send, b.send), std::min(a.receive, b.receive), std::max(a.rate, b.rate)};
  };
  for (int turn = 0; turn < 5; ++turn)
    for (std::size_t i = 0; i < duties.size(); ++i) {
      best(plain[i], of_plain(frames, duties[i]));
      best(ours[i], of_socket_can(frames, duties[i]));
    }
  const cost utils = of_can_utils(frames / 4);
  const auto both = [](const cost& c) { return 1e6 * (c.send + c.receive); };
  double worst = 0;
  std::puts(
      "| asked of both | plain program | socket_can | ratio | plain, frames a second | socket_can, frames a "
      "second |");
  std::puts("|---|---|---|---|---|---|");
  for (std::size_t i = 0; i < duties.size(); ++i) {
    const double ratio = both(ours[i]) / both(plain[i]);
    worst = std::max(worst, ratio);
    std::printf("| %s | %.2f + %.2f = %.2f | %.2f + %.2f = %.2f | %.3f | %.0f | %.0f |\n", duties[i].what,
                1e6 * plain[i].send, 1e6 * plain[i].receive, both(plain[i]), 1e6 * ours[i].send,
                1e6 * ours[i].receive, both(ours[i]), ratio, plain[i].rate, ours[i].rate);
  }
  std::printf("| cangen, candump -s 2 | | %.2f + %.2f = %.2f | | | |\n", 1e6 * utils.send,
              1e6 * utils.receive, both(utils));
  std::puts("Sending + receiving, us of CPU a frame.");
  if (most == 0 || worst <= most) return 0;
  std::printf("more than %.3f times the plain program's\n", most);
  return 1;
}
