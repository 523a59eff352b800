// How many messages a second go through a door, and how late they come: clients on sockets in this program,
// each of which reads all channels. Late is from the call of the recording's thread to the client's read.
//   bench_door [--channels N] [--rate HZ] [--clients N] [--seconds S] [--batches] [--check]
// --batches: the clients take many samples in one message (cca.batches.v1).
// --check: fails unless all come, p99 is below 2 ms, and CPU and memory are printed as ever.
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <list>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <poll.h>

#include <cca/door/server.hpp>

#include "../tests/laws/resident_memory.hpp"
#include "../tests/runtime/door/opened.hpp"

namespace {

std::uint64_t now() {
  return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
}
double cpu_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

// Reads frames as they are, without a copy of each.
struct reader {
  explicit reader(std::uint16_t port) : wire(port) {}
  door_test::raw_connection wire;
  std::uint64_t messages = 0;

  template <class Late>
  void read(Late&& late) {
    if (!wire.receive(std::chrono::milliseconds(0))) return;
    const std::uint64_t time = now();
    wire.received.erase(0, door_test::each_frame(wire.received, [&](int kind, std::string_view payload) {
                          if (kind == 9) wire.send(door_test::frame_of(0x8a, ""));
                          if (kind == 2 && payload.starts_with('\1')) {
                            std::uint64_t sent;
                            std::memcpy(&sent, payload.data() + 5, 8);
                            late(time - sent);
                            ++messages;
                          }
                          if (kind == 2 && payload.starts_with('\xca')) {
                            ++messages;
                            for (std::size_t i = 1; i < payload.size();) {
                              std::uint64_t sent;
                              std::uint32_t bytes;
                              std::memcpy(&sent, payload.data() + i + 4, 8);
                              std::memcpy(&bytes, payload.data() + i + 12, 4);
                              late(time - sent);
                              i += 16 + bytes;
                            }
                          }
                        }));
  }
};

}  // namespace

int main(int count, char** words) {
  int channels = 10, clients = 1;
  double rate = 1000, seconds = 3;
  bool checks = false, in_batches = false;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--check") checks = true;
    else if (word == "--batches") in_batches = true;
    else if (i + 1 == count) return std::fprintf(stderr, "%s: no value\n", words[i]), 2;
    else if (word == "--channels") channels = std::atoi(words[++i]);
    else if (word == "--clients") clients = std::atoi(words[++i]);
    else if (word == "--rate") rate = std::atof(words[++i]);
    else if (word == "--seconds") seconds = std::atof(words[++i]);
    else return std::fprintf(stderr, "%s: unknown\n", words[i]), 2;
  }
  door_test::opened one;
  for (int i = 1; i <= channels; ++i)
    one.channel(static_cast<std::uint16_t>(i), "/joint" + std::to_string(i));
  std::list<reader> readers;
  std::string subscribe = "{\"op\":\"subscribe\",\"subscriptions\":[";
  for (int i = 1; i <= channels; ++i)
    subscribe +=
        (i > 1 ? ",{\"id\":" : "{\"id\":") + std::to_string(i) + ",\"channelId\":" + std::to_string(i) + "}";
  for (int i = 0; i < clients; ++i) {
    auto& r = readers.emplace_back(one.port());
    r.wire.send(door_test::greeting_of(
        one.port(),
        {.protocols = in_batches ? "foxglove.websocket.v1, cca.batches.v1" : "foxglove.websocket.v1"}));
    if (!r.wire.comes("\r\n\r\n")) return std::fprintf(stderr, "a client was not let in\n"), 1;
    r.wire.received.erase(0, r.wire.received.find("\r\n\r\n") + 4);
    r.wire.send(door_test::frame_of(0x81, subscribe + "]}"));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));

  std::atomic<bool> ends{false};
  const auto beats = static_cast<std::uint64_t>(seconds * rate);
  const double cpu = cpu_seconds();
  const long memory = laws::resident_memory();
  std::thread writer([&] {
    unsigned char bytes[68] = {0, 1};
    auto due = std::chrono::steady_clock::now();
    for (std::uint64_t beat = 0; beat < beats; ++beat) {
      std::memcpy(bytes + 4, &beat, 8);
      for (int i = 1; i <= channels; ++i) {
        const std::uint64_t time = now();
        one.door.sink().message(static_cast<std::uint16_t>(i), time, time, {bytes, sizeof bytes});
      }
      one.door.sink().hand_over();
      std::this_thread::sleep_until(due += std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / rate)));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ends = true;
  });
  std::vector<std::uint32_t> late;
  late.reserve(static_cast<std::size_t>(1e6));
  std::uint64_t seen = 0, messages = 0;
  while (!ends) {
    for (auto& r : readers)
      r.read([&](std::uint64_t ns) {
        if (late.size() < late.capacity())
          late.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(ns, 0xffffffff)));
        ++seen;
      });
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  writer.join();
  for (const auto& r : readers) messages += r.messages;
  std::sort(late.begin(), late.end());
  const auto quantile = [&](double p) {
    return late.empty() ? 0.0
                        : 1e-3 * late[static_cast<std::size_t>(p * static_cast<double>(late.size() - 1))];
  };
  const std::uint64_t all =
      beats * static_cast<std::uint64_t>(channels) * static_cast<std::uint64_t>(clients);
  std::printf(
      "%d channels at %.0f Hz, %d clients: %.0f samples/s in %.0f messages/s, late %.0f us p50, %.0f us p99, "
      "%.0f us most, "
      "lost %llu, %.0f %% of a core, memory %ld + %ld KiB\n",
      channels, rate, clients, static_cast<double>(seen) / seconds, static_cast<double>(messages) / seconds,
      quantile(0.5), quantile(0.99), quantile(1), static_cast<unsigned long long>(all - seen),
      100 * (cpu_seconds() - cpu) / seconds, memory, laws::resident_memory() - memory);
  return checks && (seen != all || quantile(0.99) > 2000) ? 1 : 0;
}
