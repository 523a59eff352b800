// A joint of the engine: a hinge, a slider, or one axis of a universal joint. All count from where they were
// made, positive where the first body turns or moves along the axis.
#pragma once

#include <ode/ode.h>

#include <cca/base/eigen.hpp>

namespace cca::sim {

class engine_joint {
public:
  using vector = Eigen::Vector3d;

  engine_joint() = default;

  static engine_joint hinge(
      dWorldID world, dBodyID first, dBodyID second, const vector& at, const vector& axis) {
    const engine_joint j(dJointCreateHinge(world, nullptr), dJointTypeHinge, first, second);
    dJointSetHingeAnchor(j.id_, at[0], at[1], at[2]);
    dJointSetHingeAxis(j.id_, axis[0], axis[1], axis[2]);
    return j;
  }
  static engine_joint slider(dWorldID world, dBodyID first, dBodyID second, const vector& axis) {
    const engine_joint j(dJointCreateSlider(world, nullptr), dJointTypeSlider, first, second);
    dJointSetSliderAxis(j.id_, axis[0], axis[1], axis[2]);
    return j;
  }
  // Its axis in the first body; other_axis() is the one in the second.
  static engine_joint universal(dWorldID world,
                                dBodyID first,
                                dBodyID second,
                                const vector& at,
                                const vector& in_first,
                                const vector& in_second) {
    const engine_joint j(dJointCreateUniversal(world, nullptr), dJointTypeUniversal, first, second);
    dJointSetUniversalAnchor(j.id_, at[0], at[1], at[2]);
    dJointSetUniversalAxis1(j.id_, in_first[0], in_first[1], in_first[2]);
    dJointSetUniversalAxis2(j.id_, in_second[0], in_second[1], in_second[2]);
    return j;
  }
  engine_joint other_axis() const {
    engine_joint j = *this;
    j.is_second_ = true;
    return j;
  }

  void set(int parameter, double value) const {
    if (kind_ == dJointTypeSlider) dJointSetSliderParam(id_, parameter, value);
    else if (kind_ == dJointTypeHinge) dJointSetHingeParam(id_, parameter, value);
    else dJointSetUniversalParam(id_, parameter + (is_second_ ? dParamGroup2 : 0), value);
  }
  double position() const {
    if (kind_ == dJointTypeSlider) return dJointGetSliderPosition(id_);
    if (kind_ == dJointTypeHinge) return dJointGetHingeAngle(id_);
    return is_second_ ? dJointGetUniversalAngle2(id_) : dJointGetUniversalAngle1(id_);
  }

private:
  engine_joint(dJointID id, dJointType kind, dBodyID first, dBodyID second) : id_(id), kind_(kind) {
    dJointAttach(id, first, second);
  }

  dJointID id_ = nullptr;
  dJointType kind_ = dJointTypeHinge;
  bool is_second_ = false;
};

}  // namespace cca::sim
