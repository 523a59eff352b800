#pragma once
// What the hand should do in this beat: where to be, how stiffly, and with what force.
//
//   in  "step"              step_port
//   in  "stop"              button_port       of the operator: while pressed, the arm is only damped
//   in  "way", "way_twist"  hand, hand_motion          of the path
//   in  "repeated", "repeated_twist"          maybe    of the repeated movement
//   in  "centre"            hand                       about which it wipes
//   in  "place", "place_velocity"             maybe    on the table
//   in  "normal", "force", "feeling"                   of the table (feel.hpp)
//   out "reference"         hand
//   out "twist"             hand_motion
//   out "stiffness"         stiffness
//   out "damping"           damping           beside that of the damping ratio
//   out "feedforward"       load
//
// While it presses, the flange looks against the normal, the stiffness along it is 0, and a PI controller
// about the measured force says how hard it pushes: `press` N, at most `most`. The rest is a spring in the
// plane.
//
// What it wants is as old as the force that it looks at, not as old as the last order: on drives a command
// that is made of old data stops the arm.
#include <algorithm>
#include <cstdint>
#include <tuple>

#include <cca/adaptive/sequencer.hpp>
#include <cca/base/math.hpp>
#include <cca/component/parameters.hpp>
#include <cca/motor/spaces.hpp>

#include "feel.hpp"
#include "plan.hpp"

namespace touch {

struct leader {
  struct parameters {
    using six = Eigen::Matrix<double, 6, 1>;
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (six, stiff),
                             (six, soft),
                             (six, guiding),
                             (six, stopping),
                             (cca::bounded<double, 0, 100>, press),
                             (cca::bounded<double, 0, 100>, most),
                             (cca::bounded<double, 0, 100>, proportional),
                             (cca::bounded<double, 0, 1000>, integral),
                             (cca::bounded<double, 0, 1000>, along_normal),
                             (cca::quantity<cca::duration, 0, 10>, aligning));
    parameters() : press(10), most(25), proportional(1), integral(20), along_normal(30), aligning(0.1) {
      stiff << 60, 60, 60, 1500, 1500, 1500;
      soft << 30, 30, 30, 200, 200, 0;
      guiding << 0.5, 0.5, 0.5, 5, 5, 5;
      stopping << 3, 3, 3, 60, 60, 60;
    }
  };
  parameters p{};

  using six = Eigen::Matrix<double, 6, 1>;

  auto process(cca::in<"step", cca::step_port> number,
               cca::in<"stop", button_port> stop,
               cca::in<"way", hand> way,
               cca::in<"way_twist", hand_motion> way_twist,
               cca::in<"repeated", hand> repeated,
               cca::in<"repeated_twist", cca::twist_of<hand, flange>> repeated_twist,
               cca::in<"centre", hand> centre,
               cca::in<"place", place_on_table> place,
               cca::in<"place_velocity", cca::velocity_of<place_on_table>> place_velocity,
               cca::in<"normal", direction> felt,
               cca::in<"force", table_force> force,
               cca::in<"feeling", feeling_port> feels,
               cca::beat now) -> std::tuple<cca::out<"reference", hand>,
                                            cca::out<"twist", hand_motion>,
                                            cca::out<"stiffness", stiffness>,
                                            cca::out<"damping", damping>,
                                            cca::out<"feedforward", load>> {
    const int step = static_cast<int>(number[cca::step_axis{}]);
    const bool on_table = presses(step);
    if (on_table)
      normal = (normal + std::min(1.0, now.dt() / p.aligning) * (felt.vector() - normal)).normalized();
    else normal = Eigen::Vector3d::UnitZ();

    hand::vector_type reference = way.vector();
    six twist = way_twist.vector(), k = p.stiff, d = six::Zero(), push = six::Zero();
    if (stop.template is<button>(button::pressed)) {
      k.setZero(), d = p.stopping, twist.setZero();
    } else if (step == plan::at<"guided"> || step == plan::at<"learn">) {
      k.setZero(), d = p.guiding, twist.setZero();
    } else if (repeats(step) && repeated.origin() != cca::never) {
      reference = repeated.vector();
      twist = repeated_twist.vector();
    } else if (on_table) {
      const Eigen::Vector4d turn = against(normal);
      const Eigen::Matrix3d axes = cca::rotation::matrix(turn);
      if (step != plan::at<"return">) {
        reference = centre.vector();
        reference.head<3>() += axes.leftCols<2>() * place.vector();
        twist << 0, 0, 0, axes.leftCols<2>() * place_velocity.vector();
      }
      reference.tail<4>() = turn;
      if (step == plan::at<"yield">) k = p.soft;
      k[5] = 0;
      d[5] = p.along_normal;
      push.tail<3>() =
          -pressure(force[force_axis{}], feels.template is<feeling>(feeling::table), now.dt()) * normal;
    }
    if (!on_table) integrated = 0;
    const std::int64_t since = force.origin() == cca::never ? now.time() : force.origin();
    return {cca::out<"reference", hand>(reference).with_origin(since),
            cca::out<"twist", hand_motion>(twist).with_origin(since),
            cca::out<"stiffness", stiffness>(k).with_origin(since),
            cca::out<"damping", damping>(d).with_origin(since),
            cca::out<"feedforward", load>(push).with_origin(since)};
  }

  void on_start() { integrated = 0, normal = Eigen::Vector3d::UnitZ(); }

private:
  // The flange's z into the table: from looking straight down by the shortest turn.
  static Eigen::Vector4d against(const Eigen::Vector3d& normal) {
    const Eigen::Vector3d axis = cca::rotation::cross<double>({0, 0, 1}, normal);
    const double sine = axis.norm();
    if (sine < 1e-9) return {1, 0, 0, 0};
    return cca::rotation::product(cca::rotation::about(axis, cca::math::atan2(sine, normal[2])),
                                  Eigen::Vector4d(1, 0, 0, 0));
  }

  // N, into the table. In the air it goes on slowly, against the damper.
  double pressure(double force, bool touches, double dt) {
    if (!touches) {
      integrated = 0;
      return 0.3 * p.press;
    }
    const double e = p.press - force, wanted = p.press + p.proportional * e + integrated;
    const double u = std::clamp(wanted, 0.0, p.most.value());
    if (u == wanted) integrated += p.integral * e * dt;
    return u;
  }

  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double integrated = 0;
};

}  // namespace touch
