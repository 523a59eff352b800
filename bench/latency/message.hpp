// The architectures of the round trips: a driver publishes a message, each reflector publishes what it read.
//
// Between environments all wires are `delayed<1>`: what the driver publishes in an even beat is reflected in
// the odd one behind it and read in the next even one, so a round trip is two beats. Within one loop no wire
// needs a delay: the driver is a resource node, and a round trip is one beat.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/space/record.hpp>

#include "clock.hpp"

namespace bench {

// A block of numbers, 8 bytes each. One axis with many numbers: a type for each of 131072 axes would be more
// than a compiler takes.
template <int Words>
struct block : cca::record<Words> {};
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

// The first and the last number of a message say which one it is.
template <int Words>
auto numbered_message(double number) {
  cca::out<"y", message<Words>> y;
  y.vector()[0] = number;
  y.vector()[Words - 1] = number;
  return y;
}
bool came_back(const auto& reflected, double number) {
  return reflected.vector()[0] == number && reflected.vector()[reflected.vector().size() - 1] == number;
}

// What the driver found, for the program that runs it.
struct record {
  std::vector<double> times;  // us; as many as it has room for
  std::size_t count = 0;
  std::int64_t first = 0;  // when the first came back, ns
  std::int64_t wrong = 0;  // messages that came back changed
};

// Begins a round trip when it fires, with one reading of the clock: the end of the one before.
template <int Words, class Reflectors>
struct driver;
template <int Words, int... Reflector>
struct driver<Words, std::integer_sequence<int, Reflector...>> {
  record* found = nullptr;
  std::int64_t begun = 0;
  int core = -1;

  auto process(cca::in<name_of<Reflector>, message<Words>>... reflected, cca::beat now)
      -> cca::out<"y", message<Words>> {
    stay_on(core);
    const auto number = static_cast<double>(now.index());
    if (now.index() >= 2 && !(came_back(reflected, number - 2) && ...)) [[unlikely]]
      ++found->wrong;
    const std::int64_t time = nanoseconds();
    if (now.index() == 2) found->first = time;
    if (now.index() >= 2 && found->count < found->times.size())
      found->times[found->count++] = 1e-3 * static_cast<double>(time - begun);
    begun = time;
    return numbered_message<Words>(number);
  }
};

// Within one loop.
template <int Words, class Reflectors>
struct immediate_driver;
template <int Words, int... Reflector>
struct immediate_driver<Words, std::integer_sequence<int, Reflector...>> {
  std::int64_t wrong = 0;
  auto sense(cca::beat now) -> cca::out<"y", message<Words>> {
    return numbered_message<Words>(static_cast<double>(now.index()));
  }
  void act(cca::in<name_of<Reflector>, message<Words>>... reflected, cca::beat now) {
    if (!(came_back(reflected, static_cast<double>(now.index())) && ...)) [[unlikely]]
      ++wrong;
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

template <int Words, class Reflectors>
struct round_trips;
template <int Words, int... Reflector>
struct round_trips<Words, std::integer_sequence<int, Reflector...>>
    : cca::graph<
          cca::rate<1000>,
          cca::node<"driver", driver<Words, std::integer_sequence<int, Reflector...>>, cca::timed<2>>,
          cca::node<name_of<Reflector>, reflector<Words>>...,
          cca::wire<"driver.y", numbered("", Reflector, ".x"), cca::delayed<1>>...,
          cca::wire<numbered("", Reflector, ".y"), numbered("driver.", Reflector, ""), cca::delayed<1>>...> {
};

template <int Words, class Reflectors>
struct immediate_round_trips;
template <int Words, int... Reflector>
struct immediate_round_trips<Words, std::integer_sequence<int, Reflector...>>
    : cca::graph<cca::rate<1000>,
                 cca::node<"driver", immediate_driver<Words, std::integer_sequence<int, Reflector...>>>,
                 cca::node<name_of<Reflector>, reflector<Words>>...,
                 cca::wire<"driver.y", numbered("", Reflector, ".x")>...,
                 cca::wire<numbered("", Reflector, ".y"), numbered("driver.", Reflector, "")>...> {};

// Each in an environment of its own.
template <int Words, class Reflectors>
struct spread;
template <int Words, int... Reflector>
struct spread<Words, std::integer_sequence<int, Reflector...>>
    : cca::deployment<round_trips<Words, std::integer_sequence<int, Reflector...>>,
                      cca::environment<"driver", cca::nodes<"driver">>,
                      cca::environment<name_of<Reflector>, cca::nodes<name_of<Reflector>>>...> {};

}  // namespace bench
