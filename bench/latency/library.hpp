// The round trips by the library: within one loop, between threads, between processes over any transport.
#pragma once

#include <cstring>
#include <memory>
#include <utility>

#include "message.hpp"
#include "processes.hpp"

namespace bench {

// A round trip takes two beats, and begins in every even one. One more, because the last beat only reads.
inline cca::for_some_beats beats_for(const amount& of) {
  return {2 * static_cast<std::int64_t>(of.warm_up + of.round_trips) + 1};
}

// Runs the driver's part and takes out what it found.
template <class Deployed>
void run_driver(Deployed& d, int core, const amount& of, round_of_times& round, std::int64_t since) {
  record found;
  found.times.resize(of.warm_up + of.round_trips);
  auto& driver = d.template get<"driver">();
  driver.found = &found;
  driver.core = core;
  d.run(beats_for(of));
  round.times.assign(found.times.begin() + static_cast<long>(of.warm_up),
                     found.times.begin() + static_cast<long>(found.count));
  round.wrong = found.wrong;
  round.set_up = 1e-3 * static_cast<double>(found.first - since);
}

template <int Words, int FanOut>
using spread_over = spread<Words, std::make_integer_sequence<int, FanOut>>;

template <int Words, int FanOut>
round_of_times threads(const amount& of) {
  const std::int64_t since = nanoseconds();
  const auto d = std::make_unique<cca::deployed<spread_over<Words, FanOut>>>();
  d->load();
  d->start();
  [&]<int... Reflector>(std::integer_sequence<int, Reflector...>) {
    ((d->template get<name_of<Reflector>>().core = core_of(Reflector + 1, FanOut)), ...);
  }(std::make_integer_sequence<int, FanOut>{});
  round_of_times round;
  run_driver(*d, core_of(0, FanOut), of, round, since);
  return round;
}

template <int Words, int FanOut, class Transport>
round_of_times processes(const amount& of, const Transport& transport) {
  using deployed = cca::deployed<spread_over<Words, FanOut>>;
  const std::int64_t since = nanoseconds();
  return in_processes(
      FanOut, of.round_trips,
      [&](int reflector) {
        const int core = core_of(reflector + 1, FanOut);
        stay_on(core);  // and the transport's threads with it
        const auto name = std::string(reflector < 10 ? "r0" : "r") + std::to_string(reflector);
        const auto d = std::make_unique<deployed>(cca::only{name}, transport);
        d->load();
        d->start();
        d->run(cca::without_end{});  // until the driver has all
      },
      [&](round_of_times& round) {
        const int core = core_of(0, FanOut);
        stay_on(core);
        const auto d = std::make_unique<deployed>(cca::only{"driver"}, transport);
        d->load();
        d->start();
        run_driver(*d, core, of, round, since);
      });
}

// ---- within one loop: many round trips are timed together, because reading a clock takes longer than one
// ----

inline constexpr std::int64_t timed_together = 200;

template <class Run>
round_of_times loop_of(const amount& of, std::int64_t since, Run run) {
  round_of_times round;
  run(1);
  round.set_up = 1e-3 * static_cast<double>(nanoseconds() - since);
  for (std::size_t n = 0; n < std::min<std::size_t>(of.round_trips, 200); ++n) {
    const std::int64_t begun = nanoseconds();
    run(timed_together);
    round.times.push_back(1e-3 * static_cast<double>(nanoseconds() - begun) / timed_together);
  }
  return round;
}

template <int Words, int FanOut>
round_of_times loop(const amount& of) {
  const std::int64_t since = nanoseconds();
  const auto c = std::make_unique<
      cca::controller<immediate_round_trips<Words, std::make_integer_sequence<int, FanOut>>>>();
  c->load();
  c->start();
  auto round = loop_of(of, since, [&](std::int64_t times) { c->run(cca::for_some_beats{times}); });
  round.wrong = c->template get<"driver">().wrong;
  return round;
}

// The same by hand: a message, a copy of it by each reflector, and a look at each copy.
template <int Words, int FanOut>
class loop_by_hand {
public:
  [[gnu::noinline]] void round_trip() {
    const auto number = static_cast<double>(n++);
    message[0] = number;
    message[Words - 1] = number;
    for (auto& back : reflected) std::memcpy(back, message, sizeof back);
    for (const auto& back : reflected)
      if (back[0] != number || back[Words - 1] != number) ++wrong;
  }
  std::int64_t wrong = 0, n = 0;

private:
  double message[Words]{};
  double reflected[FanOut][Words]{};
};
template <int Words, int FanOut>
round_of_times raw_loop(const amount& of) {
  const std::int64_t since = nanoseconds();
  const auto by_hand = std::make_unique<loop_by_hand<Words, FanOut>>();
  auto round = loop_of(of, since, [&](std::int64_t times) {
    for (std::int64_t n = 0; n < times; ++n) by_hand->round_trip();
  });
  round.wrong = by_hand->wrong;
  return round;
}

}  // namespace bench
