#pragma once
// Where the table touches the tool: its normal, from force and torque at the flange.
//
// The tool is a sphere of known radius and place. The line along which the contact's force acts follows from
// force and torque; where it enters the sphere is the contact, and the line from there to the centre is the
// normal, whatever the friction. Source: Bicchi, Salisbury, Brock, Contact Sensing from Force Measurements,
// Int. J. Robotics Research 12(3), 1993.
//
//   in  "load"    load          on the flange
//   in  "pose"    hand          of the flange
//   out "normal"  direction     out of the table; the last one while nothing touches, upwards at first
//   out "force"   table_force   N, along the normal; 0 while nothing touches
//   out "status"  feeling_port
//
// A load that is not finite counts as none.
#include <cmath>
#include <tuple>

#include <cca/base/math.hpp>
#include <cca/component/parameters.hpp>

#include "spaces.hpp"

namespace touch {

struct force_axis : cca::dimension<"force"> {};
struct table_force : cca::space<cca::number, cca::axes<force_axis>> {};  // N

struct feel {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 100>, least),
                             (cca::bounded<double, 0, 100>, touches),
                             (cca::quantity<cca::duration, 0, 10>, smoothing),
                             (cca::quantity<cca::duration, 0, 10>, release));
    parameters() : least(1), touches(2), smoothing(0.02), release(0.3) {}
  };
  parameters p{};

  auto process(cca::in<"load", load> sensed, cca::in<"pose", hand> pose, cca::beat now) -> std::
      tuple<cca::out<"normal", direction>, cca::out<"force", table_force>, cca::out<"status", feeling_port>> {
    const Eigen::Vector3d torque = sensed.vector().head<3>(), force = sensed.vector().tail<3>();
    const double size = force.norm();
    const bool presses = size > p.least && std::isfinite(size) && torque.allFinite();
    if (presses) follow(normal_of(torque, force, pose), now.dt());
    gone_for = presses ? 0 : gone_for + now.dt();
    if (presses && size > p.touches) state = feeling::table;
    else if (gone_for > p.release) state = feeling::nothing;
    return {normal, presses ? force.dot(normal) : 0.0, cca::status_of(state)};
  }

  void on_start() {
    normal = Eigen::Vector3d::UnitZ();
    state = feeling::nothing;
    gone_for = 0;
  }

private:
  static Eigen::Vector3d normal_of(const Eigen::Vector3d& torque,
                                   const Eigen::Vector3d& force,
                                   const cca::in<"pose", hand>& pose) {
    constexpr double r = arm::description::tool_radius;
    const Eigen::Vector3d centre =
        cca::rotation::rotate(Eigen::Vector4d(pose.vector().tail<4>()), Eigen::Vector3d(0, 0, r));
    const double square = force.squaredNorm();
    const Eigen::Vector3d on_line = cca::rotation::cross<double>(force, torque) / square,
                          off = on_line - centre;
    const double along = off.dot(force), root = along * along - square * (off.squaredNorm() - r * r);
    const double step = (-along - cca::math::sqrt(std::max(root, 0.0))) / square;
    return -(off + step * force).normalized();
  }
  void follow(const Eigen::Vector3d& felt, double dt) {
    if (!felt.allFinite()) return;
    const double share = state == feeling::nothing ? 1.0 : std::min(1.0, dt / (p.smoothing + dt));
    normal = (normal + share * (felt - normal)).normalized();
  }

  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  feeling state = feeling::nothing;
  double gone_for = 0;
};

}  // namespace touch
