// The length of frames, compared with frames that are stuffed bit by bit, checksum included; and the load of
// a bus.
#include <doctest/doctest.h>

#include <random>
#include <vector>

#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/odrive.hpp>
#include <cca/hardware/sensor_board.hpp>

#include "../../laws/can_bus_laws.hpp"

using namespace cca::hardware;

namespace {

using bits = std::vector<bool>;

void add(bits& to, std::uint64_t value, int count) {
  for (int i = count - 1; i >= 0; --i) to.push_back((value >> i & 1) != 0);
}

// From the start bit to the end of the payload; of a classic frame to the end of the checksum. ISO
// 11898-1:2015, 10.4.
bits stuffable(const can_frame& f) {
  bits b;
  add(b, 0, 1);
  const auto payload = f.payload();
  if (f.id.extended) {
    add(b, f.id.number >> 18, 11);
    add(b, 3, 2);  // SRR, IDE
    add(b, f.id.number & 0x3FFFF, 18);
    if (f.fd) add(b, 0, 1), add(b, 1, 1), add(b, 0, 1);  // RRS, FDF, res
    else add(b, f.remote, 1), add(b, 0, 2);              // RTR, r1, r0
  } else {
    add(b, f.id.number, 11);
    if (f.fd) add(b, 0, 2), add(b, 1, 1), add(b, 0, 1);  // RRS, IDE, FDF, res
    else add(b, f.remote, 1), add(b, 0, 2);              // RTR, IDE, r0
  }
  if (f.fd) add(b, f.fast, 1), add(b, 0, 1);  // BRS, ESI
  int code = 0;
  while (code < 15 &&
         (code <= 8 ? code : std::array{12, 16, 20, 24, 32, 48, 64}[static_cast<std::size_t>(code - 9)]) !=
             f.length)
    ++code;
  add(b, static_cast<std::uint64_t>(code), 4);
  for (const auto byte : payload) add(b, byte, 8);
  if (!f.fd) {
    std::uint32_t crc = 0;
    for (const bool bit : b) crc = ((crc << 1) ^ ((bit != ((crc >> 14 & 1) != 0)) ? 0x4599u : 0u)) & 0x7FFF;
    add(b, crc, 15);
  }
  return b;
}

int stuff_bits(const bits& b) {
  int stuffed = 0, run = 0;
  bool last = !b[0];
  for (const bool bit : b) {
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run == 5) {  // the stuff bit begins the next run
      ++stuffed;
      last = !last;
      run = 1;
    }
  }
  return stuffed;
}

std::int64_t length_of(const can_frame& f) {
  const bits b = stuffable(f);
  const auto n = static_cast<std::int64_t>(b.size()) + stuff_bits(b);
  if (!f.fd) return n + 13;
  return n + (f.length <= 16 ? 4 + 17 + 6 : 4 + 21 + 7) + 13;
}

template <std::uint32_t Number>
using joint = mit_drive<ak80_9, Number>;

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.05, counts = 4096;
};
template <std::uint32_t Node>
using axis = odrive<Node, odrive_mode::torque>;
template <std::uint8_t Node>
using node = cia402<n1, Node, cia402_mode::torque>;
template <std::uint32_t Number, std::uint32_t Master = 0>
using damiao = mit_drive<ak60_6, Number, Master, mit_firmware::damiao>;

// Whether both can be on one bus, in either order.
template <class A, class B>
constexpr bool beside() {
  constexpr std::array<detail::drive_facts, 2> both{detail::facts_of<A>(), detail::facts_of<B>()},
      turned{detail::facts_of<B>(), detail::facts_of<A>()};
  static_assert((detail::find_same_id(both).a < 0) == (detail::find_same_id(turned).a < 0));
  return detail::find_same_id(both).a < 0;
}

}  // namespace

