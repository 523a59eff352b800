// SocketCAN with a real kernel, on vcan and on two controllers. Without CAN: the kernel's frame format, and
// what can't be opened.
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <cca/hardware/drives/wire_number.hpp>

#include "../../laws/can_bus_laws.hpp"
#include "can_rigs.hpp"

namespace cca::hardware {

using laws::can::all_from;

namespace {

// A socket of another program, which sends what it likes, also error frames.
class raw_socket {
public:
  explicit raw_socket(const char* name)
      : interface(name), fd(detail::open_can(interface, {}, {.fd = interface_takes_fd(name)})) {}
  bool write(const canfd_frame& k, std::size_t size) const {
    return ::send(fd.get(), &k, size, 0) == static_cast<ssize_t>(size);
  }
  bool error(std::uint32_t classes, std::array<std::uint8_t, 8> data = {}) const {
    canfd_frame k{};
    k.can_id = CAN_ERR_FLAG | classes;
    k.len = CAN_ERR_DLC;
    std::copy(data.begin(), data.end(), k.data);
    return write(k, detail::classic_size);
  }

private:
  static bool interface_takes_fd(const char* name) {
    const int s = socket(AF_INET, SOCK_DGRAM, 0);
    const bool fd = detail::can_interface(name).mtu(s) == detail::fd_size;
    close(s);
    return fd;
  }
  detail::can_interface interface;
  detail::file_descriptor fd;
};

can_frame numbered(std::uint32_t id, std::uint8_t n) {
  return {.id = standard(id), .length = 1, .data = {n}};
}

std::string refusal(const char* name, const socket_can_options& o = {}) {
  try {
    socket_can bus(name, o);
  } catch (const cca::refused& r) { return r.what(); }
  return "";
}

std::int64_t monotonic() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
}

}  // namespace

TEST_CASE("kernel frames: there and back") {
  laws::can::frame_source random{std::mt19937_64{1}};
  for (int i = 0; i < 20'000; ++i) {
    const can_frame f = random.frame(true);
    REQUIRE(f.valid());
    canfd_frame k{};
    can_frame back{};
    detail::to_kernel(f, k);
    detail::from_kernel(k, detail::kernel_size(f), back);
    CHECK(back == f);
    CHECK(!detail::is_error(k));
  }
}

TEST_CASE("kernel frames: any bytes of the kernel give a frame, and nothing past its end is read") {
  std::mt19937_64 bits(2);
  for (int i = 0; i < 20'000; ++i) {
    canfd_frame k{};
    k.can_id = static_cast<std::uint32_t>(bits());
    k.len = static_cast<std::uint8_t>(bits());
    k.flags = static_cast<std::uint8_t>(bits());
    for (const std::size_t size : {detail::classic_size, detail::fd_size}) {
      can_frame f;
      detail::from_kernel(k, size, f);
      CHECK(f.length <= (size == detail::classic_size ? 8 : 64));
      CHECK(f.id.valid());
    }
    bus_counters c;
    detail::after_error(bus_state::active, k, c);
    CHECK(c.errors == 1);
  }
}

TEST_CASE("kernel frames: filters are exact") {
  const auto passes = [](const can_filter& f, std::uint32_t id) {
    const ::can_filter k = detail::to_kernel(f);
    return (id & k.can_mask) == (k.can_id & k.can_mask);
  };
  const can_filter one{standard(0x123)};
  CHECK(passes(one, 0x123));
  CHECK(!passes(one, 0x122));
  CHECK(!passes(one, 0x123 | CAN_EFF_FLAG));
  CHECK(!passes(one, 0x12345123 | CAN_EFF_FLAG));
  CHECK(!passes(one, 0x123 | CAN_RTR_FLAG));
  CHECK(passes({extended(0x123)}, 0x123 | CAN_EFF_FLAG));
  CHECK(!passes({extended(0x123)}, 0x123));
  CHECK(passes({standard(0x100), 0x700}, 0x1FF));
}

