// The laws of a CanBus, stated once and run over every model.
//
// A rig is a model for these laws, made anew for each law. It has
//   end(i)          at least two ends of one bus
//   settle()        after it, all that was sent has arrived
//   has_fd          whether the bus takes FD frames
// and, if the model can do that,
//   away(i), back(i)           takes an end from the bus (link down or bus-off), and returns it
//   blocked(i), unblocked(i)   in between, nobody acknowledges what end i sends
//   asks_for_bytes             false: its remote frames have length 0 only
//   rounds                     fewer, for a slow model
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <doctest/doctest.h>

#include <cca/hardware/can_bus.hpp>

#include "law.hpp"

namespace laws {

namespace can {

using namespace cca::hardware;
using cca::hardware::can_frame;  // not the one of linux/can.h

struct frame_source {
  std::mt19937_64 bits;
  bool remote_bytes = true;  // remote frames may ask for bytes
  std::uint64_t below(std::uint64_t n) { return bits() % n; }

  // Any frame that can be on a bus.
  can_frame frame(bool with_fd) {
    can_frame f{.id = below(2) ? extended(static_cast<std::uint32_t>(below(1u << 29)))
                               : standard(static_cast<std::uint32_t>(below(1u << 11)))};
    const std::uint64_t kind = below(with_fd ? 4 : 2);
    if (kind >= 2) {
      f.fd = true, f.fast = kind == 3;
      f.length = fd_length(below(65));
    } else {
      f.length = static_cast<std::uint8_t>(below(9));
      f.remote = kind == 1 && below(4) == 0;
      if (f.remote && !remote_bytes) f.length = 0;
    }
    if (!f.remote)
      for (std::size_t i = 0; i < f.length; ++i) f.data[i] = static_cast<std::uint8_t>(below(256));
    return f;
  }
};

template <CanBus Bus>
std::vector<received_frame> all_from(Bus&& bus, std::size_t batch = 7) {
  std::vector<received_frame> all;
  std::vector<received_frame> some(batch);
  for (std::size_t n; (n = bus.receive(some)) > 0;)
    all.insert(all.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(n));
  return all;
}

// The others get the frames as they were sent, in order under each id; the sender does not.
template <class Rig>
void conveys() {
  Rig rig;
  constexpr bool asks_for_bytes = !requires { Rig::asks_for_bytes; };
  frame_source random{std::mt19937_64{1}, asks_for_bytes};
  std::int64_t last = 0;
  int rounds = 60;
  if constexpr (requires { Rig::rounds; }) rounds = Rig::rounds;
  for (int round = 0; round < rounds; ++round) {
    std::vector<can_frame> sent;
    const can_id id = random.frame(false).id;
    for (std::uint64_t n = random.below(8); n > 0; --n) {
      sent.push_back(random.frame(Rig::has_fd));
      sent.back().id = id;
    }
    const auto result = rig.end(0).send(sent);
    CHECK_MESSAGE(result.sent == sent.size(), "all frames are taken");
    CHECK_MESSAGE(result.outcome == send_outcome::sent, "the outcome says so");
    rig.settle();
    const auto got = all_from(rig.end(1));
    REQUIRE_MESSAGE(got.size() == sent.size(), "each frame arrives once");
    for (std::size_t i = 0; i < got.size(); ++i) {
      CHECK_MESSAGE(got[i].frame == sent[i], "a frame arrives as it was sent");
      CHECK_MESSAGE(got[i].time >= last, "times don't go backwards");
      last = got[i].time;
    }
    CHECK_MESSAGE(all_from(rig.end(0)).empty(), "the sender does not get its own frames");
  }
  CHECK_MESSAGE(rig.end(0).counters().confirmed == rig.end(0).counters().sent, "all frames are confirmed");
  CHECK_MESSAGE(rig.end(0).in_flight() == 0, "nothing is in flight");
  CHECK_MESSAGE(rig.end(1).counters().received == rig.end(0).counters().sent, "all frames are counted");
}

// An idle bus, an empty batch, an empty buffer.
template <class Rig>
void does_not_wait() {
  Rig rig;
  std::array<received_frame, 4> in;
  CHECK_MESSAGE(rig.end(0).receive(in) == 0, "an idle bus gives nothing");
  CHECK_MESSAGE(rig.end(0).receive(std::span<received_frame>{}) == 0, "nor into an empty buffer");
  const auto nothing = rig.end(0).send({});
  CHECK_MESSAGE((nothing.sent == 0 && nothing.outcome == send_outcome::sent), "an empty batch is no error");

  const std::array<can_frame, 3> three{
      {{.id = standard(1), .length = 1}, {.id = standard(1), .length = 2}, {.id = standard(1), .length = 3}}};
  rig.end(1).send(three);
  rig.settle();
  CHECK_MESSAGE(rig.end(0).receive(std::span<received_frame>(in.data(), 2)) == 2,
                "no more frames than there is room for");
  CHECK_MESSAGE(rig.end(0).receive(in) == 1, "the rest comes with the next call");
  CHECK_MESSAGE(in[0].frame.length == 3, "and is the last frame");
}

// Frames that can't be on the bus are left out and counted; the rest of the batch is sent.
template <class Rig>
void refuses_what_is_no_frame() {
  const std::array<can_frame, 8> wrong{{{.id = standard(0x800)},
                                        {.id = extended(1u << 29)},
                                        {.id = standard(1), .length = 9},
                                        {.id = standard(1), .length = 9, .fd = true},
                                        {.id = standard(1), .length = 65, .fd = true},
                                        {.id = standard(1), .length = 255, .fd = true},
                                        {.id = standard(1), .fd = true, .remote = true},
                                        {.id = standard(1), .fast = true}}};
  for (const auto& bad : wrong) {
    Rig rig;
    const std::array<can_frame, 3> batch{
        {{.id = standard(5), .length = 1}, bad, {.id = standard(5), .length = 2}}};
    const auto result = rig.end(0).send(batch);
    CHECK_MESSAGE((result.sent == 2 && result.outcome == send_outcome::invalid),
                  "the other frames are taken");
    CHECK_MESSAGE(rig.end(0).counters().invalid == 1, "the invalid frame is counted");
    rig.settle();
    const auto got = all_from(rig.end(1));
    REQUIRE(got.size() == 2);
    CHECK_MESSAGE((got[0].frame == batch[0] && got[1].frame == batch[2]), "the other frames arrive");
  }
  if (!Rig::has_fd) {
    Rig rig;
    CHECK_MESSAGE(rig.end(0).send(std::array{can_frame{.id = standard(1), .fd = true}}).outcome ==
                      send_outcome::invalid,
                  "no FD frames on a classic bus");
  }
}

// Away: nothing is taken, that is counted, and those frames never arrive. Back: it works as before.
template <class Rig>
void sends_nothing_stale() {
  if constexpr (requires(Rig r) { r.away(0), r.back(0); }) {
    Rig rig;
    const can_frame before{.id = standard(0x10), .length = 1}, meanwhile{.id = standard(0x11), .length = 1},
        after{.id = standard(0x12), .length = 1};
    rig.end(0).send(std::array{before});
    rig.settle();
    all_from(rig.end(1));
    rig.away(0);
    all_from(rig.end(0));
    REQUIRE_MESSAGE(is_away(rig.end(0).state()), "the state says that it is away");
    CHECK_MESSAGE(rig.end(0).counters().interruptions() == 1, "one interruption is counted");
    const auto result = rig.end(0).send(std::array{meanwhile, meanwhile});
    CHECK_MESSAGE((result.sent == 0 && result.outcome == send_outcome::away), "nothing is taken");
    CHECK_MESSAGE(rig.end(0).counters().dropped_away >= 2, "the frames are counted");
    rig.settle();
    rig.back(0);
    all_from(rig.end(0));
    CHECK_MESSAGE(!is_away(rig.end(0).state()), "the bus is back");
    CHECK_MESSAGE(rig.end(0).counters().ups + rig.end(0).counters().restarts == 1, "the return is counted");
    CHECK_MESSAGE(rig.end(0).counters().interruptions() >= 1, "the interruption stays counted");
    rig.settle();
    CHECK_MESSAGE(all_from(rig.end(1)).empty(), "no stale frame is sent");
    rig.end(0).send(std::array{after});
    rig.settle();
    const auto got = all_from(rig.end(1));
    REQUIRE_MESSAGE(got.size() == 1, "a frame that is sent now arrives");
    CHECK(got[0].frame == after);
  }
}

// If nobody acknowledges, the queue fills; the rest is dropped and counted, and never comes later.
template <class Rig>
void drops_when_full() {
  if constexpr (requires(Rig r) { r.blocked(0), r.unblocked(0); }) {
    Rig rig;
    rig.blocked(0);
    std::size_t taken = 0, tried = 0;
    send_result result{};
    for (; tried < 10000 && result.outcome == send_outcome::sent; ++tried) {
      result = rig.end(0).send(std::array{
          can_frame{.id = standard(0x20), .length = 8, .data = {static_cast<std::uint8_t>(tried)}}});
      taken += result.sent;
      all_from(rig.end(0));
    }
    REQUIRE_MESSAGE(result.outcome == send_outcome::full, "the queue gets full");
    CHECK_MESSAGE(rig.end(0).counters().dropped_full == 1, "the dropped frame is counted");
    CHECK_MESSAGE(rig.end(0).in_flight() == taken, "the frames that were taken are in flight");
    CHECK_MESSAGE(taken <= rig.most_waiting, "the bus holds no more frames than it may");
    rig.unblocked(0);
    rig.settle();
    all_from(rig.end(0));
    const auto got = all_from(rig.end(1));
    CHECK_MESSAGE(got.size() == taken, "frames that were taken arrive, dropped ones do not");
    CHECK_MESSAGE(rig.end(0).in_flight() == 0, "then none is in flight");
    CHECK_MESSAGE(rig.end(0).send(std::array{can_frame{.id = standard(0x21)}}).sent == 1,
                  "there is room again");
  }
}

template <class Rig>
void can_bus() {
  static_assert(CanBus<std::remove_cvref_t<decltype(std::declval<Rig&>().end(0))>>);
  law("conveys each frame once, in order", conveys<Rig>);
  law("does not wait", does_not_wait<Rig>);
  law("refuses what is no frame", refuses_what_is_no_frame<Rig>);
  law("sends nothing stale", sends_nothing_stale<Rig>);
  law("drops and counts when it is full", drops_when_full<Rig>);
}

}  // namespace can

using can::can_bus;

}  // namespace laws
