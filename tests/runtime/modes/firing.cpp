// Which components fire in the first beats after a switch: as their strategies say, on what they have not
// seen yet, whether a compiler knows their clocks or not.
#include <doctest/doctest.h>

#include <vector>

#include <cca/modes.hpp>

#include "../core/counting.hpp"

using namespace core_test;

namespace {

struct every_beat {
  auto process(cca::beat now) -> cca::out<"y", reading> { return static_cast<double>(now.index()); }
};
struct in_four_beats {  // its clock is known only at run time
  auto process(cca::beat now) -> cca::maybe<"y", reading> {
    if (now.index() % 4 != 1) return {};
    return static_cast<double>(now.index());
  }
};

// `log` comes at a switch.
template <class Writer, class Clock, class... More>
struct alone : cca::graph<cca::rate<1000>, cca::node<"writer", Writer, Clock>, More...> {};
template <class Writer, class Clock, class... More>
struct heard
    : cca::graph<cca::rate<1000>, cca::node<"writer", Writer, Clock>, cca::node<"log", journal>, More...> {};
template <class Writer, class Clock, class Wire, class... More>
struct comes : cca::modes<cca::mode<"alone", alone<Writer, Clock>>,
                          cca::mode<"heard", heard<Writer, Clock, Wire, More...>>> {};

using wire = cca::wire<"writer.y", "log.x", cca::latest>;
using late_wire = cca::wire<"writer.y", "log.x", cca::delayed<2>>;
struct unknown_clock : comes<in_four_beats, cca::timed<1>, wire> {};
struct observed_too : comes<in_four_beats, cca::timed<1>, wire, cca::observe<"writer.y">> {};
struct known_clock : comes<every_beat, cca::timed<4, 1>, wire> {};
struct known_and_late : comes<every_beat, cca::timed<4, 1>, late_wire> {};

// In both modes, but only in one of them fed.
struct idle_log : cca::graph<cca::rate<1000>,
                             cca::node<"writer", in_four_beats>,
                             cca::node<"log", journal, cca::inactive>,
                             wire> {};
struct fed_log : heard<in_four_beats, cca::timed<1>, wire> {};
struct was_inactive : cca::modes<cca::mode<"alone", idle_log>, cca::mode<"heard", fed_log>> {};

// The same in a part that may be stopped.
struct part
    : cca::graph<cca::node<"writer", every_beat, cca::timed<4, 1>>, cca::node<"log", journal>, late_wire> {};
struct part_alone : cca::graph<cca::node<"writer", every_beat, cca::timed<4, 1>>> {};
struct in_part
    : cca::modes<
          cca::mode<"alone", cca::graph<cca::rate<1000>, cca::node<"part", part_alone, cca::stoppable<>>>>,
          cca::mode<"heard", cca::graph<cca::rate<1000>, cca::node<"part", part, cca::stoppable<>>>>> {};
struct first_part : cca::graph<cca::node<"log", journal>,
                               cca::node<"other", every_beat, cca::timed<10>>,
                               cca::wire<"other.y", "log.x">> {};
struct writer_comes
    : cca::modes<
          cca::mode<"alone", cca::graph<cca::rate<1000>, cca::node<"part", first_part, cca::stoppable<>>>>,
          cca::mode<"heard", cca::graph<cca::rate<1000>, cca::node<"part", part, cca::stoppable<>>>>> {};

struct timeouts : cca::modes<cca::mode<"alone", alone<every_beat, cca::timed<1>>>,
                             cca::mode<"heard",
                                       cca::graph<cca::rate<1000>,
                                                  cca::node<"writer", every_beat>,
                                                  cca::node<"log", journal, cca::timeout<4>>,
                                                  wire>>> {};

constexpr std::int64_t ms = 1'000'000;

template <class Modes, cca::fixed_string Log = "log">
std::vector<seen> after_switch_in(std::int64_t beat) {
  auto c = started<Modes>();
  c.run(cca::for_some_beats{beat});
  c.template switch_to<"heard">();
  const std::size_t before = c.template get<Log>().all.size();
  c.run(cca::for_beats<4>{});
  const auto& all = c.template get<Log>().all;
  return {all.begin() + static_cast<std::ptrdiff_t>(before), all.end()};
}

}  // namespace

TEST_SUITE("modes") {
  TEST_CASE_TEMPLATE("a component whose clock is not known fires on what it has not seen, observed or not",
                     Modes, unknown_clock, observed_too, was_inactive) {
    CHECK(after_switch_in<Modes>(3) == std::vector<seen>{{3, 1, 1 * ms, true}, {5, 5, 5 * ms, true}});
    CHECK(after_switch_in<Modes>(1) == std::vector<seen>{{1, 1, 1 * ms, true}});  // nothing has come before
  }

  TEST_CASE("so does one whose clock is known where it has always been") {
    CHECK(after_switch_in<known_clock>(3) == std::vector<seen>{{3, 1, 1 * ms, true}, {5, 5, 5 * ms, true}});
    CHECK(after_switch_in<known_clock>(1) == std::vector<seen>{{1, 1, 1 * ms, true}});
    CHECK(after_switch_in<known_and_late>(4) ==
          std::vector<seen>{{4, 1, 1 * ms, true}, {7, 5, 5 * ms, true}});
    CHECK(after_switch_in<known_and_late>(2) == std::vector<seen>{{3, 1, 1 * ms, true}});
    CHECK(after_switch_in<in_part, "part.log">(4) ==
          std::vector<seen>{{4, 1, 1 * ms, true}, {7, 5, 5 * ms, true}});
  }

  TEST_CASE("what has not been published before its component came does not arrive") {
    CHECK(after_switch_in<writer_comes, "part.log">(6) == std::vector<seen>{});
    CHECK(after_switch_in<writer_comes, "part.log">(5) == std::vector<seen>{{7, 5, 5 * ms, true}});
  }

  TEST_CASE("a time-out counts from the last firing, or from beat 0") {
    auto c = started<timeouts>();
    c.run(cca::for_beats<10>{});
    c.switch_to<"heard">();
    c.run(cca::for_beats<6>{});
    const auto& all = c.get<"log">().all;
    REQUIRE_EQ(all.size(), 2);
    CHECK_EQ(all[0].beat, 10);
    CHECK_EQ(all[1].beat, 14);
  }
}
