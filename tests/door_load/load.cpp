// A controller at 1 kHz with an open door, and in a process of its own what loads the door: clients that read
// all outputs, and connections a second that come and go. It prints what the loop has seen.
//   cca_door_load [--clients N] [--connects RATE] [--seconds S] [--fifo] [--core N] [--check]
// Beside it another process runs the same controller at the same time, with a door that nobody opens. What
// the machine does to a loop it does to both: a beat that is late in one alone is told.
// --fifo: the loop's thread has the scheduling class SCHED_FIFO, which a program may need a right for.
// --core: both loops run on this core, and all else of both processes on the others.
// --check: fails unless the memory is bounded, half of the wanted connections came, and each client reads
// half of the beats or is told what it has lost. A busy machine can do that, too. docs/door.md has figures.
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <vector>

#include <cca/cca.hpp>
#include <cca/door.hpp>

#include "../laws/resident_memory.hpp"
#include "../runtime/door/client.hpp"

namespace {

using namespace std::chrono_literals;
using clock_type = std::chrono::steady_clock;
constexpr const char* token = "0123456789abcdef0123456789abcdef";

struct six : cca::space<cca::number, cca::axes<cca::x, cca::y, cca::z>, cca::rate<1000>> {};
template <int Of>
struct source {
  auto process(cca::beat now) -> cca::out<"y", six> {
    return Eigen::Vector3d(Of, static_cast<double>(now.index()), 0.5);
  }
};
// When beats began late, on the clock of the machine, and the time since the one before.
struct late_beats {
  static constexpr std::size_t most = 1 << 16;
  static constexpr std::int64_t very = 1'500'000, a_little = 1'100'000;
  struct beat {
    std::int64_t at, since;
  };
  std::array<beat, most> beats;
  std::size_t count;

  std::span<const beat> all() const { return std::span(beats).first(count); }
  long very_late() const {
    return std::ranges::count_if(all(), [](const beat& b) { return b.since > very; });
  }
};
struct watch {
  auto process(cca::beat) -> cca::out<"y", six> {
    const std::int64_t now = cca::detail::monotonic_clock::now();
    if (before != 0 && now - before > late_beats::a_little && to->count < late_beats::most)
      to->beats[to->count++] = {now, now - before};
    before = now;
    return Eigen::Vector3d(0, 0, 0);
  }
  late_beats* to = nullptr;
  std::int64_t before = 0;
};
struct graph : cca::graph<cca::rate<1000>,
                          cca::node<"watch", watch, cca::timed<1>>,
                          cca::node<"a", source<0>, cca::timed<1>>,
                          cca::node<"b", source<1>, cca::timed<1>>,
                          cca::node<"c", source<2>, cca::timed<1>>,
                          cca::node<"d", source<3>, cca::timed<1>>,
                          cca::node<"e", source<4>, cca::timed<1>>,
                          cca::node<"f", source<5>, cca::timed<1>>,
                          cca::node<"g", source<6>, cca::timed<1>>,
                          cca::node<"h", source<7>, cca::timed<1>>,
                          cca::node<"i", source<8>, cca::timed<1>>,
                          cca::node<"j", source<9>, cca::timed<1>>>,
               cca::recordable {};
constexpr int outputs = 10;
constexpr std::size_t kept_for_twins = 1 << 18;  // bytes: full within seconds, so the memory can stay

struct wishes {
  int clients = 0;
  double connects = 0, seconds = 3;
  int core = -1;
  bool fifo = false, checks = false;
};

// ---- the process of the clients ----

struct counted {
  std::uint64_t samples = 0, told_lost = 0, connects = 0, closed = 0;
};

// Frames as they are, without a copy of each.
struct reader {
  explicit reader(std::uint16_t port) : c(port, token) {
    for (int i = 0; i < outputs; ++i)
      c.subscribe(static_cast<std::uint32_t>(i + 1),
                  c.channel("/" + std::string(1, static_cast<char>('a' + i)) + "/y"));
    is_open = c.is_open;
  }
  door_test::client c;
  bool is_open = false;
  counted seen{};

