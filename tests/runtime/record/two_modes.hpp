// Two modes that ask for each other, and what a recording has of the switches.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <cca/modes.hpp>
#include <cca/robot/limiter.hpp>

#include "graphs.hpp"

namespace record_test {

// Asks for the other mode in beat 200.
struct gait {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, amplitude));
  };
  parameters p{0.3};
  auto process(cca::in<"x", leg_angles> x, cca::beat now)
      -> std::tuple<cca::out<"angles", leg_angles>, cca::switch_to<"stand">> {
    phase += 6 * now.dt();
    return {Eigen::Vector2d(p.amplitude * std::sin(phase), x[knee{}]), now.index() == 200};
  }
  double phase = 0;
};
struct stance {
  auto process(cca::in<"x", leg_angles> x, cca::beat now)
      -> std::tuple<cca::out<"height", steps>, cca::out<"angles", leg_angles>, cca::switch_to<"walk">> {
    sum += x[hip{}];
    return {sum, 0.9 * x.vector(), now.index() == stands_until};
  }
  double sum = 0;
  std::int64_t stands_until = 300;
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"gait", gait>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"leg.angles", "gait.x">,
                         cca::wire<"gait.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {};
struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"leg", leg>,
                          cca::node<"stance", stance>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::wire<"leg.angles", "stance.x">,
                          cca::wire<"stance.angles", "limits.command">,
                          cca::wire<"limits.safe", "leg.command">> {};

struct switched {
  std::int64_t beat;
  std::string mode;
  bool requested;
  bool operator==(const switched&) const = default;
};
struct recorded_modes {
  std::vector<switched> switches{};
  std::map<std::string, int> count{};  // of messages, by topic
};
inline recorded_modes modes_recorded_in(const std::string& file) {
  recorded_modes found;
  cca::recording::mcap_reader all(file);
  for (cca::recording::mcap_message m; all.next(m);) {
    const std::string& topic = all.channels().at(m.channel).topic;
    ++found.count[topic];
    if (topic != "/cca/mode") continue;
    cca::recording::detail::cdr_reader from(m.data);
    const auto beat = from.number<std::int64_t>();
    const std::string mode(from.text());
    found.switches.push_back({beat, mode, from.number<std::uint8_t>() == 1});
    CHECK(from.is_at_end());
  }
  return found;
}

}  // namespace record_test
