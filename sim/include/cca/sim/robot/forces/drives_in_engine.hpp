// The drives of a robot in the engine, and the springs, dampers and dry friction in its joints.
//
// In each physics step each of them is a soft force (soft_force.hpp). Where the step is well within its
// stable range (mobility.hpp) it is explicit: a torque. Else it is a constraint: of the engine, or, in a
// robot with coupled joints, of their projection. Dry friction is always a constraint. So every stiffness,
// damping and step is stable, and what was right already costs nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include <cca/base/math/roots.hpp>
#include <cca/sim/robot/forces/coupled_joints.hpp>
#include <cca/sim/robot/forces/mobility.hpp>
#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/robot/forces/soft_joints.hpp>

namespace cca::sim {

class drives_in_engine {
public:
  // `like`: of this model.
  drives_in_engine(dWorldID world,
                   std::shared_ptr<const robot_model> model,
                   tree_in_engine& tree,
                   double step,
                   const drives_in_engine* like)
      : model_(std::move(model)),
        drives_(model_->drives),
        soft_(world, *model_, tree),
        moves_(like ? like->moves_ : mobility(model_)),
        motors_(model_->drives.size()),
        held_(model_->drives.size(), 0),
        torques_(model_->drives.size(), 0),
        resistances_(moves_.count()),
        turning_(model_->drives.size(), 0),
        forces_(parts * model_->drives.size() + model_->line_springs.size()),
        stiff_(forces_.size(), 0),
        step_(step) {}

  // From now on; one for each coordinate.
  void set(const std::vector<drive_condition>& conditions) {
    for (std::size_t c = 0; c < drives_.size(); ++c)
      drives_[c] = in_condition(model_->drives[c], conditions[c]);
  }

  // A beat begins: which forces are explicit in it. `lines` are the springs as they are.
  template <class Lines>
  void begin(const tree_in_engine& tree, const robot_state& state, const Lines& line_of) {
    const std::size_t n = model_->drives.size();
    for (std::size_t c = 0; c < n; ++c) {
      const robots::joint_drive& d = drives_[c];
      const joint_law& law = state.laws[c];
      const bool by_cable = d.cable.stiffness > 0 && law.stiffness > 0;
      const double motor =
          by_cable ? d.cable.damping + step_ * d.cable.stiffness : law.damping + step_ * law.stiffness;
      forces_[parts * c + in_joint] = {c, d.friction + step_ * d.spring};
      forces_[parts * c + by_motor] = {c, d.motor.torque > 0 ? motor : 0};
      resistances_[c] = forces_[parts * c + in_joint].resistance + forces_[parts * c + by_motor].resistance;
    }
    for (std::size_t i = 0; i < model_->line_springs.size(); ++i) {
      const placed_spring& s = model_->line_springs[i];
      resistances_[n + i] = s.damping + step_ * s.stiffness;
      forces_[parts * n + i] = {n + i, resistances_[n + i]};
    }
    moves_.look_at(tree, resistances_, step_);
    std::fill(turning_.begin(), turning_.end(), 0);
    for (std::size_t i = 0; i < model_->line_springs.size(); ++i) {
      const auto [length, force] = line_of(i);
      if (length > 0) moves_.add_turning(i, length, force, step_, turning_);
    }
    for (std::size_t c = 0; c < n; ++c) forces_[parts * c + by_turning] = {c, turning_[c]};
    moves_.choose(forces_, stiff_, step_);
  }

  bool is_stiff(std::size_t c) const {
    return stiff_[parts * c + in_joint] || stiff_[parts * c + by_motor] || stiff_[parts * c + by_turning] ||
           held_[c];
  }
  bool spring_is_stiff(std::size_t i) const { return stiff_[parts * model_->drives.size() + i] != 0; }

  // Before a step. `share`: of the step in the beat.
  void act(const tree_in_engine& tree, coupled_joints& coupled, robot_state& state, double share) {
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
      if (!tree.leads(i)) continue;
      const auto c = static_cast<std::size_t>(model_->links[i].coordinate);
      const robots::joint_drive& d = drives_[c];
      joint_reading& r = state.joints[c];
      const soft_force motor = force_of_motor(d, state, c);
      double push = 0;
      const bool is_held = motor.low < motor.high && (stiff_[parts * c + by_motor] || runs_out(motor, c));
      held_[c] = is_held ? 1 : 0;
      if (is_held) {
        motors_[c] = motor;
        hold(tree, coupled, i, joint_force::motor, motor);
      } else {
        push = torques_[c] = torque_of_motor(d, state, c);
        r.torque += share * push;
        release(coupled, c, joint_force::motor);
      }
      if (stiff_[parts * c + in_joint] || stiff_[parts * c + by_turning]) {
        soft_force passive = passive_force(d, r.angle);
        if (stiff_[parts * c + by_turning]) passive.damping += turning_[c];
        hold(tree, coupled, i, joint_force::passive, passive);
      } else {
        push = push - d.friction * r.velocity - d.spring * (r.angle - d.spring_rest);
        release(coupled, c, joint_force::passive);
      }
      if (d.dry_friction > 0) hold(tree, coupled, i, joint_force::dry, dry_force(d));
      else release(coupled, c, joint_force::dry);
      tree.push(i, push);
    }
  }