  void read() {
    while (c.wire.receive(0ms)) {
      if (c.wire.is_closed) break;
      c.wire.received.erase(
          0, door_test::each_frame(c.wire.received, [&](int kind, std::string_view payload) {
            if (kind == 9) c.wire.send(door_test::frame_of(0x8a, payload));
            if (kind == 2 && payload.starts_with('\1')) ++seen.samples;
            if (const auto lost = payload.find("has lost "); kind == 1 && lost != payload.npos)
              seen.told_lost += std::strtoull(payload.data() + lost + 9, nullptr, 10);
          }));
    }
    is_open = is_open && !c.wire.is_closed;
  }
};

// A connection that ends with a reset: it leaves no port in use behind.
void connect_and_go(std::uint16_t port, std::uint64_t number, counted& all) {
  door_test::raw_connection wire(port);
  all.connects += wire.is_connected;
  if (number % 4 == 1) wire.send("GET / HT");
  if (number % 4 == 2) wire.send(door_test::greeting_of(port, {.host = "evil.example"}));
  if (number % 4 == 3) wire.send(door_test::greeting_of(port, {}));
  wire.reset();
}

// Until it is told to end; writes what it has counted.
int load(const wishes& w, std::uint16_t port, int to) {
  ::signal(SIGPIPE, SIG_IGN);
  std::list<reader> readers;
  for (int i = 0; i < w.clients; ++i)
    if (!readers.emplace_back(port).is_open) return 1;
  counted all;
  static volatile std::sig_atomic_t ends = 0;
  ::signal(SIGTERM, [](int) { ends = 1; });
  const auto begin = clock_type::now();
  for (std::uint64_t n = 0; !ends;) {
    if (w.connects > 0)
      while (std::chrono::duration<double>(clock_type::now() - begin).count() * w.connects >
                 static_cast<double>(n) &&
             !ends)
        connect_and_go(port, n++, all);
    for (reader& one : readers) one.read();
    std::this_thread::sleep_for(1ms);
  }
  std::uint64_t least = ~std::uint64_t{0};
  for (const reader& one : readers) {
    least = std::min(least, one.seen.samples);
    all.samples += one.seen.samples, all.told_lost += one.seen.told_lost, all.closed += !one.is_open;
  }
  char line[160];
  const int size = std::snprintf(
      line, sizeof line, "%llu %llu %llu %llu %llu\n", static_cast<unsigned long long>(all.samples),
      static_cast<unsigned long long>(readers.empty() ? 0 : least),
      static_cast<unsigned long long>(all.told_lost), static_cast<unsigned long long>(all.connects),
      static_cast<unsigned long long>(all.closed));
  return ::write(to, line, static_cast<std::size_t>(size)) == size ? 0 : 1;
}

// ---- the process of the controller ----

// The calling thread, and those that it starts from now on.
int stays_on(const cpu_set_t& cores) {
  const int wrong = ::pthread_setaffinity_np(::pthread_self(), sizeof cores, &cores);
  if (wrong) std::fprintf(stderr, "--core: %s\n", std::strerror(wrong));
  return wrong;
}
int leave_its_core(const wishes& w) {
  cpu_set_t cores;
  ::pthread_getaffinity_np(::pthread_self(), sizeof cores, &cores);
  if (w.core < 0) return 0;
  CPU_CLR(w.core, &cores);
  return stays_on(cores);
}
int become_the_loop(const wishes& w) {
  if (w.core >= 0) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(w.core, &one);
    if (const int wrong = stays_on(one)) return wrong;
  }
  if (!w.fifo) return 0;
  const sched_param first{40};
  const int wrong = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &first);
  if (wrong) std::fprintf(stderr, "--fifo: %s\n", std::strerror(wrong));
  return wrong;
}
std::int64_t beats_of(const wishes& w) { return static_cast<std::int64_t>(w.seconds * 1000); }

int run_beside(const wishes& w, late_beats& late) {
  cca::controller<graph> c;
  c.get<"watch">().to = &late;
  c.load();
  c.start();
  cca::door door(c, {.port = 0, .token = token, .tells_where = false, .twin_memory = kept_for_twins});
  if (become_the_loop(w)) return 2;
  c.run(cca::for_some_beats{beats_of(w)}, cca::at_wall_clock(), door);
  std::printf("beside it, without a client: %lld beats, %lld overruns, %lld periods without a beat\n",
              static_cast<long long>(c.beat_index()), static_cast<long long>(c.overruns()),
              static_cast<long long>(c.lost_periods()));
  std::fflush(stdout);
  return 0;
}
// Those of `some` that were late where none of `others` was even a little, within 20 ms.
long alone(const late_beats& some, const late_beats& others) {
  return std::ranges::count_if(some.all(), [&](const late_beats::beat& one) {
    return one.since > late_beats::very &&
           std::ranges::none_of(others.all(), [&](const late_beats::beat& other) {
             return std::abs(other.at - one.at) < 20'000'000;
           });
  });
}

