// Random and wrong messages to a door, over connections: nothing changes that was not allowed, nobody else
// waits, and the memory stays.
//   cca_door_noise [--messages N] [--seed N]
// A third are greetings, a third are frames, a third are right frames with random or mutated messages: of a
// client without the token, and of one that has it but does not command. Meanwhile another one commands, and
// reads.
// Exit code 1: the program behind the door was asked for something other than the emergency stop by a client
// with the token, the reader had to wait, or the memory has grown. docs/door.md has the figures.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "../laws/resident_memory.hpp"
#include "../runtime/door/opened.hpp"

namespace {

using namespace door_test;
using clock_type = std::chrono::steady_clock;
using about = fake_controls::about;

class noise {
public:
  explicit noise(std::uint64_t seed) : random(seed) {}

  std::size_t below(std::size_t most) {
    return std::uniform_int_distribution<std::size_t>(0, most - 1)(random);
  }
  std::string bytes(std::size_t most) {
    std::string all(below(most + 1), '\0');
    for (char& byte : all) byte = static_cast<char>(below(256));
    return all;
  }
  // Some bytes are others, missing, or there twice.
  std::string mutated(std::string text) {
    for (std::size_t n = below(4); n > 0 && !text.empty(); --n) {
      const std::size_t at = below(text.size());
      if (const auto how = below(4); how == 0) text[at] = static_cast<char>(below(256));
      else if (how == 1) text.erase(at, 1 + below(4));
      else if (how == 2) text.insert(at, text.substr(at, 1 + below(16)));
      else text.resize(at);
    }
    return text;
  }
  std::string greeting(std::uint16_t port) {
    greeting_words with;
    switch (below(8)) {
      case 0:
        with.host = mutated("127.0.0.1:" + std::to_string(port));
        break;
      case 1:
        with.origin = mutated("http://127.0.0.1:" + std::to_string(port));
        break;
      case 2:
        with.protocols = mutated("foxglove.sdk.v1, cca.v1, cca.token.0123");
        break;
      case 3:
        with.target = mutated("/?once=0123456789abcdef");
        break;
      case 4:
        with.version = mutated("13");
        break;
      case 5:
        with.method = mutated("GET");
        break;
      case 6:
        with.more = "\r\nContent-Length: " + std::to_string(below(1'000'000'000));
        break;
      default:
        return bytes(600);
    }
    return below(3) == 0 ? mutated(greeting_of(port, with)) : greeting_of(port, with);
  }
  std::string message() {
    static const std::vector<std::string> right{
        R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1},{"id":2,"channelId":60001}]})",
        R"({"op":"unsubscribe","subscriptionIds":[1,2]})",
        R"({"op":"setParameters","parameters":[{"name":"gait.frequency","value":2.5}],"id":"a"})",
        R"({"op":"setParameters","parameters":[{"name":"gait.gains","value":[1,2,3]}]})",
        R"({"op":"getParameters","parameterNames":["gait.steps"],"id":"b"})",
        R"({"op":"subscribeParameterUpdates","parameterNames":[]})",
        R"({"op":"subscribeConnectionGraph"})",
        R"({"op":"cca.describe"})",
        R"({"op":"cca.twin","says":"the same, bit for bit"})",
        R"({"op":"cca.token","token":"0123456789abcdef"})",
        R"({"op":"advertise","channels":[{"id":1,"topic":"/a","encoding":"json","schemaName":"x"}]})",
        "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[",
        R"({"op":1e999})"};
    return mutated(right[below(right.size())]);
  }
  std::string call() {
    static const std::vector<std::string> right{"{}",
                                                R"({"beats":3})",
                                                R"({"factor":0.5})",
                                                R"({"file":"a.toml"})",
                                                R"({"force":10,"angle":1})",
                                                R"({"mode":"stand"})"};
    const auto id = static_cast<std::uint32_t>(below(30));
    std::string one = client::bytes_of_call(id, id, below(2) == 0 ? "{}" : right[below(right.size())]);
    return below(2) == 0 ? one : mutated(std::move(one));
  }
  std::string frame() {
    if (below(4) == 0) return bytes(200);
    std::string one = frame_of(static_cast<unsigned>(below(256)), bytes(below(8) == 0 ? 70'000 : 150));
    return below(2) == 0 ? mutated(one) : one;
  }

private:
  std::mt19937_64 random;
};

}  // namespace

