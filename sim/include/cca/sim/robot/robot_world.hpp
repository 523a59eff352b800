// A described robot in the Open Dynamics Engine, with what stands around it: laws for its drives in, one beat
// of physics, readings out.
//
//   cca::sim::robot_world w(cca::sim::model_of<cca::robots::arm::description>(), room);
//   w.advance(laws);                      one law for each coordinate (joint_law.hpp)
//   w.joints()[3].angle                   rad; torques are means over the beat
//   w.load(0)                             of the first force sensor, in its frame
//   w.inertial(0).orientation             of the first inertial unit
//
// A world is a value. A copy is a snapshot: original and copy, given the same commands, stay bit-identical.
// `save` and `restore` do the same with a plain value, for worlds of the same model and scene. `pull` and
// `move` change what happens to the robot: a force at the end of a part, a box that moves without notice.
//
// A motor brakes with its full torque and drives with what its line leaves. Springs, friction and motors act
// as explicit torques in each physics step. Coupled joints follow at its end (coupled_joints.hpp). Errors:
// std::invalid_argument when it is made (tree_in_engine.hpp). Cost: docs/robots.md. It allocates nothing
// after the first beats.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/engine.hpp>
#include <cca/sim/robot/coupled_joints.hpp>
#include <cca/sim/robot/inertial_units.hpp>
#include <cca/sim/robot/motor_torque.hpp>
#include <cca/sim/robot/robot_model.hpp>
#include <cca/sim/robot/robot_state.hpp>
#include <cca/sim/robot/scene.hpp>
#include <cca/sim/robot/shapes_in_engine.hpp>
#include <cca/sim/robot/springs_in_engine.hpp>
#include <cca/sim/robot/touching.hpp>
#include <cca/sim/robot/tree_in_engine.hpp>

namespace cca::sim {

struct robot_world_settings {
  engine_settings engine{};
  int steps_per_beat = 2;
  placement mount{};  // of the base, in the world; of a base that floats, at the start
};

class robot_world {
public:
  explicit robot_world(robot_model model, scene around = {}, const robot_world_settings& settings = {})
      : model_(std::make_shared<const robot_model>(std::move(model))),
        scene_(std::make_shared<const scene>(std::move(around))),
        settings_(settings),
        step_(step_of(*model_, settings)),
        engine_(settings.engine),
        tree_(engine_.id(), model_, mount()),
        coupled_(model_, tree_),
        units_(model_, settings.engine.gravity),
        shapes_(engine_.id(), *model_, *scene_, tree_),
        touching_(scene_->contact, step_) {
    touching_.set_pairs(shapes_.pairs());
    state_.pressing.assign(touching_.pair_count(), 0);
    state_.laws.assign(model_->drives.size(), {});
    state_.joints.assign(model_->drives.size(), {});
    state_.loads.assign(model_->sensors.size(), {});
    state_.winches.assign(model_->drives.size(), {});
    state_.inertial.assign(units_.count(), {});
    state_.pulls.assign(model_->ends.size(), {});
    const std::vector<double> rest(model_->drives.size(), 0.0);
    place(model_->start, rest);
  }

  robot_world(const robot_world& other) : robot_world(*other.model_, *other.scene_, other.settings_) {
    restore(other.save());
  }
  robot_world(robot_world&&) = default;
  robot_world& operator=(const robot_world& other) { return *this = robot_world(other); }
  robot_world& operator=(robot_world&& other) noexcept {
    if (this != &other) {
      std::destroy_at(this);
      std::construct_at(this, std::move(other));
    }
    return *this;
  }
  ~robot_world() = default;

