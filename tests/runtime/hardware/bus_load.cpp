// How long frames are: against frames that are stuffed bit by bit, their checksums included; and the load of a bus.
#include <doctest/doctest.h>

#include <random>
#include <vector>

#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/mit.hpp>

#include "../../laws/can_bus_laws.hpp"

using namespace cca::hardware;

namespace {

using bits = std::vector<bool>;

void add(bits& to, std::uint64_t value, int count) {
  for (int i = count - 1; i >= 0; --i) to.push_back((value >> i & 1) != 0);
}

// From the start bit to the end of the payload, or of a classic frame's checksum. ISO 11898-1:2015, 10.4.
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
  while (code < 15 && (code <= 8 ? code : std::array{12, 16, 20, 24, 32, 48, 64}[static_cast<std::size_t>(code - 9)]) != f.length)
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
    if (run == 5) {  // the bit put in begins a run of its own
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

}  // namespace

TEST_CASE("bus load: known lengths") {
  CHECK(worst_case({.length = 8}).nominal == 135);
  CHECK(worst_case({.length = 0}).nominal == 55);
  CHECK(worst_case({.length = 8, .extended = true}).nominal == 160);
  CHECK(bit_rates{1'000'000}.nanoseconds({135, 0}) == 135'000);
  CHECK(bit_rates{1'000'000, 5'000'000}.nanoseconds({30, 100}) == 50'000);
}

TEST_CASE("bus load: no frame is longer than counted, and one is as long") {
  laws::can::frame_source random{std::mt19937_64{4}};
  const auto counted = [](const can_frame& f) {
    const auto worst = worst_case(shape_of(f));
    return worst.nominal + worst.data;
  };
  for (int i = 0; i < 200'000; ++i) {
    can_frame f = random.frame(true);
    if (i % 2) {  // few changes: much stuffing
      const auto pattern = static_cast<std::uint8_t>(std::array{0x00, 0xFF, 0xF0, 0x0F, 0x87, 0x1E, 0x3C, 0x78}[random.below(8)]);
      for (std::size_t k = 0; k < f.payload().size(); ++k)
        f.data[k] = random.below(16) ? pattern : static_cast<std::uint8_t>(~pattern);
    }
    REQUIRE(length_of(f) <= counted(f));
  }
  // The longest pattern: five equal bits, then four of each kind in turn, each stuffed.
  can_frame worst{.id = standard(0x07C), .length = 8};  // 0 00001111100 0 0 0 1000 ...
  std::int64_t longest = 0;
  for (std::uint32_t id = 0; id < 0x800; ++id)
    for (const int byte : {0x0F, 0x1E, 0x3C, 0x78, 0xF0, 0xE1, 0xC3, 0x87}) {
      worst.id.number = id;
      for (std::size_t k = 0; k < 8; ++k) worst.data[k] = static_cast<std::uint8_t>(byte);
      longest = std::max(longest, length_of(worst));
    }
  MESSAGE("longest classic frame of 8 bytes found: " << longest << " of 135 bits");
  CHECK(longest >= 131);  // ids, code and checksum leave no frame with all of it
}

// [plan]
struct left : can_bus_plan<"left", bit_rates{1'000'000}, cca::rate<400>,  //
                           mit_drive<ak80_9, 1>, mit_drive<ak80_9, 2>, mit_drive<ak80_9, 3>, mit_drive<ak60_6, 4>> {};

static_assert(left::load > 0.43 && left::load < 0.44);  // of the bus's time
// [plan end]

TEST_CASE("bus load: of a plan") {
  using plan = can_bus_plan<"left", bit_rates{1'000'000}, cca::rate<400>, joint<1>, joint<2>, joint<3>, joint<4>, joint<5>,
                            joint<6>, joint<7>, joint<8>>;
  CHECK(plan::cycle == 8 * 2 * 135'000);
  CHECK(plan::load == doctest::Approx(0.864));
  const std::span<const can_filter> replies = plan::replies, requests = plan::requests;
  CHECK(requests.size() == 8);
  CHECK(replies.size() == 1);  // all answer under one id
}

TEST_CASE("bus load: what is overloaded, and whose ids meet") {
  using detail::plan_check;
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<500>, joint<1>, joint<2>, joint<3>, joint<4>, joint<5>, joint<6>,
                            joint<7>, joint<8>>::sound);
  static_assert(plan_check<"b", bit_rates{1'000'000}, cca::rate<1000>, joint<1>, joint<2>, joint<3>>::sound);
  static_assert(!plan_check<"b", bit_rates{500'000}, cca::rate<1000>, joint<1>, joint<2>, joint<3>>::sound);
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<1>, joint<1>>::sound);
  static_assert(!plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<0>, joint<1>>::sound,
                "asks under the id that the others reply under");
  static_assert(plan_check<"b", bit_rates{1'000'000}, cca::rate<100>, joint<1>, mit_drive<ak80_9, 2, 9>>::sound);
}