TEST_CASE("error frames: states and counters") {
  bus_counters c;
  bus_state s = bus_state::active;
  const auto error = [&](std::uint32_t classes, std::uint8_t controller = 0, std::uint8_t tx = 0,
                         std::uint8_t rx = 0) {
    canfd_frame k{};
    k.can_id = CAN_ERR_FLAG | classes;
    k.len = CAN_ERR_DLC;
    k.data[1] = controller;
    k.data[6] = tx;
    k.data[7] = rx;
    s = detail::after_error(s, k, c);
  };
  error(CAN_ERR_CRTL | CAN_ERR_CNT, CAN_ERR_CRTL_TX_WARNING, 97, 3);
  CHECK(s == bus_state::warning);
  CHECK(c.transmit_errors == 97);
  CHECK(c.receive_errors == 3);
  error(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_PASSIVE);
  CHECK(s == bus_state::passive);
  error(CAN_ERR_ACK | CAN_ERR_PROT | CAN_ERR_LOSTARB | CAN_ERR_TX_TIMEOUT);
  CHECK((c.not_acknowledged == 1 && c.protocol_errors == 1 && c.arbitration_lost == 1 && c.timeouts == 1));
  CHECK(s == bus_state::passive);
  error(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW);
  CHECK(c.overflows == 1);
  CHECK(s == bus_state::passive);
  error(CAN_ERR_BUSOFF);
  error(CAN_ERR_BUSOFF);
  CHECK(s == bus_state::bus_off);
  CHECK(c.bus_offs == 1);
  error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING);
  CHECK(s == bus_state::bus_off);  // only a restart ends this
  error(CAN_ERR_RESTARTED);
  CHECK(s == bus_state::active);
  CHECK(c.restarts == 1);
  error(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING);
  error(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE);
  CHECK(s == bus_state::active);
  CHECK(c.errors == 10);
  canfd_frame odd{};
  odd.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
  odd.len = 4;
  CHECK(detail::after_error(bus_state::active, odd, c) == bus_state::active);
}

TEST_CASE("socket can: what can't be opened is refused, and the message says what to do") {
  CHECK(refusal("").find("no name of an interface") != std::string::npos);
  CHECK(refusal("a_name_that_is_far_too_long").find("no name of an interface") != std::string::npos);
  const int fd = socket(PF_CAN, SOCK_RAW, CAN_RAW);
  if (fd < 0) {
    CHECK(refusal("can0").find("this kernel has no CAN") != std::string::npos);
    CHECK(!can_rigs::in_guest());
    return;
  }
  close(fd);
  CHECK(refusal("nowhere9").find("there is no interface `nowhere9`; those with CAN: ") != std::string::npos);
  CHECK(refusal("lo").find("`lo` is no CAN interface") != std::string::npos);
  if (can_rigs::in_guest() && refusal("can0").empty())
    CHECK(refusal("can0", {.fd = true}).find("takes no FD frames") != std::string::npos);
}

TEST_CASE("socket can on vcan: the laws of a bus") {
  if (can_rigs::present("vcan0")) laws::can_bus<can_rigs::vcan>();
}

TEST_CASE("socket can on vcan: the laws of a bus, without confirmations and times") {
  if (can_rigs::present("vcan0")) laws::can_bus<can_rigs::frugal_vcan>();
}

TEST_CASE(
    "socket can on vcan: without confirmations intruders are still reported, and a frame's time is that of "
    "the call") {
  if (!can_rigs::present("vcan0")) return;
  const std::array replies{can_filter{standard(0x200)}}, ours{can_filter{standard(0x100)}};
  socket_can robot("vcan0", {.replies = replies, .ours = ours, .confirmations = false, .times = false}),
      drive("vcan0");
  robot.send(std::array{numbered(0x100, 8)});
  drive.send(std::array{numbered(0x100, 9), numbered(0x200, 1)});
  can_rigs::wait_ms(30);
  const std::int64_t before = monotonic();
  const auto got = all_from(robot);
  REQUIRE(got.size() == 1);
  CHECK(got[0].time >= before);
  CHECK(robot.counters().intruders == 1);
  CHECK(robot.counters().received == 1);
  CHECK(robot.in_flight() == 0);
}

TEST_CASE("socket can on vcan: only frames of the filters come in, and intruders are reported") {
  if (!can_rigs::present("vcan0")) return;
  const std::array replies{can_filter{standard(0x200)}, can_filter{extended(0x300)}};
  const std::array ours{can_filter{standard(0x100)}};
  socket_can robot("vcan0", {.replies = replies, .ours = ours}), drive("vcan0");
  const std::array sent{numbered(0x200, 1), numbered(0x201, 2), can_frame{.id = extended(0x200), .length = 1},
                        can_frame{.id = extended(0x300), .length = 1}};
  drive.send(sent);
  can_rigs::wait_ms(2);
  const auto got = all_from(robot);
  REQUIRE(got.size() == 2);
  CHECK(got[0].frame == sent[0]);
  CHECK(got[1].frame == sent[3]);
  CHECK(robot.counters().intruders == 0);
  drive.send(std::array{numbered(0x100, 9)});
  robot.send(std::array{numbered(0x100, 8)});
  can_rigs::wait_ms(2);
  CHECK(all_from(robot).empty());
  CHECK(robot.counters().intruders == 1);
  CHECK(robot.counters().confirmed == 1);
}

