#pragma once
// The way to a pose by the smoothest movement (minimum jerk, Flash and Hogan, J. Neuroscience 5(7), 1985),
// no faster than it is told.
//
//   in  "go"        restart_signal   begins at the hand's pose
//   in  "goal"      hand
//   in  "speed"     speed            m/s, at most
//   in  "measured"  hand
//   out "pose"      hand
//   out "twist"     hand_motion
//   out "status"    way_port         arrived, a while after the end
#include <algorithm>
#include <tuple>

#include <cca/component/parameters.hpp>
#include <cca/motor/spaces.hpp>

#include "spaces.hpp"

namespace touch {

struct path {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.001, 10>, turning),  // rad/s
                             (cca::quantity<cca::duration, 0, 10>, settling));
    parameters() : turning(0.8), settling(0.3) {}
  };
  parameters p{};

  auto process(cca::in<"go", cca::restart_signal> go,
               cca::in<"goal", hand> goal,
               cca::in<"speed", speed> fastest,
               cca::in<"measured", hand> measured,
               cca::beat now)
      -> std::tuple<cca::out<"pose", hand>, cca::out<"twist", hand_motion>, cca::out<"status", way_port>> {
    if (go.fresh() || !begun) begin(measured.vector(), goal.vector(), fastest[speed_axis{}]);
    else time += now.dt();
    const double s = std::min(time / duration, 1.0);
    const double share = s * s * s * (10 - 15 * s + 6 * s * s);
    const double rate = 30 * s * s * (1 - s) * (1 - s) / duration;
    hand::vector_type at;
    at << from.head<3>() + share * way,
        cca::rotation::product(cca::rotation::exp(Eigen::Vector3d(share * turn)),
                               Eigen::Vector4d(from.tail<4>()));
    hand_motion::vector_type twist;
    twist << rate * turn, rate * way;
    return {at, twist, cca::status_of(time > duration + p.settling ? way::arrived : way::on)};
  }

  void on_start() { begun = false; }

private:
  void begin(const hand::vector_type& here, const hand::vector_type& there, double fastest) {
    begun = true;
    time = 0;
    from = here;
    way = there.head<3>() - here.head<3>();
    turn = cca::rotation::log(cca::rotation::product(
        Eigen::Vector4d(there.tail<4>()), cca::rotation::inverse(Eigen::Vector4d(here.tail<4>()))));
    duration = std::max({0.3, 1.875 * way.norm() / fastest, 1.875 * turn.norm() / p.turning});
  }

  bool begun = false;
  double time = 0, duration = 1;
  hand::vector_type from{};
  Eigen::Vector3d way{}, turn{};
};

}  // namespace touch
