// A twin computes what the robot computes, bit for bit, or says where the first difference is.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cca/modes.hpp>
#include <cca/record/twin.hpp>

#include "two_modes.hpp"
#include "twin_stream.hpp"

using namespace record_test;

namespace {

struct graph : walking<> {};
struct other_graph : cca::graph<cca::rate<1000>,
                                cca::node<"leg", leg>,
                                cca::node<"limits", cca::limiter<leg_angles>>,
                                cca::wire<"leg.angles", "limits.command">,
                                cca::wire<"limits.safe", "leg.command">>,
                     cca::recordable {};

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>>, cca::recordable {};

struct swing_alone {
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"angles", leg_angles> { return 0.9 * x.vector(); }
};
// A robot that senses more than its components read.
struct seeing_leg : leg {
  auto sense() -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"unread", leg_angles>> {
    return {leg::sense(), Eigen::Vector2d(0.1, -0.2)};
  }
};
struct seeing : cca::graph<cca::rate<1000>,
                           cca::node<"swing", swing_alone, cca::timed<1>>,
                           cca::node<"limits", cca::limiter<leg_angles>>,
                           cca::node<"leg", seeing_leg>,
                           cca::wire<"leg.angles", "swing.x">,
                           cca::wire<"swing.angles", "limits.command">,
                           cca::wire<"limits.safe", "leg.command">,
                           cca::observe<"leg.unread">>,
                cca::recordable {};

// 5000 beats at most; the graph faults after 4.2 s.
struct walks {
  template <class Controller>
  void operator()(Controller& c) const {
    c.run(cca::for_beats<1000>{});
    c.template set<"filter">({0.3, "slow"});
    c.run(cca::for_beats<4000>{});
  }
};
template <class Graph, class Drive = walks>
bytes stream_of_run(const streaming::change& change = {}, Drive drive = {}) {
  cca::controller<Graph> c;
  return stream_of(c, change, [&] { drive(c); });
}

template <class Graph>
cca::recording::replay_result twin_of(const bytes& stream, std::size_t piece = std::size_t(-1)) {
  cca::recording::twin<Graph> twin;
  std::span<const unsigned char> left(stream);
  cca::recording::replay_result last;
  while (!left.empty()) {
    const auto now = left.first(std::min(piece, left.size()));
    last = twin.take(now);
    left = left.subspan(now.size());
  }
  return last;
}

bool last_bit(bytes& message, std::size_t number) {
  message.at(4 + 16 + 8 * number) ^= 1;
  return true;
}

}  // namespace

TEST_CASE("a twin computes the same bits") {
  const bytes stream = stream_of_run<graph>();
  const auto result = twin_of<graph>(stream);
  INFO(result);
  CHECK(result);
  CHECK(result.beats > 3000);
  CHECK(result.samples > 2 * result.beats);
}

TEST_CASE("the twin of a set of modes goes through the same modes") {
  const auto drive = [](auto& c) {
    c.run(cca::for_beats<250>{});  // a component switches in beat 200
    c.template set<"gait">({0.4});
    c.run(cca::for_beats<250>{});
    c.template switch_to<"stand">();
    c.run(cca::for_beats<100>{});
  };
  const auto result = twin_of<legs>(stream_of_run<legs>({}, drive));
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 600);
  const auto other = twin_of<legs>(stream_of_run<legs>(
      [](const std::string& topic, std::int64_t beat, bytes&) { return topic != "/cca/mode" || beat < 400; },
      drive));
  CHECK_FALSE(other);
  CHECK(other.beat == 500);
}

TEST_CASE("what no component reads is not sent") {
  const auto drive = [](auto& c) { c.run(cca::for_beats<100>{}); };
  const bytes stream = stream_of_run<seeing>({}, drive);
  const auto result = twin_of<seeing>(stream);
  INFO(result);
  CHECK(result);
  CHECK(result.samples == 2 * 100);
  const std::string_view all(reinterpret_cast<const char*>(stream.data()), stream.size());
  CHECK(all.find("/leg/angles") != all.npos);
  CHECK(all.find("/leg/unread") == all.npos);
}

TEST_CASE("the stream may come in any pieces") {
  const bytes stream = stream_of_run<graph>();
  const auto whole = twin_of<graph>(stream);
  for (const std::size_t piece : {1u, 7u, 4096u}) {
    const auto result = twin_of<graph>(stream, piece);
    CHECK(result);
    CHECK(result.beats == whole.beats);
    CHECK(result.samples == whole.samples);
  }
}

