// SocketCAN with an adapter that the test plays: bus-off, error states, a full transmit queue, an adapter
// that is unplugged.
#include <doctest/doctest.h>

#include <array>

#include <cca/hardware/link_supervisor.hpp>

#include "../../laws/can_bus_laws.hpp"
#include "slcan_adapter.hpp"

namespace cca::hardware {

using laws::can::all_from;

namespace {

can_frame numbered(std::uint32_t id, std::uint8_t n) {
  return {.id = standard(id), .length = 1, .data = {n}};
}

// Only in the guest we can count on the driver and may make an interface.
bool guest_has_slcan() { return can_rigs::in_guest() && std::system("grep -q '^slcan ' /proc/modules") == 0; }

}  // namespace

TEST_CASE("socket can on slcan: the laws of a bus, away by bus-off") {
  if (guest_has_slcan()) laws::can_bus<can_rigs::slcan>();
}

TEST_CASE("socket can on slcan: the states of the controller, with its error counters") {
  if (!guest_has_slcan()) return;
  can_rigs::slcan rig;
  const auto said = [&rig](const char* text) {
    rig.adapter.say(text);
    can_rigs::wait_ms(10);
    all_from(rig.bus);
  };
  said("sw000096");
  CHECK(rig.bus.state() == bus_state::warning);
  said("sp000128");
  CHECK(rig.bus.state() == bus_state::passive);
  CHECK(rig.bus.send(std::array{numbered(1, 1)}).sent == 1);  // it still works
  CHECK(rig.bus.counters().transmit_errors == 128);
  said("sb000255");
  CHECK(rig.bus.state() == bus_state::bus_off);
  CHECK(rig.bus.counters().errors >= 3);
}

TEST_CASE(
    "socket can on slcan: bus-off stops a moving robot, and after the restart it sends only new frames") {
  if (!guest_has_slcan()) return;
  can_rigs::slcan rig;
  link_supervisor<3> link;
  std::uint8_t beat = 0;
  const auto step = [&] {
    ++beat;
    all_from(rig.bus);
    link.observe(rig.bus.state(), rig.bus.counters());
    if (link.may_move()) link.sent(rig.bus.send(std::array{numbered(0x100, beat)}));
    can_rigs::wait_ms(2);
  };
  step();
  REQUIRE(link.start(rig.bus.in_flight()) == start_refusal::none);
  for (int i = 0; i < 20; ++i) step();
  rig.settle();
  CHECK(all_from(rig.adapter).size() == 20);
  rig.away(0);
  for (int i = 0; i < 10; ++i) step();
  CHECK(link.state() == link_state::safe);
  CHECK(link.first_cause() == link_cause::bus_off);
  CHECK(link.start(rig.bus.in_flight()) == start_refusal::bus_away);
  rig.back(0);
  for (int i = 0; i < 10; ++i) step();
  CHECK(link.state() == link_state::safe);  // the bus is back, but that is not enough
  rig.settle();
  CHECK(all_from(rig.adapter).empty());
  CHECK(rig.bus.stale() == 0);
  REQUIRE(link.start(rig.bus.in_flight()) == start_refusal::none);
  const std::uint8_t first = static_cast<std::uint8_t>(beat + 1);
  step();
  rig.settle();
  const auto got = all_from(rig.adapter);
  REQUIRE(got.size() == 1);
  CHECK(got[0].frame.data[0] == first);
}

TEST_CASE("socket can on slcan: a full queue drops and counts the rest, and leads to the state `safe`") {
  if (!guest_has_slcan()) return;
  can_rigs::slcan rig;
  rig.adapter.listen(false);  // the line fills, then the interface's queue
  link_supervisor<3> link;
  all_from(rig.bus);
  link.observe(rig.bus.state(), rig.bus.counters());
  REQUIRE(link.start(0) == start_refusal::none);
  std::uint64_t tried = 0;
  for (int beat = 0; beat < 5000 && link.may_move(); ++beat) {
    all_from(rig.bus);
    link.observe(rig.bus.state(), rig.bus.counters());
    std::array<can_frame, 8> batch;
    for (auto& f : batch) f = {.id = standard(1), .length = 8};
    link.sent(rig.bus.send(batch));
    tried += batch.size();
  }
  CHECK(link.state() == link_state::safe);
  CHECK(link.first_cause() == link_cause::queue_full);
  CHECK(rig.bus.state() == bus_state::active);
  const auto& c = rig.bus.counters();
  CHECK(c.dropped_full > 0);
  CHECK(c.sent + c.dropped_full == tried);
  rig.adapter.listen(true);
  std::size_t arrived = 0;
  for (int i = 0; i < 20; ++i) {
    rig.settle();
    arrived += all_from(rig.adapter, 64).size();
  }
  CHECK(arrived == c.sent);
}

}  // namespace cca::hardware