int main(int count, char** words) {
  std::uint64_t messages = 30'000, seed = 1;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (i + 1 == count) return std::fprintf(stderr, "%s: no value\n", words[i]), 2;
    if (word == "--messages") messages = std::strtoull(words[++i], nullptr, 10);
    else if (word == "--seed") seed = std::strtoull(words[++i], nullptr, 10);
    else return std::fprintf(stderr, "%s: unknown\n", words[i]), 2;
  }
  opened one({.most_clients = 8}, {.messages_per_second = 1e9, .bytes_per_second = 1e12});
  one.channel(1, "/a");

  // Who reads has a sample each millisecond; the longest time from its making to its coming is kept.
  std::atomic<bool> ends{false}, commands{false}, is_lost{false};
  std::atomic<std::int64_t> longest{0};
  std::thread reads([&] {
    client c(one.port(), token);
    commands = c.call("/cca/take_command").empty();
    (void)c.waits([&] { return c.channel("/a") == 1; });
    c.subscribe(1, 1);
    while (!ends) {
      const auto now = clock_type::now();
      one.message(1, static_cast<std::uint64_t>(now.time_since_epoch().count()), "x");
      c.read(std::chrono::milliseconds(1));
      c.texts.clear(), c.times.clear();
      for (const auto& sample : c.samples)
        longest = std::max(longest.load(), clock_type::now().time_since_epoch().count() -
                                               static_cast<std::int64_t>(sample.time));
      c.samples.clear();
      if (c.wire.is_closed) return void(is_lost = true);
    }
    commands = c.call("/cca/take_command").empty();  // still
  });
  if (!soon([&] { return commands.load(); })) return std::fprintf(stderr, "nobody commands\n"), 1;

  noise random(seed);
  long early = 0;
  std::uint64_t closed = 0;
  const auto begin = clock_type::now();
  const auto fresh = [&](bool has_token) {
    auto made = std::make_unique<client>(one.port(), has_token ? token : "");
    for (int i = 0; i < 100 && !made->is_open; ++i) {  // its place may not be free yet
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      made = std::make_unique<client>(one.port(), has_token ? token : "");
    }
    return made;
  };
  std::unique_ptr<client> all[4];  // frames and messages, without the token and with it
  std::uint64_t unopened = 0;
  for (std::uint64_t n = 0; n < messages; ++n) {
    if (n == messages / 5) early = laws::resident_memory();
    if (n % 3 == 0) {
      raw_connection wire(one.port());
      wire.send(random.greeting(one.port()));
      if (n % 30 == 0) wire.receive(std::chrono::milliseconds(1));
      wire.reset();
      continue;
    }
    const bool is_frame = n % 3 == 1, has_token = n / 3 % 2 == 1;
    auto& c = all[(is_frame ? 0 : 2) + has_token];
    if (!c || c->wire.is_closed) {
      closed += c != nullptr;
      c = fresh(has_token);
      if (!c->is_open) ++unopened;
    }
    const bool sent = is_frame ? c->wire.send(random.frame())
                               : c->wire.send(random.below(3) == 0 ? frame_of(0x82, random.call())
                                                                   : frame_of(0x81, random.message()));
    while (c->wire.receive(std::chrono::milliseconds(0)) && !c->wire.is_closed) c->wire.received.clear();
    if (!sent) c->wire.is_closed = true;
  }
  const double seconds = std::chrono::duration<double>(clock_type::now() - begin).count();
  ends = true;
  reads.join();
  const long late = laws::resident_memory();
  std::size_t stops = 0, others = 0;
  for (const auto& what : one.controls.asked()) ++(what.about == about::end_run ? stops : others);
  client last(one.port(), token);
  last.text({{"op", "getParameters"}});
  const bool works = last.is_open && last.next("parameterValues")["parameters"].size() == 5;
  std::printf("%llu messages in %.0f s, %llu connections ended by the door, %llu could not be made again\n",
              static_cast<unsigned long long>(messages), seconds, static_cast<unsigned long long>(closed),
              static_cast<unsigned long long>(unopened));
  std::printf("asked of the program: %zu emergency stops, %zu others\n", stops, others);
  std::printf("longest wait of a reader: %.1f ms; memory %ld KiB after a fifth, %ld KiB at the end\n",
              1e-6 * static_cast<double>(longest), early, late);
  const auto fail = [](const char* what) { return std::fprintf(stderr, "failed: %s\n", what), 1; };
  if (others > 0) return fail("something changed that was not allowed");
  if (stops == 0) return fail("no call came through: these messages test nothing");
  if (closed == 0) return fail("no connection was ended: these messages test nothing");
  if (is_lost || !commands) return fail("who commands has lost its connection, or the right");
  if (!works) return fail("the door does not answer any more");
  if (late - early > 16384) return fail("the memory has grown by more than 16 MiB");
  if (longest > 1'000'000'000) return fail("a reader has waited for more than a second");
  return 0;
}
