// The bus in memory: the laws of a bus, and the effects of a script on frames and ends.
#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <vector>

#include <cca/hardware/memory_bus.hpp>

#include "../../laws/can_bus_laws.hpp"

using namespace cca::hardware;
using laws::can::all_from;

namespace {

constexpr std::int64_t ms = 1'000'000;

// A script whose faults begin and end when a law asks for it: the clock is then moved there.
struct script {
  std::array<bus_fault, 1> faults;
};

template <bus_trouble Away>
struct rig {
  static constexpr bool has_fd = true;
  static constexpr std::size_t most_waiting = 16;
  static constexpr std::int64_t trouble_from = 100'000 * ms, trouble_until = 200'000 * ms,
                                silent_from = 300'000 * ms, silent_until = 300'100 * ms;
  static constexpr std::array<bus_fault, 2> faults{
      {{.what = Away, .from = trouble_from, .until = trouble_until, .end = 0},
       {.what = bus_trouble::link_down, .from = silent_from, .until = silent_until, .end = 1}}};
  memory_bus<2> wire{{.script = faults}};

  auto end(std::size_t i) { return wire.end(i); }
  void settle() { wire.advance(wire.time() + 100 * ms); }
  void away(std::size_t) { wire.advance(trouble_from); }
  void back(std::size_t) { wire.advance(trouble_until); }
  void blocked(std::size_t) { wire.advance(silent_from); }
  void unblocked(std::size_t) { wire.advance(silent_until); }
};

can_frame numbered(std::uint32_t id, std::uint8_t number) {
  return {.id = standard(id), .length = 2, .data = {number, 0x5A}};
}

struct outcome {
  std::vector<received_frame> got;
  bus_counters sender, receiver;
};

// A frame each millisecond for 200 ms, from end 0 to end 1.
outcome with(std::vector<bus_fault> faults, std::uint64_t seed = 1) {
  memory_bus<2> wire({.seed = seed, .script = faults});
  outcome o;
  auto from = wire.end(0), to = wire.end(1);
  for (std::uint8_t k = 0; k < 200; ++k) {
    from.send(std::array{numbered(0x100, k)});
    wire.advance((k + 1) * ms);
    for (const auto& f : all_from(to)) o.got.push_back(f);
  }
  o.sender = from.counters();
  o.receiver = to.counters();
  return o;
}

}  // namespace

TEST_CASE("memory bus: the laws of a bus, with a link that goes down") {
  laws::can_bus<rig<bus_trouble::link_down>>();
}
TEST_CASE("memory bus: the laws of a bus, with bus-off") { laws::can_bus<rig<bus_trouble::bus_off>>(); }

TEST_CASE("memory bus: without a script all frames arrive, each after the longest time of such a frame") {
  const auto o = with({});
  REQUIRE(o.got.size() == 200);
  for (std::size_t i = 0; i < 200; ++i) {
    CHECK(o.got[i].frame.data[0] == i);
    CHECK(o.got[i].time ==
          static_cast<std::int64_t>(i) * ms + bit_rates{}.nanoseconds(worst_case({.length = 2})));
  }
}

TEST_CASE("memory bus: frames are lost, by chance and by id") {
  const auto o = with({{.what = bus_trouble::lose, .from = 50 * ms, .until = 150 * ms, .chance = 0.5}});
  CHECK(o.got.size() > 120);
  CHECK(o.got.size() < 180);
  CHECK(o.sender.confirmed == 200);  // the sender can't know
  CHECK(with({{.what = bus_trouble::lose, .frames = can_filter{standard(0x101)}}}).got.size() == 200);
  CHECK(with({{.what = bus_trouble::lose, .frames = can_filter{standard(0x100)}}}).got.empty());
  CHECK(with({{.what = bus_trouble::lose, .end = 0}}).got.size() == 200);
}

TEST_CASE("memory bus: frames are late") {
  const auto o = with({{.what = bus_trouble::delay, .from = 10 * ms, .until = 20 * ms, .delay = 30 * ms}});
  REQUIRE(o.got.size() == 200);
  std::size_t late = 0;
  for (const auto& f : o.got) late += f.time - f.frame.data[0] * ms > 30 * ms;
  CHECK(late == 10);
}