  // Puts the robot there: coordinates and speeds, and the motion of a base that floats.
  void place(std::span<const double> q, std::span<const double> dq) {
    place(q, dq, {mount(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  void place(std::span<const double> q, std::span<const double> dq, const moving_frame& base) {
    if (q.size() != state_.joints.size() || dq.size() != q.size())
      throw std::invalid_argument("cca::sim::robot_world: one angle and one speed for each coordinate");
    tree_.place(q, dq, base);
    for (std::size_t c = 0; c < q.size(); ++c) {
      state_.joints[c] = {q[c], dq[c], 0};
      state_.winches[c] = {.position = q[c]};
    }
    units_.begin(tree_);
    units_.read(tree_, state_.inertial);
  }

  // One beat. A law that isn't finite is ignored: the drive keeps the last one.
  void advance(std::span<const joint_law> laws) {
    prepare_engine();
    for (std::size_t c = 0; c < std::min(laws.size(), state_.laws.size()); ++c)
      if (laws[c].is_finite()) state_.laws[c] = laws[c];
    for (std::size_t c = 0; c < state_.winches.size(); ++c)
      state_.winches[c].aim(state_.laws[c].position, model_->beat);
    units_.begin(tree_);
    for (joint_reading& r : state_.joints) r.torque = 0;
    for (auto& load : state_.loads) load.fill(0);
    for (int i = 0; i < settings_.steps_per_beat; ++i) step();
    units_.read(tree_, state_.inertial);
    ++state_.beats;
  }

  // A force and a torque at the end of a part (in order of declaration), along the world's axes, until they
  // are set again.
  void pull(std::size_t part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      if (std::isfinite(force[i])) state_.pulls.at(part).force[k] = force[i];
      if (std::isfinite(torque[i])) state_.pulls.at(part).torque[k] = torque[i];
    }
  }

  // Puts a box of the scene elsewhere.
  void move(std::size_t box, const placement& where) { shapes_.put_box(box, where); }

  const std::vector<joint_reading>& joints() const { return state_.joints; }
  // The torque about the sensor's origin, then the force of the world, along the sensor's axes.
  const std::array<double, 6>& load(std::size_t sensor) const { return state_.loads.at(sensor); }

  const inertial_reading& inertial(std::size_t unit) const { return state_.inertial.at(unit); }

  // The true state, which no sensor of the robot measures; in the world.
  moving_frame frame(int link) const { return tree_.frame(link); }
  moving_frame end(std::size_t part) const { return tree_.at(model_->ends.at(part)); }
  Eigen::Vector3d ball_position(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetPosition(shapes_.balls().at(i)));
  }
  Eigen::Vector3d ball_velocity(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetLinearVel(shapes_.balls().at(i)));
  }
  // Of the robot alone, J: kinetic, and potential from the height of the world's origin.
  double energy() const {
    double sum = 0;
    for (const dBodyID b : tree_.links()) sum += energy_of(b);
    return tree_.base() ? sum + energy_of(tree_.base()) : sum;
  }
  // In springs and cables between points and in the springs of joints, J.
  double spring_energy() const {
    double sum = springs_in_engine::stored(*model_, tree_);
    for (std::size_t c = 0; c < model_->drives.size(); ++c) {
      const double stretch = state_.joints[c].angle - model_->drives[c].spring_rest;
      sum += 0.5 * model_->drives[c].spring * stretch * stretch;
    }
    return sum;
  }
  // The force of a spring or cable (in order of declaration), N; negative: it pushes.
  double tension(std::size_t spring) const {
    return springs_in_engine::tension(model_->line_springs.at(spring), tree_);
  }
  double time() const { return static_cast<double>(state_.beats) * model_->beat; }

  const robot_model& model() const { return *model_; }
  const scene& around() const { return *scene_; }

  robot_state save() const {
    robot_state s = state_;
    each_body([&](dBodyID b) { s.bodies.push_back(save_body(b)); });
    s.boxes = shapes_.box_places();
    return s;
  }
  void restore(const robot_state& s) {
    state_ = s;
    state_.bodies.clear();
    state_.boxes.clear();
    std::size_t i = 0;
    each_body([&](dBodyID b) { restore_body(b, s.bodies.at(i++)); });
    shapes_.restore_boxes(s.boxes);
  }
  std::uint64_t hash() const { return save().hash(); }

private:
  static double step_of(const robot_model& m, const robot_world_settings& s) {
    const double step = m.beat / s.steps_per_beat;
    if (!(step > 0 && std::isfinite(step)))
      throw std::invalid_argument("cca::sim::robot_world: a beat has at least one physics step, above 0 s");
    return step;
  }
  rigid mount() const { return rigid{} * settings_.mount; }

  template <class F>
  void each_body(F f) const {
    if (tree_.base()) f(tree_.base());
    for (const dBodyID b : tree_.links()) f(b);
    for (const dBodyID b : shapes_.balls()) f(b);
  }

  void step() {
    const double share = 1.0 / settings_.steps_per_beat;
    tree_.hold_parallel();
    if (coupled_.exist()) coupled_.begin(tree_);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
      if (!tree_.leads(i)) continue;
      const auto c = static_cast<std::size_t>(model_->links[i].coordinate);
      const robots::joint_drive& d = model_->drives[c];
      joint_reading& r = state_.joints[c];
      const double motor = d.cable.stiffness > 0
                               ? pull_of_cable(c)
                               : limit_torque(d.motor, state_.laws[c](r.angle, r.velocity), r.velocity);
      r.torque += share * motor;
      tree_.push(i, motor - d.friction * r.velocity - d.spring * (r.angle - d.spring_rest));
    }
    springs_in_engine::act(*model_, tree_);
    for (std::size_t part = 0; part < state_.pulls.size(); ++part) pull_at(part);
    touching_.find(engine_, state_.pressing);
    engine_.step(step_);
    touching_.account(state_.pressing, [&](const touch& t) { feel(t, share); });
    dJointGroupEmpty(engine_.contacts());
    if (coupled_.exist()) return coupled_.end(tree_, state_.joints, step_);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
      if (tree_.is_held_parallel(i)) continue;
      const auto& l = model_->links[i];
      joint_reading& r = state_.joints[static_cast<std::size_t>(l.coordinate)];
      const auto now = tree_.read(i);
      const double turn = l.kind == joint_kind::revolute ? 2 * std::numbers::pi / l.ratio : 0;
      r.angle = turn == 0 ? now.position : now.position + turn * std::round((r.angle - now.position) / turn);
      r.velocity = now.speed;
    }
  }

