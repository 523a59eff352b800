// Requests that come late: whenever an environment hears of them, it ends with the same mode and parts as all
// others.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "modes_rig.hpp"

using namespace modes_test;
using cca::detail::ordered;

namespace {

using exchange = cca::detail::exchange<in_four>;
constexpr int parts = cca::detail::counts_of<in_four>.part_count;
static_assert(parts > 0 && cca::detail::has_part<in_four, 0>(0));

// What agreed_changes asks of a loop.
struct loop_of_robot {
  struct loop_state {
    struct {
      int asked = 0;
    } parts[static_cast<std::size_t>(::parts)];
    bool is_exact = false;
    int requested = -1, requested_at = 0;
    void join_request(int place, int wanted) {
      if (place > requested_at) requested = wanted, requested_at = place;
    }
  } state;
  int mode = 0, late = 0;
  std::array<int, static_cast<std::size_t>(::parts)> stopped{};

  void make_requested(std::int64_t) {
    for (std::size_t p = 0; p < stopped.size(); ++p) {
      if (state.parts[p].asked != 0) stopped[p] = state.parts[p].asked < 0;
      state.parts[p].asked = 0;
    }
    if (state.requested >= 0) mode = state.requested;
    state.requested = -1, state.requested_at = 0;
  }
  void make_ordered(ordered what, int number, std::int64_t) {
    if (what == ordered::mode) mode = number;
    else stopped[static_cast<std::size_t>(number)] = what == ordered::stop;
  }
  void count_late_order(int) { ++late; }
};

struct rig {
  std::unique_ptr<exchange> shared = std::make_unique<exchange>();
  cca::detail::agreed_changes<in_four, 0> changes;
  loop_of_robot loop;

  // A call of environment E, at this place in the order of beat `k`, asks for a mode.
  template <int E>
  void ask(std::int64_t k, int place, int mode) {
    Eigen::Matrix<double, parts + 2, 1> asked = Eigen::Matrix<double, parts + 2, 1>::Zero();
    asked[parts] = place, asked[parts + 1] = mode;
    shared->ring<cca::detail::counts_of<in_four>.output_count + E>().put(asked, 0, k);
  }
  // Asks for part 0; `place` below 0: it stops.
  template <int E>
  void ask_part(std::int64_t k, int place) {
    Eigen::Matrix<double, parts + 2, 1> asked = Eigen::Matrix<double, parts + 2, 1>::Zero();
    asked[0] = place, asked[parts + 1] = -1;
    shared->ring<cca::detail::counts_of<in_four>.output_count + E>().put(asked, 0, k);
  }
  void begin_beat(std::int64_t k) { changes.take(*shared, loop, k); }
};

}  // namespace

TEST_SUITE("deployment") {
  TEST_CASE("a request for a mode that comes after one of a later beat changes nothing") {
    rig in_time, late;
    in_time.ask<1>(5, 9, 2);
    in_time.begin_beat(6);
    CHECK_EQ(in_time.loop.mode, 2);
    in_time.ask<0>(7, 3, 1);
    in_time.begin_beat(8);
    CHECK_EQ(in_time.loop.mode, 1);

    late.ask<0>(7, 3, 1);
    late.begin_beat(8);
    late.ask<1>(5, 9, 2);
    late.begin_beat(9);
    CHECK_EQ(late.loop.mode, 1);
    late.ask<1>(9, 9, 2);  // a later one counts
    late.begin_beat(10);
    CHECK_EQ(late.loop.mode, 2);
  }

  TEST_CASE("... and of one beat the later call wins, whichever comes first") {
    for (const bool later_is_first : {false, true}) {
      rig one;
      if (later_is_first) one.ask<0>(5, 9, 1);
      else one.ask<1>(5, 3, 2);
      one.begin_beat(6);
      if (later_is_first) one.ask<1>(5, 3, 2);
      else one.ask<0>(5, 9, 1);
      one.begin_beat(8);
      CHECK_EQ(one.loop.mode, 1);
    }
  }

  TEST_CASE("... so it is with orders, which count as late") {
    rig one;
    one.ask<0>(7, 3, 1);
    one.begin_beat(8);
    cca::detail::send_order<in_four, 1>(*one.shared, ordered::mode, 2, 6, false);
    one.begin_beat(9);
    CHECK_EQ(one.loop.mode, 1);
    CHECK_EQ(one.loop.late, 1);
    cca::detail::send_order<in_four, 1>(*one.shared, ordered::mode, 2, 8,
                                        false);  // after the calls of beat 7
    one.begin_beat(9);
    CHECK_EQ(one.loop.mode, 2);
    one.changes.forget(*one.shared);  // another run
    one.ask<0>(3, 3, 1);
    one.begin_beat(4);
    CHECK_EQ(one.loop.mode, 1);
  }

  TEST_CASE("... and with parts") {
    rig one;
    one.ask_part<3>(7, -4);
    one.begin_beat(8);
    CHECK_EQ(one.loop.stopped[0], 1);
    cca::detail::send_order<in_four, 1>(*one.shared, ordered::start, 0, 5, false);
    one.begin_beat(9);
    CHECK_EQ(one.loop.stopped[0], 1);
    one.ask_part<3>(9, 4);
    one.begin_beat(10);
    CHECK_EQ(one.loop.stopped[0], 0);
  }
}