TEST_CASE("bus load: frames of known length") {
  CHECK(worst_case({.length = 8}).nominal == 135);
  CHECK(worst_case({.length = 0}).nominal == 55);
  CHECK(worst_case({.length = 8, .extended = true}).nominal == 160);
  CHECK(bit_rates{1'000'000}.nanoseconds({135, 0}) == 135'000);
  CHECK(bit_rates{1'000'000, 5'000'000}.nanoseconds({30, 100}) == 50'000);
}

TEST_CASE("bus load: the longest possible frame is as long as counted, and no frame is longer") {
  laws::can::frame_source random{std::mt19937_64{4}};
  const auto counted = [](const can_frame& f) {
    const auto worst = worst_case(shape_of(f));
    return worst.nominal + worst.data;
  };
  for (int i = 0; i < 200'000; ++i) {
    can_frame f = random.frame(true);
    if (i % 2) {  // few changes give many stuff bits
      const auto pattern = static_cast<std::uint8_t>(
          std::array{0x00, 0xFF, 0xF0, 0x0F, 0x87, 0x1E, 0x3C, 0x78}[random.below(8)]);
      for (std::size_t k = 0; k < f.payload().size(); ++k)
        f.data[k] = random.below(16) ? pattern : static_cast<std::uint8_t>(~pattern);
    }
    REQUIRE(length_of(f) <= counted(f));
  }
  // The pattern with most stuff bits: five equal bits, then four of each kind in turn.
  can_frame worst{.id = standard(0x07C), .length = 8};  // 0 00001111100 0 0 0 1000 ...
  std::int64_t longest = 0;
  for (std::uint32_t id = 0; id < 0x800; ++id)
    for (const int byte : {0x0F, 0x1E, 0x3C, 0x78, 0xF0, 0xE1, 0xC3, 0x87}) {
      worst.id.number = id;
      for (std::size_t k = 0; k < 8; ++k) worst.data[k] = static_cast<std::uint8_t>(byte);
      longest = std::max(longest, length_of(worst));
    }
  MESSAGE("longest classic frame of 8 bytes that was found: " << longest << " of 135 bits");
  CHECK(longest >= 131);  // id, length code and checksum rule out the full 135
}

// [plan]
struct left : can_bus_plan<"left",
                           bit_rates{1'000'000},
                           cca::rate<400>,  //
                           mit_drive<ak80_9, 1>,
                           mit_drive<ak80_9, 2>,
                           mit_drive<ak80_9, 3>,
                           mit_drive<ak60_6, 4>> {};

static_assert(left::load > 0.43 && left::load < 0.44);  // of the bus's time
// [plan end]

TEST_CASE("bus load: the load of a plan") {
  using plan = can_bus_plan<"left", bit_rates{1'000'000}, cca::rate<400>, joint<1>, joint<2>, joint<3>,
                            joint<4>, joint<5>, joint<6>, joint<7>, joint<8>>;
  CHECK(plan::cycle == 8 * 2 * 135'000);
  CHECK(plan::load == doctest::Approx(0.864));
  const std::span<const can_filter> replies = plan::replies, requests = plan::requests;
  CHECK(requests.size() == 8);
  CHECK(replies.size() == 1);  // all drives answer under one id
}

TEST_CASE("bus load: overloaded buses and shared ids are refused") {
  using detail::plan_check;
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<500>, joint<1>, joint<2>, joint<3>, joint<4>,
                            joint<5>, joint<6>, joint<7>, joint<8>>::sound);
  static_assert(plan_check<"b", bit_rates{1'000'000}, cca::rate<1000>, joint<1>, joint<2>, joint<3>>::sound);
  static_assert(!plan_check<"b", bit_rates{500'000}, cca::rate<1000>, joint<1>, joint<2>, joint<3>>::sound);
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<1>, joint<1>>::sound);
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<0>, joint<1>>::sound,
                "its requests have the id of the others' replies");
  static_assert(
      plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<1>, mit_drive<ak80_9, 2, 9>>::sound);
}

TEST_CASE("bus load: an id of a drive belongs to it alone, whether set points use it or not") {
  // ODrive: all 32 ids of a node, of 11 or of 29 bits.
  static_assert(!beside<axis<1>, joint<0x20>>() && !beside<axis<1>, joint<0x36>>() &&
                !beside<axis<1>, joint<0x3F>>());
  static_assert(beside<axis<1>, joint<0x1F>>() && beside<axis<1>, joint<0x40>>() &&
                beside<axis<1>, axis<2>>());
  static_assert(!beside<axis<1>, mit_drive<ak80_9, 1, 0x24>>(),
                "the other's answers have the id of its settings");
  static_assert(!beside<axis<2>, sensor_board<0x3B>>() && beside<axis<1>, sensor_board<0x40>>());
  static_assert(!beside<axis<0x402>, moteus<n1, 65>>() &&
                beside<axis<0x402>, moteus<n1, 1>>());  // 29 bits: 8040h to 805Fh
  static_assert(!beside<axis<4>, node<5>>(), "SYNC, 80h, asks axis 4 for its version");
  static_assert(beside<axis<1>, node<5>>());

  // CANopen: all process data, SDO, NMT and heartbeat of a node.
  constexpr auto meets_node_5 = []<std::uint32_t... Id>(std::integer_sequence<std::uint32_t, Id...>) {
    return (!beside<node<5>, mit_drive<ak80_9, 1, Id>>() && ...);
  };
  static_assert(meets_node_5(std::integer_sequence<std::uint32_t, 0, 0x80, 0x85, 0x185, 0x205, 0x285, 0x305,
                                                   0x385, 0x405, 0x485, 0x505, 0x585, 0x605, 0x705>()));
  static_assert(beside<node<5>, mit_drive<ak80_9, 1, 0x606>>() && beside<node<5>, node<6>>() &&
                beside<node<1>, node<127>>());
  static_assert(!beside<node<5>, cia402<n1, 5, cia402_mode::position>>());

  // moteus: every frame to its number, from any source. An answer to a source that is also a servo moves that
  // servo.
  static_assert(!beside<moteus<n1, 3, 0>, moteus<n1, 3, 1>>() &&
                beside<moteus<n1, 3, 0>, moteus<n1, 4, 1>>());
  static_assert(!beside<moteus<n1, 3, 0>, moteus<n1, 4, 3>>());
  static_assert(!beside<moteus<n1, 3>, joint<3>>() && beside<moteus<n1, 3>, mit_drive<ak80_9, 4, 1>>());

  // Answers under one id: the first byte tells them apart; a Damiao uses half of it.
  static_assert(beside<joint<1>, joint<2>>() && beside<joint<1>, damiao<2>>() &&
                beside<damiao<1>, damiao<2>>());
  static_assert(!beside<joint<0x15>, damiao<5>>() && beside<joint<0x15>, damiao<5, 0x100>>() &&
                beside<joint<0x16>, damiao<5>>());
  static_assert(!beside<mit_drive<ak80_9, 9, 0x41>, sensor_board<0x40>>(),
                "no byte of the board's frames names it");
}