TEST_CASE("socket can on vcan: times of arrival, on the monotonic clock") {
  if (!can_rigs::present("vcan0")) return;
  socket_can a("vcan0"), b("vcan0");
  const std::int64_t before = monotonic();
  a.send(std::array{numbered(1, 1)});
  const std::int64_t after = monotonic();
  can_rigs::wait_ms(30);
  const auto got = all_from(b);
  REQUIRE(got.size() == 1);
  CHECK(got[0].time >= before - 1'000'000);
  CHECK(got[0].time <= after + 5'000'000);  // not the time of fetching
}

TEST_CASE("socket can on vcan: frames beyond the receive queue are lost and counted") {
  if (!can_rigs::present("vcan0")) return;
  socket_can a("vcan0", {.most_in_flight = 1'000'000}), b("vcan0");
  std::uint64_t sent = 0;
  for (int i = 0; i < 3000; ++i) sent += a.send(std::array{numbered(1, 1)}).sent;
  can_rigs::wait_ms(20);
  const auto first = all_from(b, 64).size();
  CHECK(first < sent);
  CHECK(first + b.counters().lost == sent);
  sent += a.send(std::array{numbered(1, 2)}).sent;
  can_rigs::wait_ms(5);
  const auto second = all_from(b).size();
  CHECK(first + second + b.counters().lost == sent);
  // Confirmations were lost too; the sender goes on all the same.
  all_from(a);
  CHECK(a.counters().confirmed < a.counters().sent);
}

TEST_CASE("socket can on vcan: lost confirmations don't stop the sender") {
  if (!can_rigs::present("vcan0")) return;
  socket_can a("vcan0", {.most_in_flight = 4});
  for (int i = 0; i < 3000; ++i) a.send(std::array{numbered(1, 1)});
  CHECK(a.send(std::array{numbered(1, 2)}).sent == 1);
  CHECK(a.in_flight() <= 4);
}

TEST_CASE("socket can on vcan: frames that a one-shot controller never confirms are given up and counted") {
  if (!can_rigs::present("vcan0")) return;
  const std::array<can_filter, 1> others{
      {{standard(0x700)}}};  // own frames don't come back, so they are never confirmed
  socket_can patient("vcan0", {.replies = others}),
      one_shot("vcan0", {.replies = others, .gives_up_after = 200'000'000});
  for (socket_can* bus : {&patient, &one_shot}) {
    bus->send(std::array{numbered(1, 1), numbered(1, 2)});
    all_from(*bus);
    CHECK(bus->in_flight() == 2);
  }
  can_rigs::wait_ms(250);
  all_from(patient), all_from(one_shot);
  CHECK(patient.in_flight() == 2);
  CHECK(one_shot.in_flight() == 0);
  CHECK(one_shot.counters().dropped_away == 2);
}

TEST_CASE("socket can on vcan: error frames give the state - at bus-off nothing goes out") {
  if (!can_rigs::present("vcan0")) return;
  socket_can robot("vcan0"), drive("vcan0");
  const raw_socket other("vcan0");
  REQUIRE(other.error(CAN_ERR_CRTL, {0, CAN_ERR_CRTL_TX_WARNING, 0, 0, 0, 0, 97, 0}));
  can_rigs::wait_ms(2);
  all_from(robot);
  CHECK(robot.state() == bus_state::warning);
  REQUIRE(other.error(CAN_ERR_BUSOFF));
  can_rigs::wait_ms(2);
  all_from(robot);
  CHECK(robot.state() == bus_state::bus_off);
  CHECK(robot.send(std::array{numbered(1, 1)}).outcome == send_outcome::away);
  can_rigs::wait_ms(2);
  CHECK(all_from(drive).empty());
  REQUIRE(other.error(CAN_ERR_RESTARTED));
  can_rigs::wait_ms(2);
  CHECK(all_from(robot).empty());  // the caller gets no error frames
  CHECK(robot.state() == bus_state::active);
  CHECK(robot.counters().errors == 3);
  CHECK(robot.counters().restarts == 1);
}

TEST_CASE("socket can on vcan: frames that go out after bus-off are counted as stale") {
  if (!can_rigs::present("vcan0")) return;
  socket_can robot("vcan0");
  const raw_socket other("vcan0");
  REQUIRE(other.error(CAN_ERR_BUSOFF));
  CHECK(robot.send(std::array{numbered(1, 1), numbered(1, 2)}).sent ==
        2);  // it has not yet read that the bus is off
  can_rigs::wait_ms(2);
  all_from(robot);
  CHECK(robot.state() == bus_state::bus_off);
  CHECK(robot.stale() == 2);
}