TEST_CASE("memory bus: frames come twice") {
  const auto o = with({{.what = bus_trouble::duplicate, .from = 0, .until = 100 * ms}});
  REQUIRE(o.got.size() == 300);
  CHECK(o.got[0].frame == o.got[1].frame);
  CHECK(o.sender.sent == 200);
}

TEST_CASE("memory bus: a frame is overtaken by the next one") {
  const auto o = with({{.what = bus_trouble::reorder, .from = 5 * ms, .until = 6 * ms, .delay = 10 * ms}});
  REQUIRE(o.got.size() == 200);
  CHECK(o.got[5].frame.data[0] == 6);
  CHECK(o.got[6].frame.data[0] == 5);
  CHECK(o.got[7].frame.data[0] == 7);
  const auto alone = with({{.what = bus_trouble::reorder, .from = 199 * ms, .delay = ms / 2}});
  CHECK(alone.got.size() == 200);  // without a next one it comes too
}

TEST_CASE("memory bus: frames are damaged, and some of them cut short") {
  const auto o = with({{.what = bus_trouble::corrupt}});
  REQUIRE(o.got.size() == 200);
  std::size_t equal = 0, shortened = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    equal += o.got[i].frame == numbered(0x100, static_cast<std::uint8_t>(i));
    shortened += o.got[i].frame.length < 2;
    CHECK(o.got[i].frame.valid());
  }
  CHECK(equal < 20);  // a bit flipped twice
  CHECK(shortened > 20);
  CHECK(shortened < 80);
}

TEST_CASE(
    "memory bus: a seed gives always the same result, another seed another - a copy goes on like the "
    "original") {
  const std::vector<bus_fault> faults{{.what = bus_trouble::lose, .chance = 0.3},
                                      {.what = bus_trouble::corrupt, .chance = 0.3}};
  const auto a = with(faults, 3), b = with(faults, 3), c = with(faults, 4);
  const auto same = [](const outcome& p, const outcome& q) {
    if (p.got.size() != q.got.size()) return false;
    for (std::size_t i = 0; i < p.got.size(); ++i)
      if (!(p.got[i].frame == q.got[i].frame) || p.got[i].time != q.got[i].time) return false;
    return true;
  };
  CHECK(same(a, b));
  CHECK(!same(a, c));

  memory_bus<2> wire({.seed = 5, .script = faults});
  for (std::uint8_t k = 0; k < 10; ++k) wire.end(0).send(std::array{numbered(1, k)});
  wire.advance(ms / 2);
  memory_bus<2> copy = wire;
  wire.advance(5 * ms);
  copy.advance(5 * ms);
  CHECK(all_from(wire.end(1)).size() == all_from(copy.end(1)).size());
  CHECK(wire.end(1).counters().received == copy.end(1).counters().received);
}

TEST_CASE("memory bus: the lowest id goes first, an 11-bit id before a 29-bit one with the same first bits") {
  memory_bus<3> wire;
  wire.end(0).send(std::array{numbered(0x300, 0)});  // wins the bus: nobody else is there yet
  wire.advance(1);
  wire.end(0).send(std::array{can_frame{.id = extended(0x123u << 18)}});
  wire.end(1).send(std::array{numbered(0x123, 1)});
  wire.end(1).send(std::array{numbered(0x001, 2)});  // waits after the first frame of this end
  wire.advance(10 * ms);
  const auto got = all_from(wire.end(2));
  REQUIRE(got.size() == 4);
  CHECK(got[0].frame.id == standard(0x300));
  CHECK(got[1].frame.id == standard(0x123));
  CHECK(got[2].frame.id == standard(0x001));
  CHECK(got[3].frame.id == extended(0x123u << 18));
}

