// One leg in the engine: four bodies, their joints, and the torques of springs and motors between them.
//
// Joints: abduction and hip together are a universal joint (axes: forward of the trunk, across the leg).
// Knee, ankle and toe are hinges across the leg. The pantograph keeps the lower segment parallel to the upper
// one: an angular motor of one axis, both of whose stops are zero (error below 1e-9 rad; a torque between the
// segments errs by 32 mrad or explodes). Springs are explicit torques: the engine's own springs (ERP, CFM)
// would lose their energy within a second.
#pragma once

#include <array>
#include <cmath>

#include <ode/ode.h>

#include <cca/sim/interface.hpp>
#include <cca/sim/kinematics.hpp>
#include <cca/sim/motors.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/state.hpp>

namespace cca::sim {

class leg {
public:
  // Built in the plane x = forward, z = up, then tilted outward by the abduction.
  leg(dWorldID world,
      const oncilla_model& m,
      dBodyID trunk,
      vector3 hip,
      double side,
      const leg_posture& posture)
      : trunk_(trunk), side_(side) {
    const placement place{hip, side * posture.abduction};
    const double upper_angle = posture.hip, middle_angle = posture.hip - posture.knee;
    const flat_point knee = flat_point{}.along(upper_angle, m.upper_length);
    const flat_point ankle = knee.along(middle_angle, m.middle_length);
    const flat_point toe = ankle.along(upper_angle, m.lower_length);

    upper_ = segment(world, place, flat_point{}.along(upper_angle, m.upper_length / 2), upper_angle);
    give_cylinder(upper_, m.upper_mass, m.segment_radius, m.upper_length);
    middle_ = segment(world, place, knee.along(middle_angle, m.middle_length / 2), middle_angle);
    give_cylinder(middle_, m.middle_mass, m.segment_radius, m.middle_length);
    lower_ = segment(world, place, ankle.along(upper_angle, m.lower_length / 2), upper_angle);
    give_cylinder(lower_, m.lower_mass, m.segment_radius, m.lower_length);
    toe_ = segment(world, place, toe.along(upper_angle, m.toe_length), upper_angle);
    dMass sphere;
    dMassSetSphereTotal(&sphere, m.toe_mass, m.foot_radius);
    dBodySetMass(toe_, &sphere);

    const vector3 across = place.across();
    hip_ = dJointCreateUniversal(world, nullptr);
    dJointAttach(hip_, trunk, upper_);
    dJointSetUniversalAnchor(hip_, hip[0], hip[1], hip[2]);
    dJointSetUniversalAxis1(hip_, 1, 0, 0);
    dJointSetUniversalAxis2(hip_, across[0], across[1], across[2]);
    knee_ = hinge(world, middle_, upper_, place.at(knee), across);
    dJointSetHingeParam(knee_, dParamLoStop, posture.knee - m.knee_range.high);
    dJointSetHingeParam(knee_, dParamHiStop, posture.knee - m.knee_range.low);
    hinge(world, lower_, middle_, place.at(ankle), across);
    const dJointID toe_joint = hinge(world, toe_, lower_, place.at(toe), across);
    dJointSetHingeParam(toe_joint, dParamLoStop, m.toe_range.low);
    dJointSetHingeParam(toe_joint, dParamHiStop, m.toe_range.high);
    pantograph_ = parallel(world, m, lower_, upper_, across);
  }

  dBodyID upper() const { return upper_; }
  dBodyID middle() const { return middle_; }
  dBodyID lower() const { return lower_; }
  dBodyID toe() const { return toe_; }
  std::array<dBodyID, 4> bodies() const { return {upper_, middle_, lower_, toe_}; }