  // After a step: where the joints are, unless their coupling knows it, and the torques and the work of the
  // motors. A motor that winds a cable works at the speed of its pulley.
  void account(const tree_in_engine& tree,
               const coupled_joints& coupled,
               robot_state& state,
               double share) const {
    for (std::size_t i = 0; i < model_->links.size() && !coupled.exist(); ++i) {
      if (tree.is_held_parallel(i)) continue;
      const auto& l = model_->links[i];
      joint_reading& r = state.joints[static_cast<std::size_t>(l.coordinate)];
      const auto now = tree.read(i);
      const double turn = l.kind == joint_kind::revolute ? 2 * std::numbers::pi / l.ratio : 0;
      const double about = r.angle + step_ * now.speed;
      r.angle = turn == 0 ? now.position : now.position + turn * math::round((about - now.position) / turn);
      r.velocity = now.speed;
    }
    for (std::size_t c = 0; c < motors_.size(); ++c) {
      const bool winds = model_->drives[c].cable.stiffness > 0;
      double torque = torques_[c];
      if (held_[c]) {
        torque = motors_[c].after(state.joints[c].velocity, step_);
        state.joints[c].torque += share * torque;
        if (winds) state.winches[c].torque = torque;
      }
      const double work = step_ * torque * (winds ? state.winches[c].speed : state.joints[c].velocity);
      state.positive_work += std::max(0.0, work);
      state.absolute_work += std::abs(work);
    }
  }

  // In the springs of joints, J.
  static double stored(const robot_model& model, const robot_state& state) {
    double sum = 0;
    for (std::size_t c = 0; c < model.drives.size(); ++c) {
      const double stretch = state.joints[c].angle - model.drives[c].spring_rest;
      sum += 0.5 * model.drives[c].spring * stretch * stretch;
    }
    return sum;
  }

private:
  static constexpr std::size_t in_joint = 0, by_motor = 1, by_turning = 2, parts = 3;

  // At the end of a motor's line its torque falls steeply, whatever the law says.
  bool runs_out(const soft_force& f, std::size_t c) const {
    constexpr double shallow = 0.25;
    return f.ends_line && step_ * moves_.of(c) * f.damping > shallow;
  }

  void hold(const tree_in_engine& tree,
            coupled_joints& coupled,
            std::size_t link,
            joint_force which,
            const soft_force& f) {
    const auto c = static_cast<std::size_t>(model_->links[link].coordinate);
    if (coupled.exist()) coupled.set(c, which, f);
    else soft_.set(tree, link, c, which, f, step_);
  }
  void release(coupled_joints& coupled, std::size_t c, joint_force which) {
    if (coupled.exist()) coupled.clear(c, which);
    else soft_.clear(c, which);
  }

  // A law without stiffness pulls a cable with its torque, else the pulley goes to its position.
  soft_force force_of_motor(const robots::joint_drive& d, robot_state& state, std::size_t c) const {
    const joint_law& law = state.laws[c];
    const joint_reading& r = state.joints[c];
    if (d.cable.stiffness > 0 && law.stiffness > 0) {
      state.winches[c].wind(d.motor, step_);
      return cable_force(d.motor, d.cable, state.winches[c], r.angle);
    }
    soft_force f = motor_force(d.motor, law, r.angle, r.velocity, step_, moves_.of(c));
    if (d.cable.stiffness > 0) {
      f.low = std::max(0.0, f.low), f.high = std::max(0.0, f.high);
      state.winches[c].position = r.angle, state.winches[c].speed = r.velocity;
    }
    return f;
  }
  double torque_of_motor(const robots::joint_drive& d, robot_state& state, std::size_t c) const {
    const joint_law& law = state.laws[c];
    const joint_reading& r = state.joints[c];
    if (!(d.cable.stiffness > 0)) return limit_torque(d.motor, law(r.angle, r.velocity), r.velocity);
    cable_winch& winch = state.winches[c];
    if (law.stiffness > 0) return winch.pull(d.motor, d.cable, r.angle, r.velocity);
    return winch.pull_with(d.motor, law(r.angle, r.velocity), r.angle, r.velocity);
  }

  std::shared_ptr<const robot_model> model_;
  std::vector<robots::joint_drive> drives_;  // over the coordinates, in their condition
  soft_joints soft_;
  mobility moves_;
  std::vector<soft_force> motors_;       // over the coordinates: those that are held
  std::vector<char> held_;               // over the coordinates
  std::vector<double> torques_;          // over the coordinates: of the motors in this step, unless held
  std::vector<double> resistances_;      // over coordinates and springs
  std::vector<double> turning_;          // over the coordinates: of lines that turn (mobility.hpp)
  std::vector<mobility::force> forces_;  // the parts of each coordinate, then the springs
  std::vector<char> stiff_;              // over the forces
  double step_;
};

}  // namespace cca::sim
