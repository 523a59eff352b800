// A cable between two network interfaces that loses, delays, reorders and doubles frames, and can be cut. For
// kernels without netem: it takes each frame from the one interface and gives it to the other.
//
//   cable A B [--loss %] [--delay ms] [--jitter ms] [--twice %] [--seed N]
//   cable --checksums A
//
// It reads its standard input: `cut` and `mend`, each told with the time at which it happened; at the end it
// prints how many frames came, were lost and arrived. What happens to a frame is decided by its number and
// the seed, so a run can be repeated as far as the programs repeat what they send. A jitter above 0 reorders.
//
// The second form lets the interface of a machine write the checksums of its frames. Otherwise the kernel
// leaves them to hardware that a virtual cable does not have, and the receiver drops every frame.
#include <linux/ethtool.h>
#include <linux/if_packet.h>
#include <linux/sockios.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <queue>
#include <string>
#include <string_view>
#include <vector>

namespace {

using clock_type = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
  std::perror(what.c_str());
  std::exit(1);
}

int open_interface(const char* name) {
  const int end = ::socket(AF_PACKET, SOCK_RAW | SOCK_NONBLOCK, htons(ETH_P_ALL));
  sockaddr_ll at{};
  at.sll_family = AF_PACKET;
  at.sll_protocol = htons(ETH_P_ALL);
  at.sll_ifindex = static_cast<int>(::if_nametoindex(name));
  packet_mreq all{};
  all.mr_ifindex = at.sll_ifindex;
  all.mr_type = PACKET_MR_PROMISC;
  const int room = 8 << 20, yes = 1;
  if (end < 0 || at.sll_ifindex == 0 || ::bind(end, reinterpret_cast<sockaddr*>(&at), sizeof at) != 0 ||
      ::setsockopt(end, SOL_PACKET, PACKET_ADD_MEMBERSHIP, &all, sizeof all) != 0 ||
      ::setsockopt(end, SOL_PACKET, PACKET_IGNORE_OUTGOING, &yes, sizeof yes) != 0)
    fail(std::string("cable: ") + name);
  if (::setsockopt(end, SOL_SOCKET, SO_RCVBUFFORCE, &room, sizeof room) != 0)  // needs a right
    ::setsockopt(end, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  return end;
}

void write_checksums(const char* name) {
  const int any = ::socket(AF_INET, SOCK_DGRAM, 0);
  for (const std::uint32_t what : {ETHTOOL_STXCSUM, ETHTOOL_STSO, ETHTOOL_SGSO}) {
    ethtool_value off{what, 0};
    ifreq of{};
    std::strncpy(of.ifr_name, name, IFNAMSIZ - 1);
    of.ifr_data = reinterpret_cast<char*>(&off);
    if (::ioctl(any, SIOCETHTOOL, &of) != 0) fail(std::string("cable --checksums ") + name);
  }
  ::close(any);
}

// splitmix64: a number for each frame and question.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

struct settings {
  double loss = 0, delay = 0, jitter = 0, twice = 0, seed = 1;  // %, ms, ms, %
};

struct frame {
  clock_type::time_point due;
  std::uint64_t order;
  std::size_t to;
  std::vector<unsigned char> bytes;

  friend bool operator<(const frame& a, const frame& b) {  // the first one due is the top of the queue
    return a.due != b.due ? a.due > b.due : a.order > b.order;
  }
};

class cable {
public:
  cable(const char* a, const char* b, const settings& s)
      : ends{open_interface(a), open_interface(b)}, is(s) {}

  void run() {
    for (bool goes_on = true; goes_on;) {
      std::array<pollfd, 3> ready{{{ends[0], POLLIN, 0}, {ends[1], POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
      const timespec longest = until_next();
      ::ppoll(ready.data(), ready.size(), &longest, nullptr);
      for (const std::size_t from : {0u, 1u}) take(from);
      give();
      if (ready[2].revents != 0) goes_on = obey();
    }
    for (const std::size_t from : {0u, 1u})
      std::printf("%s: %llu frames came, %llu were lost, %llu arrived, %llu twice\n",
                  from == 0 ? "there" : "back", count[from].came, count[from].lost, count[from].gone,
                  count[from].twice);
  }

private:
  timespec until_next() const {
    if (under_way.empty()) return {1, 0};
    const auto left = std::max<std::int64_t>(0, (under_way.top().due - clock_type::now()).count());
    return {left / 1'000'000'000, left % 1'000'000'000};
  }
  void take(std::size_t from) {
    std::array<unsigned char, 70'000> bytes;
    for (ssize_t size; (size = ::recv(ends[from], bytes.data(), bytes.size(), 0)) > 0;) {
      const std::uint64_t number = 2 * count[from].came++ + from;
      if (is_cut || chance(number, 0) * 100 < is.loss) {
        ++count[from].lost;
        continue;
      }
      const unsigned copies = chance(number, 1) * 100 < is.twice ? 2 : 1;
      count[from].twice += copies - 1;
      for (unsigned copy = 0; copy < copies; ++copy) {
        const double ms = is.delay + is.jitter * chance(number, 2 + copy);
        under_way.push({clock_type::now() + std::chrono::nanoseconds(static_cast<std::int64_t>(ms * 1e6)),
                        order++,
                        1 - from,
                        {bytes.data(), bytes.data() + size}});
      }
    }
  }
  void give() {
    for (; !under_way.empty() && under_way.top().due <= clock_type::now(); under_way.pop()) {
      const frame& one = under_way.top();
      if (is_cut) ++count[1 - one.to].lost;  // it was in the cable
      else count[1 - one.to].gone += ::send(ends[one.to], one.bytes.data(), one.bytes.size(), 0) > 0;
    }
  }
  // False: nobody is there any more.
  bool obey() {
    std::array<char, 64> text{};
    const ssize_t size = ::read(STDIN_FILENO, text.data(), text.size());
    if (size <= 0) return false;
    for (const char* const word : {"cut", "mend"})
      if (std::string_view(text.data(), static_cast<std::size_t>(size)).find(word) !=
          std::string_view::npos) {
        is_cut = std::string_view(word) == "cut";
        const std::chrono::duration<double> at = clock_type::now().time_since_epoch();
        std::printf("%s at %.3f s\n", word, at.count());
        std::fflush(stdout);
      }
    return true;
  }
  // From 0 to 1.
  double chance(std::uint64_t number, std::uint64_t question) const {
    return static_cast<double>(mixed(static_cast<std::uint64_t>(is.seed) ^ mixed(8 * number + question)) >>
                               11) *
           0x1p-53;
  }

  struct counts {
    unsigned long long came = 0, lost = 0, gone = 0, twice = 0;
  };

  std::array<int, 2> ends;
  settings is;
  bool is_cut = false;
  std::uint64_t order = 0;
  std::array<counts, 2> count{};
  std::priority_queue<frame> under_way{};
};

}  // namespace

int main(int words, char** word) {
  if (words == 3 && std::string_view(word[1]) == "--checksums") return write_checksums(word[2]), 0;
  settings s;
  const std::map<std::string_view, double*> options{{"--loss", &s.loss},
                                                    {"--delay", &s.delay},
                                                    {"--jitter", &s.jitter},
                                                    {"--twice", &s.twice},
                                                    {"--seed", &s.seed}};
  if (words < 3 || words % 2 == 0) {
    std::puts("cable A B [--loss %] [--delay ms] [--jitter ms] [--twice %] [--seed N]");
    return 2;
  }
  for (int i = 3; i < words; i += 2) {
    const auto found = options.find(word[i]);
    if (found == options.end()) return std::printf("cable: there is no option %s\n", word[i]), 2;
    *found->second = std::atof(word[i + 1]);
  }
  ::prctl(PR_SET_TIMERSLACK, 1UL);
  cable(word[1], word[2], s).run();
}