TEST_CASE(
    "memory bus: an end alone on the wire gets passive, not bus-off, its queue fills, and later it "
    "recovers") {
  const std::vector<bus_fault> faults{{.what = bus_trouble::link_down, .until = 50 * ms, .end = 1}};
  memory_bus<2, 4> wire({.script = faults});
  auto robot = wire.end(0);
  for (std::uint8_t k = 0; k < 10; ++k) robot.send(std::array{numbered(1, k)});
  CHECK(robot.counters().dropped_full == 6);
  wire.advance(49 * ms);
  CHECK(robot.state() == bus_state::passive);
  CHECK(robot.counters().not_acknowledged > 100);
  CHECK(robot.counters().confirmed == 0);
  wire.advance(60 * ms);
  CHECK(robot.counters().confirmed == 4);
  CHECK(robot.state() == bus_state::warning);
}

TEST_CASE(
    "memory bus: one-shot gives up frames that lose the arbitration or are not acknowledged, but not those "
    "that wait for a free bus") {
  memory_bus<3> wire({.one_shot = true});
  wire.end(0).send(std::array{numbered(0x300, 0)});
  wire.advance(1);
  wire.end(0).send(
      std::array{numbered(0x200, 1), numbered(0x200, 2)});  // the first one loses; the second one is alone
  wire.end(1).send(std::array{numbered(0x100, 3)});
  wire.advance(10 * ms);
  const auto got = all_from(wire.end(2));
  REQUIRE(got.size() == 3);
  CHECK(got[0].frame.id == standard(0x300));
  CHECK(got[1].frame.id == standard(0x100));
  CHECK(got[2].frame == numbered(0x200, 2));
  CHECK(wire.end(0).counters().arbitration_lost == 1);
  CHECK(wire.end(0).counters().dropped_away == 1);
  CHECK(wire.end(0).in_flight() == 0);

  const std::vector<bus_fault> faults{{.what = bus_trouble::link_down, .until = 50 * ms, .end = 1}};
  memory_bus<2> alone({.one_shot = true, .script = faults});
  alone.end(0).send(std::array{numbered(1, 0), numbered(1, 1)});
  alone.advance(49 * ms);
  CHECK(alone.end(0).counters().dropped_away == 2);
  CHECK(alone.end(0).in_flight() == 0);
}

TEST_CASE("memory bus: a bus that goes off or down loses the frames in its queue") {
  for (const auto away : {bus_trouble::bus_off, bus_trouble::link_down}) {
    const std::vector<bus_fault> faults{{.what = away, .from = ms / 4, .until = 20 * ms, .end = 0}};
    memory_bus<2> wire({.script = faults});
    for (std::uint8_t k = 0; k < 10; ++k) wire.end(0).send(std::array{numbered(1, k)});
    wire.advance(100 * ms);
    CHECK(all_from(wire.end(1)).size() < 4);
    CHECK(wire.end(0).counters().confirmed + wire.end(0).counters().dropped_away == 10);
    CHECK(wire.end(0).in_flight() == 0);
  }
}

TEST_CASE("memory bus: frames pass in the states warning and passive") {
  for (const auto state : {bus_trouble::warning, bus_trouble::passive}) {
    const std::vector<bus_fault> faults{{.what = state, .until = 20 * ms, .end = 0}};
    memory_bus<2> wire({.script = faults});
    CHECK(wire.end(0).state() == (state == bus_trouble::warning ? bus_state::warning : bus_state::passive));
    wire.end(0).send(std::array{numbered(1, 1)});
    wire.advance(10 * ms);
    CHECK(all_from(wire.end(1)).size() == 1);
    wire.advance(30 * ms);
    CHECK(wire.end(0).state() == bus_state::active);
  }
}

TEST_CASE("memory bus: frames that nobody fetches are lost and counted") {
  memory_bus<2, 16, 8> wire;
  for (std::uint8_t k = 0; k < 12; ++k) {
    wire.end(0).send(std::array{numbered(1, k)});
    wire.advance((k + 1) * ms);
  }
  CHECK(wire.end(1).counters().lost == 4);
  const auto got = all_from(wire.end(1));
  REQUIRE(got.size() == 8);
  CHECK(got[0].frame.data[0] == 0);
}
