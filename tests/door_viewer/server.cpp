// A door with a program behind it that only pretends, for clients of others and for measuring: CHANNELS at
// RATE Hz, with the wall clock as time. Ends when its input ends.
// use: cca_door_server PORT TOKEN CHANNELS RATE [PAGE]
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include <cca/door/server.hpp>

#include "../runtime/door/fake_controls.hpp"

int main(int count, char** words) {
  if (count < 5) return std::puts("use: cca_door_server PORT TOKEN CHANNELS RATE [PAGE]"), 2;
  door_test::fake_controls controls;
  cca::door_settings settings;
  settings.port = static_cast<std::uint16_t>(std::atoi(words[1]));
  settings.token = words[2];
  settings.page = count > 5 ? words[5] : "";
  const int channels = std::atoi(words[3]);
  const double rate = std::atof(words[4]);
  cca::detail::door_server door(settings, controls);
  std::printf("once: %s\n", door.one_time_url().c_str());
  std::fflush(stdout);
  std::atomic<bool> ends{false};
  std::thread writer([&] {
    for (int i = 1; i <= channels; ++i)
      door.sink().channel({.id = static_cast<std::uint16_t>(i),
                           .topic = "/joint" + std::to_string(i),
                           .type = "cca/msg/values",
                           .schema = "uint64 beat\nfloat64[7] values\n",
                           .is_kept = i == channels});
    const auto period = std::chrono::nanoseconds(static_cast<long>(1e9 / rate));
    auto due = std::chrono::steady_clock::now();
    for (std::uint64_t beat = 0; !ends; ++beat) {
      unsigned char bytes[68] = {0, 1};
      std::memcpy(bytes + 4, &beat, 8);
      for (int i = 1; i <= channels; ++i) {
        const auto time =
            static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
        door.sink().message(static_cast<std::uint16_t>(i), time, time, {bytes, sizeof bytes});
      }
      door.sink().hand_over();
      std::this_thread::sleep_until(due += period);
    }
  });
  while (std::getchar() != EOF) {}
  ends = true;
  writer.join();
}