int run(const wishes& w) {
  if (leave_its_core(w)) return 2;
  void* const room =
      ::mmap(nullptr, 2 * sizeof(late_beats), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return std::perror("mmap"), 3;
  auto* const late = static_cast<late_beats*>(room);
  const pid_t beside = ::fork();
  if (beside == 0) ::_exit(run_beside(w, late[1]));
  cca::controller<graph> c;
  c.get<"watch">().to = &late[0];
  c.load();
  c.start();
  int port_to_load[2], counts[2];
  if (::pipe(port_to_load) != 0 || ::pipe(counts) != 0) return std::perror("pipe"), 3;
  const pid_t other = ::fork();  // before there is a thread
  if (other == 0) {
    std::uint16_t port = 0;
    if (::read(port_to_load[0], &port, sizeof port) != sizeof port) ::_exit(1);
    ::_exit(load(w, port, counts[1]));
  }
  ::close(counts[1]);
  cca::door door(c, {.port = 0, .token = token, .tells_where = false, .twin_memory = kept_for_twins});
  const std::uint16_t port = door.port();
  if (::write(port_to_load[1], &port, sizeof port) != sizeof port) return 3;
  // Looked at by another thread, which is none of the loop's class: the loop makes no call of the system.
  std::vector<long> memory;
  std::jthread looks([&](const std::stop_token& end) {
    const auto every = std::chrono::duration<double>(w.seconds / 20);
    for (auto due = clock_type::now(); !end.stop_requested();) {
      due += std::chrono::duration_cast<clock_type::duration>(every);
      while (clock_type::now() < due && !end.stop_requested()) std::this_thread::sleep_for(10ms);
      if (!end.stop_requested()) memory.push_back(laws::resident_memory());
    }
  });
  if (become_the_loop(w)) return 2;
  const std::int64_t beats = beats_of(w);
  c.run(cca::for_some_beats{beats}, cca::at_wall_clock(), door);
  looks.request_stop();
  looks.join();
  ::kill(other, SIGTERM);
  unsigned long long samples = 0, least = 0, lost = 0, connects = 0, closed = 0;
  std::FILE* const from = ::fdopen(counts[0], "r");
  const bool has_counts =
      std::fscanf(from, "%llu %llu %llu %llu %llu", &samples, &least, &lost, &connects, &closed) == 5;
  std::fclose(from);
  ::waitpid(other, nullptr, 0);
  int of_beside = 0;
  ::waitpid(beside, &of_beside, 0);
  if (!has_counts) return std::fprintf(stderr, "the clients have failed\n"), 1;

  const std::size_t quarter = memory.size() / 4;
  const long before = memory.size() > quarter ? memory[quarter] : 0,
             after = memory.empty() ? 0 : memory.back();
  std::printf("%d clients, %.0f connects/s, %.0f s: %lld beats, %lld overruns, %lld periods without a beat\n",
              w.clients, w.connects, w.seconds, static_cast<long long>(c.beat_index()),
              static_cast<long long>(c.overruns()), static_cast<long long>(c.lost_periods()));
  std::printf("beats that began late: %ld, beside it %ld; late in one of them alone: %ld here, %ld there\n",
              late[0].very_late(), late[1].very_late(), alone(late[0], late[1]), alone(late[1], late[0]));
  std::printf("memory of the controller: %ld KiB after a quarter, %ld KiB at the end\n", before, after);
  std::printf("samples read: %llu, of the slowest client %llu of %lld; told to be lost: %llu; closed: %llu\n",
              samples, least, static_cast<long long>(beats) * outputs, lost, closed);
  std::printf("connects: %llu\n", connects);
  if (!w.checks) return 0;
  const auto fail = [](const char* what) { return std::fprintf(stderr, "failed: %s\n", what), 1; };
  const auto wanted = static_cast<double>(beats - c.lost_periods()) * outputs;
  if (of_beside != 0) return fail("the controller beside it has failed");
  // What waits for each client is bounded; here it may wait for the first time.
  if (after - before > 16384 + 3072l * w.clients) return fail("the memory has grown beyond its bound");
  if (closed > 0) return fail("a client was closed");
  if (w.clients > 0 && static_cast<double>(least + lost) < 0.5 * wanted)
    return fail("a client has read less than half, and was not told so");
  if (static_cast<double>(connects) < 0.5 * w.connects * w.seconds) return fail("too few connects");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  wishes w;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--check") w.checks = true;
    else if (word == "--fifo") w.fifo = true;
    else if (i + 1 == count) return std::fprintf(stderr, "%s: no value\n", words[i]), 2;
    else if (word == "--clients") w.clients = std::atoi(words[++i]);
    else if (word == "--core") w.core = std::atoi(words[++i]);
    else if (word == "--connects") w.connects = std::atof(words[++i]);
    else if (word == "--seconds") w.seconds = std::atof(words[++i]);
    else return std::fprintf(stderr, "%s: unknown\n", words[i]), 2;
  }
  return run(w);
}