TEST_CASE("a stream is smaller than all outputs") {
  std::size_t all = 0;
  static std::size_t* count;
  count = &all;
  const bytes stream = stream_of_run<graph>([](const std::string&, std::int64_t, bytes& message) {
    *count += message.size() + 15;  // with the head of a message of the protocol, and of its frame
    return true;
  });
  CHECK(stream.size() < all / 2);
}

TEST_CASE(
    "one bit of what a component has published is the first difference, with component, port and beat") {
  const auto result =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes& message) {
        return topic != "/limits/safe" || beat != 1234 || last_bit(message, 1);
      }));
  CHECK_FALSE(result);
  CHECK(result.component == "limits");
  CHECK(result.port == "safe");
  CHECK(result.beat == 1234);
  CHECK(result.difference.starts_with("`limits.safe`, beat 1234: robot other bits, twin ["));
}

TEST_CASE("the time of origin counts, too") {
  const auto result =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes& message) {
        if (topic == "/swing/angles" && beat == 17) message.at(4 + 8) ^= 1;
        return true;
      }));
  CHECK(result.component == "swing");
  CHECK(result.beat == 17);
}

TEST_CASE("one bit of what the robot sensed is found where it has an effect") {
  const auto result =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes& message) {
        if (topic == "/leg/angles" && beat == 1230) message.at(4 + 16 + 4) ^= 1;  // 1 in 2^20 of the hip
        return true;
      }));
  CHECK(result.component == "filter");
  CHECK(result.port == "y");
  CHECK(result.beat == 1230);
}

TEST_CASE("a sample that only one of both has is a difference") {
  const auto result =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes&) {
        return topic != "/filter/y" || beat != 500;
      }));
  CHECK(result.component == "filter");
  CHECK(result.beat == 500);
  CHECK(result.difference.find("robot nothing, twin [") != std::string::npos);
}

TEST_CASE("what was lost is no difference, and it is not the same either") {
  const auto sensed =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes&) {
        return topic != "/leg/angles" || beat != 500;
      }));
  CHECK_FALSE(sensed);
  CHECK(sensed.difference.empty());
  CHECK(sensed.ended_early.starts_with("what `leg.angles` sensed in beat 500 is missing"));

  // Beats that did not fit into the ring: all of one, and the message that says so.
  streaming stream;
  {
    cca::controller<graph> c;
    cca::recording::recorder recording(c, {.buffered_seconds = 0.001, .opens_later = true});
    recording.add(stream);
    c.load();
    c.start();
    c.run(cca::for_beats<3000>{});  // before the thread begins that takes them
    recording.open();
    c.run(cca::for_beats<100>{});
    recording.close();
    CHECK(recording.lost_beats() > 1000);
  }
  const auto beats = twin_of<graph>({stream.writer.view().begin(), stream.writer.view().end()});
  INFO(beats);
  CHECK_FALSE(beats);
  CHECK(beats.difference.empty());
  CHECK((beats.ended_early.starts_with("the robot's door lost ") ||
         beats.ended_early.starts_with("what `leg.angles` sensed in beat 1024 is missing")));
}

TEST_CASE("parameters take effect in the twin in the same beat") {
  const auto result =
      twin_of<graph>(stream_of_run<graph>([](const std::string& topic, std::int64_t beat, bytes&) {
        return topic != "/cca/parameters/filter" || beat == 0;
      }));
  CHECK(result.component == "filter");
  CHECK(result.beat == 1000);
}

TEST_CASE("a twin of another architecture refuses the stream") {
  const bytes stream = stream_of_run<graph>();
  CHECK_THROWS_WITH_AS(twin_of<other_graph>(stream),
                       doctest::Contains("the robot has another architecture: robot `"), cca::refused);
}

TEST_CASE("a damaged stream is refused, differs or waits for more: nothing else") {
  const bytes stream = stream_of_run<graph>({}, [](auto& c) { c.run(cca::for_beats<60>{}); });
  std::uint64_t seed = 88172645463325252u;
  int refused = 0, differs = 0;
  for (int n = 0; n < 400; ++n) {
    bytes other = stream;
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    other[seed % other.size()] ^= static_cast<unsigned char>(1 + (seed >> 40) % 255);
    try {
      const auto result = twin_of<graph>(other);
      differs += !result.difference.empty();
      CHECK(result.beats <= 60);
    } catch (const cca::refused&) { ++refused; }
  }
  CHECK(refused > 20);
  CHECK(differs > 20);
}