  // Angles and velocities, from the rotations of the bodies: independent of the posture at the start.
  void read(leg_reading& r) const {
    const dReal* trunk = dBodyGetRotation(trunk_);
    const dReal* upper = dBodyGetRotation(upper_);
    // Relative rotation of trunk and upper segment: abduction about x, then the hip about -y.
    r.hip.angle = std::atan2(-columns(trunk, 0, upper, 2), columns(trunk, 0, upper, 0));
    r.abduction.angle = side_ * std::atan2(columns(trunk, 2, upper, 1), columns(trunk, 1, upper, 1));
    r.knee.angle = angle_between(middle_, upper_);
    r.toe.angle = angle_between(lower_, toe_);

    r.hip.velocity = speed_between(upper_, trunk_);
    r.knee.velocity = speed_between(upper_, middle_);
    r.toe.velocity = speed_between(toe_, lower_);
    const dReal* w = dBodyGetAngularVel(upper_);
    const dReal* v = dBodyGetAngularVel(trunk_);
    r.abduction.velocity =
        side_ * ((w[0] - v[0]) * trunk[0] + (w[1] - v[1]) * trunk[4] + (w[2] - v[2]) * trunk[8]);
  }

  // Applies the torques of springs and motors for this physics step, and notes the motors' in the reading.
  void drive(const oncilla_model& m, leg_motors& motors, leg_reading& r, double dt) const {
    const leg_command& target = motors.target;
    const servo_gains hip{target.hip_stiffness, target.hip_stiffness * m.hip_damping_time};
    r.hip.torque =
        motors.by_law ? limit_torque(m.hip_motor, motors.hip_law(r.hip.angle, r.hip.velocity), r.hip.velocity)
                      : servo_torque(m.hip_motor, hip, target.hip - r.hip.angle,
                                     motors.hip_target_speed - r.hip.velocity, r.hip.velocity);
    twist(upper_, trunk_, column(upper_, 1), -r.hip.torque);

    const servo_gains abduction{m.abduction_stiffness, m.abduction_damping};
    r.abduction.torque = servo_torque(m.abduction_motor, abduction, target.abduction - r.abduction.angle,
                                      -r.abduction.velocity, r.abduction.velocity);
    twist(upper_, trunk_, column(trunk_, 0), side_ * r.abduction.torque);

    if (motors.by_law) {
      const double pull = std::max(0.0, motors.knee_law(r.knee.angle, r.knee.velocity));
      r.knee.torque = limit_torque(m.knee_motor, pull, r.knee.velocity);
      motors.cable = {r.knee.angle, 0, r.knee.velocity, r.knee.torque};
    } else {
      motors.cable.wind(m.knee_motor, dt);
      r.knee.torque = motors.cable.pull(m.knee_motor, {m.cable_stiffness, m.cable_damping}, r.knee.angle,
                                        r.knee.velocity);
    }
    const double flexing =
        r.knee.torque - diagonal_spring_torque(m, r.knee.angle) - m.joint_friction * r.knee.velocity;
    twist(middle_, upper_, column(upper_, 1), flexing);

    r.toe.torque = toe_spring_torque(m, r.toe.angle, r.toe.velocity);
    twist(toe_, lower_, column(lower_, 1), -r.toe.torque);

    // An angular motor in user mode needs its present angle in each step; it holds that at zero.
    dJointSetAMotorAngle(pantograph_, 0, pantograph_error());
  }

  double pantograph_error() const { return angle_between(upper_, lower_); }

private:
  // A point of the leg's plane, and the segments that start in it.
  struct flat_point {
    double x = 0, z = 0;
    flat_point along(double angle, double length) const {
      return {x + length * std::sin(angle), z - length * std::cos(angle)};
    }
  };

  // The leg's plane in the world: through the hip, turned by the abduction about the forward axis.
  struct placement {
    vector3 hip;
    double tilt;
    vector3 at(flat_point p) const {
      return {hip[0] + p.x, hip[1] - p.z * std::sin(tilt), hip[2] + p.z * std::cos(tilt)};
    }
    vector3 across() const { return {0, -std::cos(tilt), -std::sin(tilt)}; }  // positive angles swing forward
  };

