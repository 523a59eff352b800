// The inside of a robot's world (robot_world.hpp): the bodies, joints and contacts in the Open Dynamics
// Engine, and one beat of physics. It knows nothing of the types of a program, so it can be compiled once
// (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include <cca/base/math/reductions.hpp>
#include <cca/sim/engine/checked_scene.hpp>
#include <cca/sim/engine/engine.hpp>
#include <cca/sim/engine/refused_number.hpp>
#include <cca/sim/robot/model/checked_settings.hpp>
#include <cca/sim/robot/forces/drives_in_engine.hpp>
#include <cca/sim/robot/forces/gyroscopic.hpp>
#include <cca/sim/robot/world/inertial_units.hpp>
#include <cca/sim/robot/world/judgement.hpp>
#include <cca/sim/robot/forces/outer_forces.hpp>
#include <cca/sim/robot/model/push.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/robot/model/robot_state.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>
#include <cca/sim/engine/scene.hpp>
#include <cca/sim/robot/tree/shapes_in_engine.hpp>
#include <cca/sim/robot/forces/springs_in_engine.hpp>
#include <cca/sim/robot/forces/stops_in_engine.hpp>
#include <cca/sim/engine/touching.hpp>

namespace cca::sim {

class world_in_engine {
public:
  // Throws std::invalid_argument for what can't be, also for what only the engine finds.
  static std::unique_ptr<world_in_engine> made(robot_model model,
                                               scene around,
                                               const robot_world_settings& settings) {
    check(settings);
    for (std::size_t i = 0; i < model.shapes.size(); ++i)
      need_place(model.shapes[i].where, "shape " + std::to_string(i) + " of the robot");
    prepare_engine();
    const engine_alarms_thrown here;
    try {
      return std::unique_ptr<world_in_engine>(new world_in_engine(
          std::make_shared<const robot_model>(varied(checked(std::move(model)), settings.body)),
          std::make_shared<const scene>(checked(std::move(around))), settings, nullptr));
    } catch (const engine_alarm& alarm) {
      throw std::invalid_argument(
          std::string("cca::sim: the physics engine can't make a world of these numbers: ") +
          alarm.text.data());
    }
  }

  world_in_engine(const world_in_engine& other)
      : world_in_engine(other.model_, other.scene_, other.settings_, &other.drives_) {
    restore(other.save());
  }
  world_in_engine& operator=(const world_in_engine&) = delete;