TEST_CASE("socket can on vcan: a link that is down for less than a beat is seen") {
  if (!can_rigs::present("vcan0")) return;
  socket_can bus("vcan0");
  REQUIRE(can_rigs::set_link("vcan0", false));
  REQUIRE(can_rigs::set_link("vcan0", true));
  all_from(bus);
  CHECK(bus.state() == bus_state::active);
  CHECK(bus.counters().interruptions() == 1);
  CHECK(bus.send(std::array{numbered(1, 1)}).sent == 1);
}

TEST_CASE("socket can on vcan: opened while the link is down, it is down until the link comes up") {
  if (!can_rigs::present("vcan0")) return;
  REQUIRE(can_rigs::set_link("vcan0", false));
  socket_can bus("vcan0");
  CHECK(bus.state() == bus_state::down);
  CHECK(bus.send(std::array{numbered(1, 1)}).outcome == send_outcome::away);
  REQUIRE(can_rigs::set_link("vcan0", true));
  all_from(bus);
  CHECK(bus.state() == bus_state::active);
  CHECK(bus.send(std::array{numbered(1, 1)}).sent == 1);
}

TEST_CASE("socket can on vcan: an adapter that is unplugged and plugged in again") {
  if (!can_rigs::in_guest() || !can_rigs::present("vcan0")) return;
  const auto run = [](const char* command) { return std::system(command) == 0; };
  if (!run("/bin/ip link add vcan9 type vcan")) FAIL("no vcan9");
  REQUIRE(can_rigs::set_link("vcan9", true));
  socket_can bus("vcan9");
  REQUIRE(run("/bin/ip link del vcan9"));
  all_from(bus);
  CHECK(bus.state() == bus_state::down);
  CHECK(bus.send(std::array{numbered(1, 1)}).outcome == send_outcome::away);
  REQUIRE(run("/bin/ip link add vcan9 type vcan"));
  REQUIRE(can_rigs::set_link("vcan9", true));
  all_from(bus);
  CHECK(bus.state() == bus_state::active);
  socket_can other("vcan9");
  bus.send(std::array{numbered(1, 7)});
  can_rigs::wait_ms(2);
  CHECK(all_from(other).size() == 1);
  CHECK(bus.counters().downs == 1);
  run("/bin/ip link del vcan9");
}

TEST_CASE("socket can on vcan: many frames both ways: none is lost, none comes twice") {
  if (!can_rigs::present("vcan0")) return;
  socket_can robot("vcan0", {.most_in_flight = 64}), drives("vcan0", {.most_in_flight = 64});
  std::uint32_t asked = 0, answered = 0;
  bool in_order = true;
  for (int beat = 0; beat < 1000; ++beat) {
    std::array<can_frame, 8> batch;
    for (std::size_t i = 0; i < 8; ++i) {
      batch[i] = {.id = standard(static_cast<std::uint32_t>(i + 1)), .length = 4};
      detail::put(batch[i].data, 0, asked + static_cast<std::uint32_t>(i));
    }
    asked += static_cast<std::uint32_t>(robot.send(batch).sent);
    std::array<received_frame, 16> in;
    for (int tries = 0; tries < 100 && drives.counters().received < asked; ++tries)
      for (std::size_t n = drives.receive(in), i = 0; i < n; ++i) {
        can_frame reply = in[i].frame;
        reply.id.number += 0x100;
        drives.send(std::array{reply});
      }
    for (int tries = 0; tries < 100 && robot.counters().received < asked; ++tries)
      for (std::size_t n = robot.receive(in), i = 0; i < n; ++i)
        in_order &= detail::got<std::uint32_t>(in[i].frame.payload(), 0) == answered++;
  }
  CHECK(asked == 8000);
  CHECK(answered == 8000);
  CHECK(in_order);
  CHECK(robot.counters().lost + drives.counters().lost == 0);
}

TEST_CASE("socket can on two controllers: the laws of a bus") {
  if (can_rigs::present("can0")) laws::can_bus<can_rigs::controllers>();
}

TEST_CASE("socket can on two controllers: confirmed means that it went over the bus") {
  if (!can_rigs::present("can0")) return;
  socket_can a("can0"), b("can1");
  for (std::uint8_t k = 0; k < 100; ++k) {
    a.send(std::array{numbered(1, k), numbered(2, k)});
    can_rigs::wait_ms(3);
    all_from(a);
    REQUIRE(a.counters().confirmed == a.counters().sent);
  }
  CHECK(all_from(b, 32).size() == 200);
}

}  // namespace cca::hardware
