// A small graph with two rates, parameters, a component that publishes seldom, and a robot that senses.
#pragma once

#include <cmath>
#include <string>

#include <cca/cca.hpp>
#include <cca/record.hpp>

#include "../../laws/temporary_file.hpp"

namespace record_test {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct slow_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<100>> {};
struct steps : cca::space<cca::number, cca::axes<cca::x>> {};

struct filter {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (cca::text<8>, name));
  };
  parameters p{0.1, "fast"};
  Eigen::Vector2d s{0, 0};
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> {
    s += p.gain * (x.vector() - s);
    return s;
  }
};
struct swing {
  auto process(cca::in<"slow", slow_angles> slow, cca::beat now) -> cca::out<"angles", leg_angles> {
    const double angle = 6e-9 * static_cast<double>(now.time());
    return Eigen::Vector2d(0.7 * std::sin(angle), 0.4 * std::cos(angle) - 0.9) + 0.1 * slow.vector();
  }
};
struct counter {
  auto process(cca::in<"x", leg_angles> x) -> std::tuple<cca::maybe<"steps", steps>, cca::fault> {
    if (x[hip{}] < -0.49 && is_ahead) ++count, is_ahead = false;
    else if (x[hip{}] > 0.49) is_ahead = true;
    else return {cca::maybe<"steps", steps>(), cca::fault()};
    return {cca::maybe<"steps", steps>(static_cast<double>(count)),
            count > most ? cca::fault("too many steps") : cca::fault()};
  }
  int count = 0;
  static constexpr int most = 3;
  bool is_ahead = false;
};
struct leg {  // with noise, which only a recording knows
  auto sense() -> cca::out<"angles", leg_angles> {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const double noise = 1e-3 * static_cast<double>(seed >> 40) / (1 << 24);
    return Eigen::Vector2d(at[0] + noise, at[1]);
  }
  void act(cca::in<"command", leg_angles> to) { at = to.vector(); }
  std::uint64_t seed = 17;
  Eigen::Vector2d at{0, -0.9};
};

template <class Filter = filter>
struct walking : cca::graph<cca::rate<1000>,
                            cca::node<"filter", Filter, cca::timed<10>>,
                            cca::node<"swing", swing, cca::timed<1>>,
                            cca::node<"counter", counter>,
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"leg", leg>,
                            cca::wire<"leg.angles", "filter.x", cca::latest>,
                            cca::wire<"filter.y", "swing.slow", cca::latest>,
                            cca::wire<"swing.angles", "limits.command">,
                            cca::wire<"leg.angles", "counter.x">,
                            cca::wire<"limits.safe", "leg.command">,
                            cca::observe<"counter.steps">>,
                 cca::recordable {};

// A recording that is removed at the end.
struct temporary_file : laws::temporary_file {
  explicit temporary_file(const std::string& what) : laws::temporary_file(what + ".mcap") {}
};

}  // namespace record_test
