// The architecture of the round trips: a driver publishes a message, each reflector publishes what it read.
//
// All wires are `delayed<1>`: what the driver publishes in beat k is reflected in beat k + 1 and read in
// beat k + 2. So a round trip is two beats, in one loop as between environments.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <cca/deployment.hpp>

#include "clock.hpp"

namespace bench {

// A block of numbers, 8 bytes each. One axis with many numbers: a type for each of 131072 axes would be more
// than a compiler takes.
template <int Words>
struct block {
  using quantity = void;
  static constexpr bool actuated = false;
  static constexpr int width(int) { return Words; }
  static constexpr double zero(int, int) { return 0; }
  template <class>
  struct methods {};
};
template <int Words>
struct message : cca::space<block<Words>, cca::axes<cca::x>> {};

// "r07", "r07.x", "driver.r07": the nodes, their ports and the driver's inputs.
template <std::size_t Before, std::size_t Behind>
consteval auto numbered(const char (&before)[Before], int number, const char (&behind)[Behind]) {
  char text[Before + 2 + Behind]{};
  char* to = text;
  for (std::size_t i = 0; i + 1 < Before; ++i) *to++ = before[i];
  *to++ = 'r';
  *to++ = static_cast<char>('0' + number / 10);
  *to++ = static_cast<char>('0' + number % 10);
  for (std::size_t i = 0; i < Behind; ++i) *to++ = behind[i];
  return cca::fixed_string<Before + 2 + Behind>(text);
}
template <int Reflector>
inline constexpr auto name_of = numbered("", Reflector, "");

// What the driver found, for the program that runs it.
struct record {
  std::vector<double> times;  // us; as many as it has room for
  std::size_t count = 0;
  std::int64_t first = 0;  // when the first came back, ns
  std::int64_t wrong = 0;  // messages that came back changed
};

// Begins a round trip in every even beat, with one reading of the clock: the end of the one before. `Timed`:
// false if the whole run is timed from outside, because a reading takes longer than a round trip.
template <int Words, bool Timed, class Reflectors>
struct driver;
template <int Words, bool Timed, int... Reflector>
struct driver<Words, Timed, std::integer_sequence<int, Reflector...>> {
  record* found = nullptr;
  std::int64_t begun = 0;
  int core = -1;

  auto process(cca::in<name_of<Reflector>, message<Words>>... reflected, cca::beat now)
      -> cca::out<"y", message<Words>> {
    stay_on(core);
    const auto number = static_cast<double>(now.index());
    if (now.index() >= 2) {
      const double expected = number - 2;
      const bool is_right =
          ((reflected.vector()[0] == expected && reflected.vector()[Words - 1] == expected) && ...);
      if (!is_right) [[unlikely]]
        ++found->wrong;
    }
    if (Timed && now.index() % 2 == 0) {
      const std::int64_t time = nanoseconds();
      if (now.index() == 2) found->first = time;
      if (now.index() >= 2 && found->count < found->times.size())
        found->times[found->count++] = 1e-3 * static_cast<double>(time - begun);
      begun = time;
    }
    cca::out<"y", message<Words>> y;
    y.vector()[0] = number;
    y.vector()[Words - 1] = number;
    return y;
  }
};

template <int Words>
struct reflector {
  int core = -1;
  auto process(cca::in<"x", message<Words>> x) -> cca::out<"y", message<Words>> {
    stay_on(core);
    return x.vector();
  }
};

template <int Words, bool Timed, class Reflectors>
struct round_trips;
template <int Words, bool Timed, int... Reflector>
struct round_trips<Words, Timed, std::integer_sequence<int, Reflector...>>
    : cca::graph<
          cca::rate<1000>,
          cca::node<"driver", driver<Words, Timed, std::integer_sequence<int, Reflector...>>, cca::timed<1>>,
          cca::node<name_of<Reflector>, reflector<Words>, cca::timed<1>>...,
          cca::wire<"driver.y", numbered("", Reflector, ".x"), cca::delayed<1>>...,
          cca::wire<numbered("", Reflector, ".y"), numbered("driver.", Reflector, ""), cca::delayed<1>>...> {
};

// Each in an environment of its own.
template <int Words, class Reflectors>
struct spread;
template <int Words, int... Reflector>
struct spread<Words, std::integer_sequence<int, Reflector...>>
    : cca::deployment<round_trips<Words, true, std::integer_sequence<int, Reflector...>>,
                      cca::environment<"driver", cca::nodes<"driver">>,
                      cca::environment<name_of<Reflector>, cca::nodes<name_of<Reflector>>>...> {};

}  // namespace bench
