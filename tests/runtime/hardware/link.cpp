// The link supervisor: what stops it, that it stays stopped, and what a start needs.
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <cca/hardware/link_supervisor.hpp>
#include <cca/hardware/memory_bus.hpp>

using namespace cca::hardware;

namespace {

constexpr std::int64_t ms = 1'000'000;

// A robot that sends a numbered set point each beat as long as it may, and a drive that records which ones
// came.
struct robot {
  std::vector<bus_fault> faults;
  memory_bus<2, 4> wire{{.script = faults}};
  link_supervisor<3> link{};
  std::vector<int> got{};
  int beat = 0;
  bool starts_at_once = true;

  explicit robot(std::vector<bus_fault> f) : faults(std::move(f)) {}

  void step() {
    wire.advance(++beat * ms);
    auto bus = wire.end(0);
    std::array<received_frame, 8> in;
    bus.receive(in);
    link.observe(bus.state(), bus.counters());
    if (beat == 1 && starts_at_once) REQUIRE(link.start(bus.in_flight()) == start_refusal::none);
    if (link.may_move()) {
      const auto b = static_cast<std::uint8_t>(beat);
      link.sent(bus.send(std::array{can_frame{.id = standard(1), .length = 1, .data = {b}}}));
    }
    auto drive = wire.end(1);
    for (std::size_t n = drive.receive(in), i = 0; i < n; ++i) got.push_back(in[i].frame.data[0]);
  }
  void until(int last) {
    while (beat < last) step();
  }
};

}  // namespace

TEST_CASE("link: nothing moves before a deliberate start") {
  robot r({});
  r.starts_at_once = false;
  r.until(20);
  CHECK(r.got.empty());
  CHECK(r.link.state() == link_state::stopped);
  CHECK(r.link.start(0) == start_refusal::none);
  r.until(40);
  CHECK(r.got.size() == 19);
}

TEST_CASE(
    "link: bus-off or link down, even for less than a beat, leads to `safe` at once, and it stays there") {
  for (const auto away : {bus_trouble::bus_off, bus_trouble::link_down})
    for (const std::int64_t lasts : {ms / 100, ms / 2, 10 * ms}) {
      robot r({{.what = away, .from = 20 * ms + ms / 2, .until = 20 * ms + ms / 2 + lasts, .end = 0}});
      r.until(60);
      CHECK(r.link.state() == link_state::safe);
      CHECK(r.link.first_cause() ==
            (away == bus_trouble::bus_off ? link_cause::bus_off : link_cause::link_down));
      CHECK(r.link.first_beat() == 20);  // counted from 0: the beat after it
      CHECK(r.got.size() == 20);
      CHECK(r.got.back() == 20);
    }
}

TEST_CASE("link: a start is refused while the bus is away, and while it holds frames") {
  robot r({{.what = bus_trouble::link_down, .from = 20 * ms, .until = 40 * ms, .end = 0}});
  r.until(30);
  CHECK(r.link.start(0) == start_refusal::bus_away);
  CHECK(!r.link.may_speak());
  r.until(45);
  CHECK(r.link.may_speak());
  CHECK(r.link.start(1) == start_refusal::frames_in_flight);
  CHECK(r.link.state() == link_state::safe);
  CHECK(r.link.start(0) == start_refusal::none);
  CHECK(r.link.first_cause() == link_cause::none);
  r.until(60);
  CHECK(r.got.size() == 19 + 15 - 1);
  CHECK(r.got[19] == 46);  // no set point from the time between
}

TEST_CASE("link: a full queue drops frames, and after three beats leads to `safe`") {
  robot r({{.what = bus_trouble::link_down, .from = 20 * ms, .end = 1}});  // nobody acknowledges from here on
  r.until(60);
  CHECK(r.link.state() == link_state::safe);
  CHECK(r.link.first_cause() == link_cause::queue_full);
  CHECK(r.link.dropped_batches() == 3);
  CHECK(r.wire.end(0).counters().dropped_full == 3);
}

TEST_CASE("link: a queue that is full now and then stops nothing") {
  link_supervisor<3> link;
  link.observe(bus_state::active, {});
  REQUIRE(link.start(0) == start_refusal::none);
  for (int i = 0; i < 10; ++i) {
    link.sent({.sent = 0, .outcome = send_outcome::full});
    link.sent({.sent = 0, .outcome = send_outcome::full});
    link.sent({.sent = 8, .outcome = send_outcome::sent});
  }
  CHECK(link.may_move());
  CHECK(link.dropped_batches() == 20);
}

TEST_CASE("link: another sender of our frames stops it - the first cause is kept") {
  link_supervisor<3> link;
  bus_counters c;
  link.observe(bus_state::active, c);
  REQUIRE(link.start(0) == start_refusal::none);
  c.intruders = 1;
  link.observe(bus_state::active, c);
  c.downs = 1;
  link.observe(bus_state::down, c);
  CHECK(link.state() == link_state::safe);
  CHECK(link.first_cause() == link_cause::intruder);
  CHECK(link.first_beat() == 1);
}

TEST_CASE("link: warning and passive stop nothing, and are reported") {
  link_supervisor<3> link;
  link.observe(bus_state::active, {});
  REQUIRE(link.start(0) == start_refusal::none);
  CHECK(!link.degraded());
  link.observe(bus_state::passive, {});
  CHECK(link.may_move());
  CHECK(link.degraded());
  link.stop();
  CHECK(link.state() == link_state::stopped);
}