  // A law without stiffness pulls with its torque, else the pulley goes to its position.
  double pull_of_cable(std::size_t c) {
    const robots::joint_drive& d = model_->drives[c];
    const joint_law& law = state_.laws[c];
    const joint_reading& r = state_.joints[c];
    cable_winch& winch = state_.winches[c];
    if (law.stiffness > 0) {
      winch.wind(d.motor, step_);
      return winch.pull(d.motor, d.cable, r.angle, r.velocity);
    }
    return winch.pull_with(d.motor, law(r.angle, r.velocity), r.angle, r.velocity);
  }

  void pull_at(std::size_t part) const {
    const dBodyID b = tree_.body_of(model_->ends[part].link);
    if (!b) return;
    const auto& [f, t] = state_.pulls[part];
    if (f == std::array<double, 3>{} && t == f) return;
    const Eigen::Vector3d at = end(part).where.at;
    dBodyAddForceAtPos(b, f[0], f[1], f[2], at[0], at[1], at[2]);
    dBodyAddTorque(b, t[0], t[1], t[2]);
  }

  // At the place where the sensor was when the contact was found, up to one physics step.
  void feel(const touch& t, double share) {
    const int sensor = model_->shapes[t.shape].sensor;
    if (sensor < 0) return;
    const rigid f = tree_.at(model_->sensors[static_cast<std::size_t>(sensor)]).where;
    const Eigen::Vector3d torque = f.turn.transpose() * cca::detail::cross(t.at - f.at, t.force),
                          force = f.turn.transpose() * t.force;
    auto& load = state_.loads[static_cast<std::size_t>(sensor)];
    for (std::size_t k = 0; k < 3; ++k) {
      load[k] += share * torque[static_cast<Eigen::Index>(k)];
      load[3 + k] += share * force[static_cast<Eigen::Index>(k)];
    }
  }

  double energy_of(dBodyID b) const {
    dMass m;
    dBodyGetMass(b, &m);
    const auto turn = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(dBodyGetRotation(b));
    const Eigen::Vector3d v = Eigen::Vector3d::Map(dBodyGetLinearVel(b)),
                          w = turn.leftCols<3>().transpose() * Eigen::Vector3d::Map(dBodyGetAngularVel(b));
    const auto inertia = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.I);
    return 0.5 * (m.mass * v.squaredNorm() + w.dot(inertia.leftCols<3>() * w)) +
           m.mass * settings_.engine.gravity * dBodyGetPosition(b)[2];
  }

  std::shared_ptr<const robot_model> model_;
  std::shared_ptr<const scene> scene_;
  robot_world_settings settings_;
  double step_;
  engine engine_;
  tree_in_engine tree_;
  coupled_joints coupled_;
  inertial_units units_;
  shapes_in_engine shapes_;
  touching touching_;
  robot_state state_;
};

}  // namespace cca::sim
