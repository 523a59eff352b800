// The laws of a VirtualDrive, stated once and run over every model: the codec is at one end of a bus in
// memory, the virtual drive and a motor at the other.
//
// A rig is a model for these laws. It has `drive`, the VirtualDrive; `code` and `fault`, one of its faults
// and what it reports for it; `unfed`, what it reports when its watchdog has run out; `no_number()`, set
// points with NaN or infinity (none, if its frames can't have these). `wraps`, in rad, if the position that
// it reports begins again at the end of a range: the width of that.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include <doctest/doctest.h>

#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/virtual_drive.hpp>

#include "law.hpp"

namespace laws {

std::size_t allocations();

namespace virtual_drives {

using namespace cca::hardware;

inline constexpr double starts_at = 0.2;  // where a motor is before anything happens

inline bool finite(const drive_command& c) {
  return (c.position + c.velocity + c.torque + c.stiffness + c.damping) * 0 == 0;
}
// Whether it damps at most.
inline bool gives_way(const drive_command& c) {
  return finite(c) && c.stiffness == 0 && c.torque == 0 && (c.damping == 0 || c.velocity == 0);
}
inline bool same(const drive_command& a, const drive_command& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <VirtualDrive V>
struct bench {
  using D = typename V::drive;

  // One millisecond: the robot sends, the drive moves, the answers come back.
  void beat(const drive_frames& frames = {}) {
    drive_frames out = frames;
    if (!frames.empty())
      for (const can_frame& f : cycle_frames_of<D>) out.add(f);
    if (!out.empty()) wire.end(0).send(out);
    wire.advance(now + 500'000);
    const std::size_t n = wire.end(1).receive(inbox);
    const std::size_t before = allocations();
    for (std::size_t i = 0; i < n; ++i) v.hear(inbox[i].frame, now + 500'000);
    law = v.law(now + 500'000);
    motor.advance(law, 0, 1e-3);
    const drive_frames told = v.answer(motor.now);
    allocated += allocations() - before;
    if (!told.empty()) wire.end(1).send(told);
    wire.advance(now += 1'000'000);
    const std::size_t m = wire.end(0).receive(inbox);
    for (std::size_t i = 0; i < m; ++i) D::decode(inbox[i].frame, report);
  }
  void beats(int n, const drive_frames& frames = {}) {
    while (n-- > 0) beat(frames);
  }
  bool enable() {
    typename D::enabling way;
    for (int i = 0; i < 600; ++i) {
      const enable_step s = way.next(report);
      if (s.progress != enable_progress::going) return s.progress == enable_progress::done;
      beat(s.frames);
    }
    return false;
  }

  // A set point for another position, in the way that the drive takes.
  static drive_frames go(double where = 0.5) {
    if constexpr ((D::uses & of_position) != 0)
      return D::set_point({.position = where, .stiffness = 20, .damping = 0.8}).frames;
    else if constexpr ((D::uses & of_velocity) != 0) return D::set_point({.velocity = where}).frames;
    else return D::set_point({.torque = 0.1 * where}).frames;
  }
  bool follows() {
    beat(go());
    return !gives_way(law) && v.enabled();
  }

  memory_bus<2> wire{{.rates = {1'000'000}}};
  V v{};
  virtual_motor motor{};
  drive_report report{};
  drive_command law{};
  std::int64_t now = 0;
  std::size_t allocated = 0;
  std::array<received_frame, 64> inbox{};
};

template <class Rig>
double whole_ranges(double way) {
  if constexpr (requires { Rig::wraps; }) return Rig::wraps * std::round(way / Rig::wraps);
  else return 0;
}

template <class Rig>
using bench_of = bench<typename Rig::drive>;

// Off until its codec has enabled it, without a jerk; then it goes where the set points lead.
template <class Rig>
void follows_once_enabled() {
  bench_of<Rig> b;
  using D = typename Rig::drive::drive;
  b.motor.now.position = starts_at;
  b.beats(200, Rig::drive::waits ? b.go() : drive_frames());
  CHECK_MESSAGE(b.motor.now.position == starts_at, "nothing moves before it is enabled");
  REQUIRE_MESSAGE(b.enable(), "its codec enables it");
  CHECK_MESSAGE(std::fabs(b.motor.now.position - starts_at) < 0.002, "enabling it makes no jerk");
  b.beats(1500, b.go());
  if constexpr ((D::uses & of_position) != 0)
    CHECK(b.motor.now.position == doctest::Approx(0.5).epsilon(0.02));
  else if constexpr ((D::uses & of_velocity) != 0)
    CHECK(b.motor.now.velocity == doctest::Approx(0.5).epsilon(0.05));
  else CHECK(b.motor.now.position > 1);
  const double turned = whole_ranges<Rig>(b.motor.now.position - b.report.position);
  CHECK_MESSAGE(b.report.position + turned == doctest::Approx(b.motor.now.position).epsilon(0.02),
                "it goes there and reports it");
  if constexpr (requires { Rig::wraps; })
    CHECK_MESSAGE(std::fabs(b.report.position) <= 0.51 * Rig::wraps, "what it reports stays in its range");
  CHECK(b.report.fault == drive_fault::none);
  b.beats(3, D::disable());
  CHECK_MESSAGE(gives_way(b.law), "disabled, it gives way");
  CHECK_FALSE(b.v.enabled());
  CHECK_MESSAGE(b.allocated == 0, "nothing is allocated");
}

// Unfed, it lets go after its timeout, not before; and stays so, or follows again when it is fed, as its type
// says.
template <class Rig>
void starves() {
  using V = typename Rig::drive;
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(50, b.go());
  const std::int64_t fed = b.now;
  while (b.now < fed + V::timeout - 2'000'000) {
    b.beat();
    REQUIRE_MESSAGE(!gives_way(b.law), "it follows until its timeout");
  }
  b.beats(3);
  CHECK_MESSAGE(gives_way(b.law), "after its timeout it gives way");
  b.motor.now.velocity = 0;
  const double stood = b.motor.now.position;
  b.beats(20);
  if (!V::latches) {
    CHECK_MESSAGE(b.follows(), "it follows again when it is fed, as its type says");
    return;
  }
  for (int i = 0; i < 200; ++i) {
    b.beat(b.go());
    REQUIRE_MESSAGE(gives_way(b.law), "a late set point moves nothing");
  }
  CHECK(b.motor.now.position == doctest::Approx(stood).epsilon(0.01));
  CHECK_FALSE(b.v.enabled());
  CHECK_MESSAGE(b.report.fault == Rig::unfed, "it reports the watchdog");
  CHECK((b.report.activity == drive_activity::faulted || b.report.activity == drive_activity::disabled));
  REQUIRE_MESSAGE(b.enable(), "it can be enabled again");
  CHECK(b.follows());
  CHECK(b.allocated == 0);
}

template <class Rig>
void fails() {
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(50, b.go());
  b.v.fail(Rig::code);
  b.beat(b.go());
  CHECK_MESSAGE(gives_way(b.law), "a fault takes the torque away at once");
  for (int i = 0; i < 150; ++i) {
    b.beat(b.go());
    REQUIRE(gives_way(b.law));
  }
  CHECK_MESSAGE(b.report.fault == Rig::fault, "the fault is reported");
  CHECK(b.report.activity == drive_activity::faulted);
  CHECK_FALSE(b.v.enabled());
  b.v.clear();
  if (Rig::drive::latches) {
    b.beats(50, b.go());
    CHECK_MESSAGE(gives_way(b.law), "the end of a fault moves nothing");
  }
  REQUIRE_MESSAGE(b.enable(), "it can be enabled again");
  CHECK(b.follows());
}

template <class Rig>
void falls_silent() {
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(50, b.go());
  b.v.go_silent(true);
  const std::uint64_t heard = b.report.frames;
  b.beats(300, b.go());
  CHECK_MESSAGE(b.report.frames == heard, "a silent drive sends nothing");
  CHECK_MESSAGE(!gives_way(b.law), "a silent drive works on");
  b.v.clear();
  b.beats(150, b.go());
  CHECK(b.report.frames > heard);
}

template <class Rig>
void reboots() {
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(50, b.go());
  b.v.reboot(b.now, 50'000'000);
  b.motor.now.velocity = 0;
  const double stood = b.motor.now.position;
  const std::uint64_t heard = b.report.frames;
  for (int i = 0; i < 300; ++i) {
    b.beat(Rig::drive::waits || i < 45 ? b.go() : drive_frames());
    REQUIRE_MESSAGE(gives_way(b.law), "nothing moves until it is enabled, whatever comes");
    if (i == 49) CHECK_MESSAGE(b.report.frames == heard, "while it boots it sends nothing");
  }
  CHECK(b.motor.now.position == stood);
  CHECK_FALSE(b.v.enabled());
  if (Rig::drive::waits)
    CHECK_MESSAGE(b.report.activity != drive_activity::enabled, "it does not report itself enabled");
  REQUIRE(b.enable());
  CHECK_MESSAGE(std::fabs(b.motor.now.position - stood) < 0.002, "enabling it makes no jerk");
  CHECK(b.follows());
}

// Bytes that make no sense: off, it stays off, unless they are a frame that its codec enables it with;
// enabled, it follows the last set point.
template <class Rig>
void hears_anything() {
  using V = typename Rig::drive;
  using D = typename V::drive;
  std::mt19937_64 bits(3);
  const auto noise = [&] {
    const auto& mine = D::requests[bits() % D::requests.size()];
    can_frame f{.id = mine.id, .fd = bits() % 2 == 0, .remote = bits() % 16 == 0};
    // Where a part of a command is in its id.
    f.id.number |=
        static_cast<std::uint32_t>(bits()) & ~mine.mask & (mine.id.extended ? 0x1FFFFFFFu : 0x7FFu);
    f.length = f.fd ? fd_length(bits() % 65) : static_cast<std::uint8_t>(bits() % 9);
    for (auto& byte : f.data) byte = static_cast<std::uint8_t>(bits());
    return f;
  };
  drive_frames enabling;  // one byte may be enough to enable a drive, and noise hits it
  typename D::enabling way;
  for (int i = 0; i < 2; ++i)
    for (const can_frame& f : way.next({}).frames)
      if (enabling.size() < 8) enabling.add(f);
  V v;
  for (std::int64_t i = 0; i < 100'000; ++i) {
    const can_frame f = noise();
    if (std::find(enabling.begin(), enabling.end(), f) == enabling.end()) v.hear(f, i * 100'000);
    REQUIRE_MESSAGE(gives_way(v.law(i * 100'000)), "random bytes move no drive that is not enabled");
    v.answer({});
  }
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(5, b.go());
  const std::int64_t now = b.now + 100'000;
  const drive_command before = b.v.law(now);
  for (const can_frame& good : b.go(-3)) {
    can_frame f = good;
    f.length = static_cast<std::uint8_t>(good.length / 2);
    b.v.hear(f, now);
    f = good, f.remote = true;
    b.v.hear(f, now);
    f = good, f.id.extended = !f.id.extended;
    b.v.hear(f, now);
    f = good, f.id.number ^= 0x20;
    b.v.hear(f, now);
  }
  for (const can_frame& f : cycle_frames_of<D>) b.v.hear(f, now);
  CHECK_MESSAGE(same(before, b.v.law(now)),
                "nor does half a set point, a remote frame, or a set point for another drive");
}

template <class Rig>
void hears_no_number() {
  using D = typename Rig::drive::drive;
  CHECK(D::set_point({.position = NAN, .velocity = NAN, .torque = NAN}).frames.empty());
  for (const can_frame& f : Rig::no_number()) {
    bench_of<Rig> b;
    b.motor.now.position = starts_at;
    REQUIRE(b.enable());
    const double stood = b.motor.now.position;
    for (int i = 0; i < 200; ++i) {
      b.beat({f});
      REQUIRE_MESSAGE(finite(b.law), "every number of the law is finite");
    }
    CHECK_MESSAGE(std::fabs(b.motor.now.position - stood) < 0.001, "NaN moves nothing");
  }
}

template <class Rig>
void is_copied_whole() {
  bench_of<Rig> b;
  REQUIRE(b.enable());
  b.beats(5, b.go());
  auto copy = b.v;
  const std::int64_t later = b.now + 1'000'000;
  for (auto* v : {&b.v, &copy})
    for (const can_frame& f : b.go(1)) v->hear(f, later);
  CHECK(same(b.v.law(later), copy.law(later)));
  const auto said = b.v.answer(b.motor.now), also = copy.answer(b.motor.now);
  REQUIRE(said.size() == also.size());
  for (std::size_t i = 0; i < said.size(); ++i) CHECK(said[i] == also[i]);
}

}  // namespace virtual_drives

template <class Rig>
void virtual_drive() {
  static_assert(cca::hardware::VirtualDrive<typename Rig::drive>);
  law("follows once it is enabled", virtual_drives::follows_once_enabled<Rig>);
  law("lets go after its timeout", virtual_drives::starves<Rig>);
  law("gives way in a fault", virtual_drives::fails<Rig>);
  law("works on while it is silent", virtual_drives::falls_silent<Rig>);
  law("reboots", virtual_drives::reboots<Rig>);
  law("ignores bytes without a meaning", virtual_drives::hears_anything<Rig>);
  law("ignores what is no number", virtual_drives::hears_no_number<Rig>);
  law("is copied whole", virtual_drives::is_copied_whole<Rig>);
}

}  // namespace laws