  static dBodyID segment(dWorldID world, const placement& place, flat_point centre, double angle) {
    const dBodyID body = dBodyCreate(world);
    dQuaternion tilt, swing, both;
    dQFromAxisAndAngle(tilt, 1, 0, 0, place.tilt);
    dQFromAxisAndAngle(swing, 0, -1, 0, angle);
    dQMultiply0(both, tilt, swing);
    dBodySetQuaternion(body, both);
    const vector3 p = place.at(centre);
    dBodySetPosition(body, p[0], p[1], p[2]);
    return body;
  }

  static void give_cylinder(dBodyID body, double mass, double radius, double length) {
    dMass cylinder;
    dMassSetCylinderTotal(&cylinder, mass, 3, radius, length);
    dBodySetMass(body, &cylinder);
  }

  static dJointID hinge(dWorldID world, dBodyID child, dBodyID parent, vector3 anchor, vector3 axis) {
    const dJointID joint = dJointCreateHinge(world, nullptr);
    dJointAttach(joint, child, parent);
    dJointSetHingeAnchor(joint, anchor[0], anchor[1], anchor[2]);
    dJointSetHingeAxis(joint, axis[0], axis[1], axis[2]);
    return joint;
  }

  static dJointID parallel(
      dWorldID world, const oncilla_model& m, dBodyID child, dBodyID parent, vector3 axis) {
    constexpr int in_first_body = 1;
    const dJointID joint = dJointCreateAMotor(world, nullptr);
    dJointAttach(joint, child, parent);
    dJointSetAMotorMode(joint, dAMotorUser);
    dJointSetAMotorNumAxes(joint, 1);
    dJointSetAMotorAxis(joint, 0, in_first_body, axis[0], axis[1], axis[2]);
    dJointSetAMotorAngle(joint, 0, 0);
    dJointSetAMotorParam(joint, dParamLoStop, 0);
    dJointSetAMotorParam(joint, dParamHiStop, 0);
    dJointSetAMotorParam(joint, dParamStopERP, m.pantograph_erp);
    dJointSetAMotorParam(joint, dParamStopCFM, m.pantograph_cfm);
    return joint;
  }

  // Scalar product of two columns of two rotation matrices: an element of the relative rotation.
  static double columns(const dReal* a, int i, const dReal* b, int j) {
    return a[i] * b[j] + a[4 + i] * b[4 + j] + a[8 + i] * b[8 + j];
  }
  static vector3 column(dBodyID body, int i) {
    const dReal* r = dBodyGetRotation(body);
    return {r[i], r[4 + i], r[8 + i]};
  }

  // The angle from `from` to `to` about the leg's negative y axis: positive if `to` is further forward.
  static double angle_between(dBodyID from, dBodyID to) {
    const dReal* a = dBodyGetRotation(from);
    const dReal* b = dBodyGetRotation(to);
    return std::atan2(-columns(a, 0, b, 2), columns(a, 0, b, 0));
  }

  // The speed at which `body` swings forward relative to `other`, about the y axis of `body`, which must be a
  // segment: all segments of a leg have the same y axis, the trunk has another.
  static double speed_between(dBodyID body, dBodyID other) {
    const dReal* r = dBodyGetRotation(body);
    const dReal* w = dBodyGetAngularVel(body);
    const dReal* v = dBodyGetAngularVel(other);
    return -((w[0] - v[0]) * r[1] + (w[1] - v[1]) * r[5] + (w[2] - v[2]) * r[9]);
  }

  static void twist(dBodyID body, dBodyID other, vector3 axis, double torque) {
    dBodyAddTorque(body, torque * axis[0], torque * axis[1], torque * axis[2]);
    dBodyAddTorque(other, -torque * axis[0], -torque * axis[1], -torque * axis[2]);
  }

  dBodyID trunk_, upper_, middle_, lower_, toe_;
  dJointID hip_, knee_, pantograph_;
  double side_;
};

}  // namespace cca::sim
