// The laws of a Drive, stated once and run over every model.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>

#include <doctest/doctest.h>

#include <cca/hardware/drive.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>

#include "law.hpp"

namespace laws {

namespace drives {

using namespace cca::hardware;

inline constexpr std::array<double drive_command::*, 5> numbers{
    &drive_command::position, &drive_command::velocity, &drive_command::torque, &drive_command::stiffness,
    &drive_command::damping};
inline constexpr std::array<drive_quantity, 5> quantities{of_position, of_velocity, of_torque, of_stiffness,
                                                          of_damping};

inline bool among(std::span<const can_filter> filters, can_id id) {
  return std::any_of(filters.begin(), filters.end(), [id](const can_filter& f) { return f.matches(id); });
}
inline bool same(const drive_report& a, const drive_report& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <Drive D>
void check_frames(const drive_frames& frames) {
  for (const can_frame& f : frames) {
    CHECK_MESSAGE(f.valid(), "each frame can be on a bus");
    CHECK_MESSAGE((among(D::requests, f.id) || among(broadcasts_of<D>, f.id)),
                  "each frame has an id that it listens to");
  }
}

// A finite command is sent; a command with NaN or infinity is not sent at all.
template <Drive D>
void asks() {
  std::mt19937_64 bits(1);
  const auto random = [&](double size) { return size * (static_cast<double>(bits() >> 11) * 0x1p-52 - 1); };
  for (int i = 0; i < 2000; ++i) {
    drive_command c;
    const double size = std::pow(10, random(20));
    for (const auto number : numbers) c.*number = random(size);
    const auto asked = D::set_point(c);
    CHECK_MESSAGE(asked.finite, "finite numbers are taken, whatever their size");
    CHECK_MESSAGE(!asked.frames.empty(), "finite numbers are sent");
    CHECK_MESSAGE((asked.cut & ~D::uses) == 0, "only what it uses is cut");
    check_frames<D>(asked.frames);
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      drive_command c;
      c.*numbers[i] = bad;
      const auto asked = D::set_point(c);
      const bool used = (D::uses & quantities[i]) != 0;
      CHECK_MESSAGE(asked.finite == !used, "NaN and infinity are reported");
      CHECK_MESSAGE(asked.frames.empty() == used, "NaN and infinity are not sent");
    }
  for (std::size_t i = 0; i < numbers.size(); ++i)  // beyond all ranges, or far beyond: the same frame
    for (const double sign : {-1, 1}) {
      drive_command far, further;
      far.*numbers[i] = sign * 1e60;
      further.*numbers[i] = sign * 1e300;
      const auto a = D::set_point(far), b = D::set_point(further);
      const bool used = (D::uses & quantities[i]) != 0;
      CHECK_MESSAGE(((a.cut & quantities[i]) != 0) == used, "it says which number it cut");
      REQUIRE(a.frames.size() == b.frames.size());
      for (std::size_t f = 0; f < a.frames.size(); ++f)
        CHECK_MESSAGE(a.frames[f] == b.frames[f], "numbers are cut to the end of the range");
    }
  CHECK_MESSAGE(D::set_point({}).cut == 0, "zero is within all ranges");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const drive_command one{.position = 0.3, .velocity = 0.2, .torque = 0.1, .stiffness = 5, .damping = 0.02};
    drive_command other = one;
    other.*numbers[i] *= 1.5;
    const auto a = D::set_point(one), b = D::set_point(other);
    bool same_frames = a.frames.size() == b.frames.size();
    for (std::size_t f = 0; same_frames && f < a.frames.size(); ++f) same_frames = a.frames[f] == b.frames[f];
    const bool used = (D::uses & quantities[i]) != 0;
    CHECK_MESSAGE(same_frames != used, "each number that it uses is sent, and no other");
  }
}

// For any bytes: a frame of others changes nothing; a frame that it takes gives numbers or NaN, and says
// which numbers it reports. It takes some of its own, and another frame gives another position.
template <Drive D>
void hears_anything() {
  std::mt19937_64 bits(2);
  drive_report r;
  int taken = 0, positions = 0, new_positions = 0;
  for (int i = 0; i < 200'000; ++i) {
    can_frame f{.length = static_cast<std::uint8_t>(bits()),
                .fd = bits() % 4 == 0,
                .fast = bits() % 2 == 0,
                .remote = bits() % 16 == 0};
    const auto& mine = D::replies[bits() % D::replies.size()];
    f.id = bits() % 16
               ? can_id{(mine.id.number & mine.mask) | (static_cast<std::uint32_t>(bits()) & ~mine.mask &
                                                        (mine.id.extended ? 0x1FFFFFFFu : 0x7FFu)),
                        mine.id.extended}
               : can_id{static_cast<std::uint32_t>(bits()), bits() % 2 == 0};
    if (bits() % 2) f.length = static_cast<std::uint8_t>(bits() % 9);
    for (auto& byte : f.data) byte = static_cast<std::uint8_t>(bits());
    if (bits() % 2) f.data[0] = D::set_point({}).frames[0].data[0];  // a first byte that it knows
    const drive_report before = r;
    if (!D::decode(f, r)) {
      REQUIRE_MESSAGE(same(before, r), "a frame that is not taken changes nothing");
      continue;
    }
    ++taken;
    if (r.told & of_position) {
      ++positions;
      new_positions += std::memcmp(&r.position, &before.position, sizeof r.position) != 0;
    }
    REQUIRE_MESSAGE(among(D::replies, f.id), "it takes only frames of its own ids");
    REQUIRE_MESSAGE(r.frames == before.frames + 1, "the frame is counted");
    REQUIRE_MESSAGE(r.told != 0, "the frame reported something");
    if (!(r.told & of_position))
      REQUIRE_MESSAGE(std::memcmp(&r.position, &before.position, sizeof r.position) == 0,
                      "a position that is not reported stays");
  }
  CHECK_MESSAGE(taken > 0, "it takes frames of its own");
  CHECK_MESSAGE(positions > 0, "it takes positions");
  CHECK_MESSAGE(2 * new_positions > positions, "another frame reports another position");
}

// Enabling and disabling give frames that can be sent. Without an answer enabling is never done. It ends once
// the drive answers; then set points move the drive, and disabling it takes its torque away.
template <Drive D, VirtualDrive V>
void starts_and_stops() {
  CHECK(!D::disable().empty());
  check_frames<D>(D::disable());
  {
    typename D::enabling enabling;
    for (int i = 0; i < 1000; ++i) {
      const auto step = enabling.next({});
      check_frames<D>(step.frames);
      REQUIRE_MESSAGE(step.progress != enable_progress::done, "it is not done before anybody has answered");
    }
  }
  V answering;
  virtual_motor motor;
  drive_report report;
  drive_command law;
  std::int64_t now = 0;
  const auto cycle = [&](const drive_frames& frames) {
    now += 1'000'000;
    for (const can_frame& f : frames) answering.hear(f, now);
    for (const can_frame& f : cycle_frames_of<D>) answering.hear(f, now);
    law = answering.law(now);
    motor.advance(law, 0, 1e-3);
    for (const can_frame& f : answering.answer(motor.now)) D::decode(f, report);
  };
  typename D::enabling enabling;
  enable_step step;
  for (int i = 0; i < 600 && step.progress == enable_progress::going; ++i) {
    step = enabling.next(report);
    cycle(step.frames);
  }
  REQUIRE_MESSAGE(step.progress == enable_progress::done, "enabling ends once the drive answers");
  CHECK_MESSAGE(answering.enabled(), "the drive is enabled then");
  const auto follows = [&](double size) {
    cycle(D::set_point({.position = 0.3 * size,
                        .velocity = 0.2 * size,
                        .torque = 0.1 * size,
                        .stiffness = 2,
                        .damping = 0.5})
              .frames);
    return law;
  };
  const drive_command there = follows(1), back = follows(-1);
  CHECK_MESSAGE(std::memcmp(&there, &back, sizeof law) != 0, "another set point moves it elsewhere");
  for (int i = 0; i < 3; ++i) cycle(D::disable());
  CHECK_MESSAGE(!answering.enabled(), "disabling it takes its torque away");
}

// Requests and replies have different ids, so that an id alone says whether a frame is a command
// (sender_check.hpp, filters, `cca-can list`); a drive that answers under the id on which it listens can't be
// added. All traffic has possible frames.
template <Drive D>
void is_stated_soundly() {
  for (const can_filter& a : D::requests)
    for (const can_filter& b : D::replies)
      CHECK_MESSAGE(!overlap(a, b),
                    "requests and replies have different ids: a drive that answers under the id on which it "
                    "listens can't be added (docs/drives.md)");
  for (const frame_traffic& t : D::traffic) {
    CHECK(fd_length(t.shape.length) == t.shape.length);
    CHECK((t.shape.fd || t.shape.length <= 8));
    CHECK((t.a_cycle > 0 || t.period > 0));
  }
}

// `V`: the drive's other end.
template <Drive D, VirtualDrive V = virtual_of<D>>
void drive() {
  law("sends what is finite, and nothing else", asks<D>);
  law("takes its replies, and no other frame", hears_anything<D>);
  law("is enabled when it answers, and not before", starts_and_stops<D, V>);
  law("states its ids and traffic soundly", is_stated_soundly<D>);
}

}  // namespace drives

using drives::drive;

}  // namespace laws