  void place(std::span<const double> q, std::span<const double> dq) {
    place(q, dq, {mount(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  void place(std::span<const double> q, std::span<const double> dq, const moving_frame& base) {
    if (q.size() != state_.joints.size() || dq.size() != q.size())
      throw std::invalid_argument("cca::sim::robot_world: one angle and one speed for each coordinate");
    double sum = sum_of(base);
    for (std::size_t c = 0; c < q.size(); ++c) sum += q[c] + dq[c];
    if (!std::isfinite(sum)) throw std::invalid_argument("cca::sim::robot_world: a place is not finite");
    tree_.place(q, dq, base);
    for (std::size_t c = 0; c < q.size(); ++c) {
      state_.joints[c] = {q[c], dq[c], 0};
      state_.winches[c] = {.position = q[c]};
    }
    units_.begin(tree_);
    units_.read(tree_, state_.inertial);
    state_.trouble = {};
    look(settings_.plausible);
  }

  void advance(std::span<const joint_law> laws) {
    prepare_engine();
    if (state_.trouble) return;
    if (!engine_.guarded([&] { beat(laws); })) state_.trouble = {implausible::engine};
    ++state_.beats;
  }

  void set_condition(std::span<const drive_condition> now) {
    take_possible(now, state_.conditions);
    drives_.set(state_.conditions);
  }

  void pull(std::size_t part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque) {
    outer_load& kept = state_.pulls[numbered(part, state_.pulls.size(), "part")];
    take_finite(kept.force, force);
    take_finite(kept.torque, torque);
  }
  void push(const Eigen::Vector3d& force) { take_finite(state_.push, force); }
  void follow(const push_plan& plan) {
    const std::array<double, 3> now = plan.force_at(static_cast<double>(state_.beats) * model_->beat);
    if (now != state_.planned) push({now[0], now[1], now[2]});
    state_.planned = now;
  }
  void move(std::size_t box, const placement& where) {
    numbered(box, scene_->boxes.size(), "box");
    if (!is_place(where)) need_place(where, "box " + std::to_string(box) + " of the scene");
    shapes_.put_box(box, where);
  }

  moving_frame frame(int link) const {
    if (link >= 0) numbered(static_cast<std::size_t>(link), model_->links.size(), "link");
    return tree_.frame(link);
  }
  moving_frame end(std::size_t part) const {
    return tree_.at(model_->ends[numbered(part, model_->ends.size(), "part")]);
  }
  Eigen::Vector3d ball_position(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetPosition(ball_body(i)));
  }
  Eigen::Vector3d ball_velocity(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetLinearVel(ball_body(i)));
  }
  double mass() const { return sum_of_links(0.0, &mass_of); }
  Eigen::Vector3d centre_of_mass() const {
    return sum_of_links(Eigen::Vector3d(0, 0, 0), &moment_of) / mass();
  }

  double energy() const {
    return sum_of_links(
        0.0, [&](dBodyID b) { return kinetic_energy(b) + potential_energy(b, settings_.engine.gravity); });
  }
  double spring_energy() const {
    return springs_in_engine::stored(*model_, tree_) + drives_in_engine::stored(*model_, state_);
  }
  double tension(std::size_t spring) const {
    return springs_in_engine::tension(
        model_->line_springs[numbered(spring, model_->line_springs.size(), "spring")], tree_);
  }

  const robot_state& state() const { return state_; }
  const robot_model& model() const { return *model_; }
  const scene& around() const { return *scene_; }
  const robot_world_settings& settings() const { return settings_; }

  robot_state save() const {
    robot_state s = state_;
    each_body([&](dBodyID b) { s.bodies.push_back(save_body(b)); });
    s.boxes = shapes_.box_places();
    return s;
  }
  void restore(const robot_state& s) {
    state_ = s;
    drives_.set(state_.conditions);
    state_.bodies.clear();
    state_.boxes.clear();
    std::size_t i = 0;
    each_body([&](dBodyID b) { restore_body(b, s.bodies.at(i++)); });
    shapes_.restore_boxes(s.boxes);
  }

private:
  world_in_engine(std::shared_ptr<const robot_model> model,
                  std::shared_ptr<const scene> around,
                  const robot_world_settings& settings,
                  const drives_in_engine* like)
      : model_(std::move(model)),
        scene_(std::move(around)),
        settings_(settings),
        step_(step_of(*model_, settings)),
        engine_(settings.engine),
        tree_(engine_.id(), model_, mount()),
        coupled_(model_, tree_),
        units_(model_, settings.engine.gravity),
        shapes_(engine_.id(), *model_, *scene_, tree_),
        touching_(scene_->contact, step_),
        drives_(engine_.id(), model_, tree_, step_, like),
        stops_(*model_, tree_, settings.engine.erp) {
    touching_.set_pairs(shapes_.pairs());
    state_.pressing.assign(touching_.pair_count(), 0);
    state_.laws.assign(model_->drives.size(), {});
    state_.conditions.assign(model_->drives.size(), {});
    state_.joints.assign(model_->drives.size(), {});
    state_.loads.assign(model_->sensors.size(), {});
    state_.winches.assign(model_->drives.size(), {});
    state_.inertial.assign(units_.count(), {});
    state_.pulls.assign(model_->ends.size(), {});
    state_.contacts.assign(model_->shapes.size(), {});
    state_.end_forces.assign(model_->ends.size(), {});
    const std::vector<double> rest(model_->drives.size(), 0.0);
    place(model_->start, rest);
  }

  static double step_of(const robot_model& m, const robot_world_settings& s) {
    const double step = m.beat / s.steps_per_beat;
    if (!(step > 0 && std::isfinite(step)))
      throw std::invalid_argument("cca::sim::robot_world: a beat has at least one physics step, above 0 s");
    return step;
  }
  dBodyID ball_body(std::size_t i) const {
    return shapes_.balls()[numbered(i, shapes_.balls().size(), "ball")];
  }
  rigid mount() const { return rigid{} * settings_.mount; }

  // The base, if it floats; the links.
  template <class F>
  void each_link(F f) const {
    if (tree_.base()) f(tree_.base());
    for (const dBodyID b : tree_.links())
      if (b) f(b);  // none where joints cross
  }
  template <class Sum, class F>
  Sum sum_of_links(Sum sum, F f) const {
    each_link([&](dBodyID b) { sum += f(b); });
    return sum;
  }
  template <class F>
  void each_body(F f) const {
    each_link(f);
    for (const dBodyID b : shapes_.balls()) f(b);
  }

  void beat(std::span<const joint_law> laws) {
    for (std::size_t c = 0; c < std::min(laws.size(), state_.laws.size()); ++c)
      if (laws[c].is_finite()) state_.laws[c] = laws[c];
    for (std::size_t c = 0; c < state_.winches.size(); ++c)
      state_.winches[c].aim(state_.laws[c].position, model_->beat);
    drives_.begin(tree_, state_, [this](std::size_t i) {
      return springs_in_engine::length_and_tension(model_->line_springs[i], tree_);
    });
    units_.begin(tree_);
    for (joint_reading& r : state_.joints) r.torque = 0;
    for (auto& load : state_.loads) load.fill(0);
    for (auto& force : state_.end_forces) force.fill(0);
    for (int i = 0; i < settings_.steps_per_beat && !state_.trouble; ++i) step();
    if (!state_.trouble) units_.read(tree_, state_.inertial);
  }

  void step() {
    const double share = 1.0 / settings_.steps_per_beat;
    state_.parallel_error = std::max(state_.parallel_error, tree_.hold_parallel());
    if (coupled_.exist()) coupled_.begin(tree_);
    drives_.act(tree_, coupled_, state_, share);
    if (!coupled_.exist())
      stops_.act(*model_, tree_, state_.joints, step_, [&](std::size_t c) { return drives_.is_stiff(c); });
    springs_in_engine::act(engine_, *model_, tree_, drives_, coupled_, step_);
    each_link([&](dBodyID b) { turn_freely(b, step_); });
    pull_at_ends(*model_, tree_, state_.pulls);
    push_base(tree_, state_.push);
    touching_.find(engine_, state_.pressing);
    if (!engine_.step(step_)) state_.trouble = {implausible::engine};
    // With coupled joints the engine's step is half of one: only its numbers must be right.
    if (!state_.trouble) look(coupled_.exist() ? plausible_bounds::none() : settings_.plausible);
    if (state_.trouble) return;
    for (contact_account& c : state_.contacts) c.begin_step();
    touching_.account(state_.pressing, [&](const touch& t) {
      feel(*model_, tree_, t, share, state_);
      state_.contacts[t.shape].add(t, step_);
      if (t.second_shape < 0) return;
      const auto second = static_cast<std::size_t>(t.second_shape);
      feel(*model_, tree_, touch{second, t.at, -t.force, -t.normal, -t.slip}, share, state_);
      state_.contacts[second].add(std::max(0.0, math::dot(t.force, t.normal)), math::norm(t.slip), 0, step_);
    });
    dJointGroupEmpty(engine_.contacts());
    if (coupled_.exist()) {
      if (!coupled_.end(tree_, state_.joints, step_)) state_.trouble = {implausible::engine};
      else look(settings_.plausible);
      if (state_.trouble) return;
    }
    drives_.account(tree_, coupled_, state_, share);
    state_.trouble = look_at_stops(*model_, tree_, state_.joints, settings_.plausible);
  }

  void look(const plausible_bounds& bounds) {
    state_.trouble = look_at_bodies(tree_, shapes_.balls(), bounds, step_);
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
  drives_in_engine drives_;
  stops_in_engine stops_;
  robot_state state_;
};

}  // namespace cca::sim
